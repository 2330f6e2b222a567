"""Work against precision of three integrators over the catalogue: python3 work_precision.py toytop FOLDER PICTURE.svg [NAME ...]

SciPy's DOP853, heyoka's Taylor integrator and the Lie-group method of this folder run every problem at several tolerances or
steps, and `toytop score` judges each run. Work is the number of evaluations of the equations; a step of heyoka counts as one for each order of
its series.
"""
import json, math, pathlib, subprocess, sys

HERE = pathlib.Path(__file__).resolve().parent
PROBLEMS = HERE.parent / "problems"
METHODS = {"SciPy DOP853": ("scipy_dop853.py", "#1f77b4"), "heyoka": ("heyoka_taylor.py", "#d62728"), "Lie group": ("lie_group.py", "#2ca02c")}


def problems():
    """Name and length in seconds of each problem: its last time."""
    for file in sorted(PROBLEMS.glob("*/reference.json")):
        yield file.parent.name, float(json.loads(file.read_text())["samples"][-1]["t"])


def points(program, name, seconds, folder):
    """Work and greatest error of each run, by method."""
    folder.mkdir(parents=True, exist_ok=True)
    scenario = PROBLEMS / name / "scenario.toml"
    for script, _ in METHODS.values():
        subprocess.check_call([sys.executable, str(HERE / script), program, str(scenario), str(seconds), str(folder)])
    files = sorted(map(str, folder.glob("*.csv")))
    scores = json.loads(subprocess.check_output([program, "score", str(scenario), *files, "--format", "json"]))["files"]
    found = {method: [] for method in METHODS}
    for score in scores:
        found[score["method"]].append((score["evaluations"], score["max_error_rad"]))
    return {method: sorted(runs) for method, runs in found.items()}


def picture(panels):
    """One small chart a problem, in rows of three, with common axes."""
    wide, high, edge, across = 300, 230, 46, 3
    every = [point for runs in panels.values() for method in runs.values() for point in method]
    log = lambda x: math.log10(max(x, 1e-16))
    low, far = int(min(log(w) for w, _ in every)), int(max(log(w) for w, _ in every)) + 1
    bottom, top = int(min(log(e) for _, e in every)) - 1, 1
    place = lambda w, e: (edge + (log(w) - low) / (far - low) * (wide - edge - 10),
                          24 + (top - log(e)) / (top - bottom) * (high - 24 - 30))
    rows = -(-len(panels) // across)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{across * wide}" height="{rows * high + 40}" font-family="sans-serif" font-size="11">',
           '<rect width="100%" height="100%" fill="white"/>']
    for index, (name, runs) in enumerate(panels.items()):
        out.append(f'<g transform="translate({index % across * wide},{index // across * high})"><text x="{edge}" y="16" font-size="13">{name}</text>')
        for power in range(low, far + 1):
            x, _ = place(10.0 ** power, 1)
            out.append(f'<path d="M{x:.1f} 24V{high - 30}" stroke="#ddd"/><text x="{x:.1f}" y="{high - 16}" text-anchor="middle">1e{power}</text>')
        for power in range(bottom, top + 1, 3):
            _, y = place(1, 10.0 ** power)
            out.append(f'<path d="M{edge} {y:.1f}H{wide - 10}" stroke="#ddd"/><text x="{edge - 4}" y="{y + 4:.1f}" text-anchor="end">1e{power}</text>')
        for method, found in runs.items():
            colour = METHODS[method][1]
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*point) for point in found))
            out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
            out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>' for x, y in (place(*point) for point in found)]
        out.append("</g>")
    for index, (method, (_, colour)) in enumerate(METHODS.items()):
        x = edge + 150 * index
        out.append(f'<circle cx="{x}" cy="{rows * high + 16}" r="4" fill="{colour}"/><text x="{x + 8}" y="{rows * high + 20}">{method}</text>')
    out.append(f'<text x="{edge}" y="{rows * high + 36}">greatest error of the orientation, rad, against evaluations of the equations</text></svg>')
    return "\n".join(out) + "\n"


program, folder, target, *chosen = sys.argv[1:]
panels = {}
for name, seconds in problems():
    if not chosen or name in chosen:
        panels[name] = points(program, name, seconds, pathlib.Path(folder) / name)
        for method, runs in panels[name].items():
            print(f"{name:18} {method:14}", "  ".join(f"{int(w):>8} {e:.1e}" for w, e in runs), flush=True)
pathlib.Path(target).write_text(picture(panels))

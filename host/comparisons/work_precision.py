"""Work against precision of three integrators over the catalogue: python3 work_precision.py toytop FOLDER [NAME ...]

SciPy's DOP853, heyoka's Taylor integrator and the Lie-group method of this folder run every problem at several tolerances or
steps, and `toytop score` judges the runs and draws FOLDER/NAME.svg. Work is the number of evaluations of the equations; a step of heyoka
counts as one for each order of its series.
"""
import json, pathlib, subprocess, sys, tempfile

HERE = pathlib.Path(__file__).resolve().parent
PROBLEMS = HERE.parent / "problems"

program, folder, *chosen = sys.argv[1:]
for file in sorted(PROBLEMS.glob("*/reference.json")):
    name, seconds = file.parent.name, json.loads(file.read_text())["samples"][-1]["t"]
    if chosen and name not in chosen:
        continue
    scenario = str(file.with_name("scenario.toml"))
    with tempfile.TemporaryDirectory() as runs:
        for script in ("scipy_dop853.py", "heyoka_taylor.py", "lie_group.py"):
            subprocess.check_call([sys.executable, str(HERE / script), program, scenario, str(seconds), runs])
        files = sorted(map(str, pathlib.Path(runs).glob("*.csv")))
        print(name, flush=True)
        subprocess.check_call([program, "score", scenario, *files, "--plot", str(pathlib.Path(folder) / f"{name}.svg")])

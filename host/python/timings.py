"""Computing times of the package on this machine: python timings.py [--json]

Times are the best of several, in processor time unless they say otherwise; heyoka and SciPy are compared where they are installed.
"""

import argparse
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import toytop

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "tests"))
import equations  # noqa: E402

TOP = toytop.Top.sliding(
    mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5, gravity=9.81
)
MOTION = TOP.release(tilt=0.35, spin=150.0)


def best(run: Callable[[], object], repeats: int = 7, clock: Callable[[], float] = time.process_time) -> float:
    """Least time of a call, s; a call that is shorter than 50 ms is repeated until it is not."""
    run()
    calls, least = 1, np.inf
    while True:
        start = clock()
        for _ in range(calls):
            run()
        if clock() - start > 0.05:
            break
        calls *= 2
    for _ in range(repeats):
        start = clock()
        for _ in range(calls):
            run()
        least = min(least, (clock() - start) / calls)
    return least


def import_time() -> float:
    program = "import time; t = time.perf_counter(); import toytop; print(time.perf_counter() - t)"
    return min(float(subprocess.check_output([sys.executable, "-c", program])) for _ in range(5))


def orientations(scalar: Any, count: int) -> float:
    times = np.linspace(0.0, 10.0, count)
    return count / best(lambda: MOTION.at(times, scalar=scalar).quaternion)


def sweep(count: int) -> dict[str, float]:
    random = np.random.default_rng(1)
    releases = {"tilt": random.uniform(0.1, 1.0, count), "spin": random.uniform(100.0, 300.0, count)}
    times = np.linspace(0.0, 1.0, 16)
    wall, processor = time.perf_counter(), time.process_time()
    samples = toytop.many(TOP, releases).at(times)
    assert samples.quaternion.shape == (count, 16, 4)
    return {"wall": time.perf_counter() - wall, "processor": time.process_time() - processor}


def integrators() -> list[tuple[str, float, float, int]]:
    """Name, time of a second of motion in s, and greatest error in rad, of general integrators beside the package."""
    times = np.linspace(0.0, 1.0, 257)
    exact = MOTION.at(times).quaternion

    def error(states: Any) -> float:
        return float(2.0 * np.linalg.norm(np.asarray(states)[:, :4] - exact, axis=1).max())

    truth = MOTION.reference(times).quaternion
    rows = [("toytop", best(lambda: MOTION.at(times).quaternion), error(truth), len(times))]
    try:
        import scipy.integrate  # noqa: F401, PLC0415: importing it is no work of the first tolerance

        for tolerance in (1e-6, 1e-9, 1e-12):
            start = time.process_time()
            states = equations.integrate(MOTION, times, method="DOP853", rtol=tolerance, atol=1e-3 * tolerance)
            rows.append((f"SciPy DOP853, rtol {tolerance:.0e}", time.process_time() - start, error(states), len(times)))
    except ImportError:
        pass
    try:
        import heyoka
    except ImportError:
        return rows
    for tolerance in (1e-9, 1e-12, 2.3e-16):
        integrator = heyoka.taylor_adaptive(heyoka_equations(heyoka), scaled_start(), tol=tolerance)

        def run() -> Any:
            integrator.time, integrator.state[:] = 0.0, scaled_start()
            return integrator.propagate_grid(times)[-1]

        rows.append((f"heyoka, tolerance {tolerance:.0e}", best(run, 3), error(run()), len(times)))
    return rows


def scaled_start() -> Any:
    """State with the momentum in units of A, which keeps heyoka's absolute tolerance meaningful."""
    state = equations.start(MOTION)
    state[4:] /= TOP.transverse_inertia
    return state


def heyoka_equations(hy: Any) -> Any:
    """Equations of tests/equations.py with the momentum in units of A."""
    symbols = np.array(hy.make_vars("w", "x", "y", "z", "m1", "m2", "m3"))
    units = np.array([1.0] * 4 + [TOP.transverse_inertia] * 3)
    slopes = equations.slope(TOP)(0.0, units * symbols) / units
    # heyoka takes no number as an equation, and the third momentum is constant
    return [(symbol, slope + 0.0 * symbol) for symbol, slope in zip(symbols, slopes, strict=True)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true", help="one JSON object")
    parser.add_argument("--motions", type=int, default=100_000, help="motions of the sweep")
    arguments = parser.parse_args()
    times = np.linspace(0.0, 10.0, 100_000)
    swept = sweep(arguments.motions)
    figures: dict[str, tuple[float, str]] = {
        "import toytop, without numpy": (1e3 * import_time(), "ms of wall time"),
        "launch": (1e6 * best(lambda: TOP.release(tilt=0.35, spin=150.0)), "µs"),
        "launch and table": (1e6 * best(lambda: TOP.release(tilt=0.35, spin=150.0).at(0.0).u), "µs"),
        "motion.at(0.5)": (1e6 * best(lambda: MOTION.at(0.5)), "µs"),
        "motion.at(0.5).quaternion": (1e6 * best(lambda: MOTION.at(0.5).quaternion), "µs"),
        "orientations, f64": (1e-6 * orientations("f64", 100_000), "million a second and core"),
        "orientations, f64, of a million": (1e-6 * orientations("f64", 1_000_000), "million a second and core"),
        "orientations, f32": (1e-6 * orientations("f32", 100_000), "million a second and core"),
        "angular velocities, f64": (0.1 / best(lambda: MOTION.at(times).omega), "million a second and core"),
        f"{arguments.motions} motions at 16 times": (swept["wall"], f"s of wall time on {os.cpu_count()} cores"),
        "the same, processor time of all cores": (swept["processor"], "s"),
    }
    rows = integrators()
    if arguments.json:
        keys = ("name", "seconds", "error_rad", "samples")
        rows_of = [dict(zip(keys, row, strict=True)) for row in rows]
        print(json.dumps({"figures": figures, "integrators": rows_of}))
        return
    for name, (number, unit) in figures.items():
        print(f"{name:40}{number:10.3g} {unit}")
    print("\nOne second of motion (13 nutation periods), 257 orientations")
    for name, seconds, error, _ in rows:
        print(f"{name:40}{1e3 * seconds:10.3g} ms   greatest error {error:.1e} rad")


if __name__ == "__main__":
    main()

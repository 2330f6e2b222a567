"""Computing times of the package on this machine: python timings.py [--json]

Times are the best of several, in processor time unless they say otherwise.
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
    if arguments.json:
        print(json.dumps({"figures": figures}))
        return
    for name, (number, unit) in figures.items():
        print(f"{name:40}{number:10.3g} {unit}")


if __name__ == "__main__":
    main()

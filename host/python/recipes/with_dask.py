"""Sweep with Dask: each part computes its launches by their number, one part after the other."""

import dask
import numpy as np

import toytop

TOP = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)


@dask.delayed
def part(top: toytop.Top, seed: int, count: int) -> toytop.Samples:
    random = np.random.default_rng(seed)
    releases = {"tilt": random.uniform(0.1, 1.0, count), "spin": random.uniform(100.0, 300.0, count)}
    return toytop.many(top, releases).at(np.linspace(0.0, 1.0, 16))


def sweep(count: int, parts: int = 4) -> np.ndarray:
    tasks = [part(TOP, seed, count // parts) for seed in range(parts)]
    # a part uses all cores of the machine
    return np.concatenate([samples.u for samples in dask.compute(*tasks, scheduler="single-threaded")])


if __name__ == "__main__":
    print(sweep(10_000).shape)

"""Sweep with Ray: a task for each part, which returns arrays."""

import numpy as np
import ray

import toytop

TOP = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)


@ray.remote
def part(top: toytop.Top, seed: int, count: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    releases = {"tilt": random.uniform(0.1, 1.0, count), "spin": random.uniform(100.0, 300.0, count)}
    return toytop.many(top, releases).at(np.linspace(0.0, 1.0, 16)).u


def sweep(count: int, parts: int = 4) -> np.ndarray:
    return np.concatenate(ray.get([part.remote(TOP, seed, count // parts) for seed in range(parts)]))


if __name__ == "__main__":
    print(sweep(10_000).shape)

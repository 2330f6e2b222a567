"""Sweep with polars: releases are columns of a data frame, and so are the results."""

import numpy as np
import polars as pl

import toytop


def sweep(count: int) -> pl.DataFrame:
    random = np.random.default_rng(1)
    releases = pl.DataFrame({"tilt": random.uniform(0.1, 1.0, count), "spin": random.uniform(100.0, 300.0, count)})
    top = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)
    many = toytop.many(top, releases)
    samples = pl.DataFrame(many.at(np.linspace(0.0, 1.0, 16)).columns())
    least = samples.group_by("motion", maintain_order=True).agg(pl.col("u").min().alias("least_u"))
    return releases.with_columns(least["least_u"], pl.Series("period", many.constant("period")))


if __name__ == "__main__":
    print(sweep(10_000))

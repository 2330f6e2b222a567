"""The recipes of the folder recipes, on ten thousand launches."""

import importlib.util
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import toytop

RECIPES = Path(__file__).parents[1] / "recipes"


def swept(library: str) -> Any:
    pytest.importorskip(library, reason=f"{library} is not installed")
    path = RECIPES / f"with_{library}.py"
    assert len(path.read_text().splitlines()) <= 25
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None and spec.loader is not None
    recipe = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(recipe)
    return recipe.sweep(10_000)


def test_polars(top: toytop.Top) -> None:
    frame = swept("polars")
    assert frame.shape == (10_000, 4)
    tilt, spin, least, period = frame.row(4321)
    motion = toytop.Top.sliding(
        mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5
    ).release(tilt=tilt, spin=spin)
    assert least == motion.at(np.linspace(0.0, 1.0, 16)).u.min() and period == motion.period


def test_dask() -> None:
    assert swept("dask").shape == (10_000, 16)


def test_ray() -> None:
    ray: Any = pytest.importorskip("ray", reason="ray is not installed")
    try:
        ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    except Exception as error:
        pytest.skip(f"no Ray can be started here: {error}")
    try:
        assert swept("ray").shape == (10_000, 16)
    finally:
        ray.shutdown()

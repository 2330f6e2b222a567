"""Motions that several tests use, and the reference vectors of the repository."""

import json
from pathlib import Path
from typing import Any

import pytest

import toytop

VECTORS = Path(__file__).parents[3] / "tests" / "reference" / "vectors"


@pytest.fixture
def top() -> toytop.Top:
    return toytop.Top.sliding(
        mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5, gravity=9.81
    )


@pytest.fixture
def motion(top: toytop.Top) -> toytop.Motion:
    return top.release(tilt=0.35, spin=150.0, precession=2.0)


def vector(name: str) -> dict[str, Any]:
    return dict(json.loads((VECTORS / f"{name}.json").read_text()))


def motion_of(of: dict[str, Any]) -> toytop.Motion:
    """Motion of a reference vector."""
    numbers = {key: float(of["params"][key]) for key in "ACsp"}
    shared = {
        "transverse_inertia": numbers["A"],
        "axial_inertia": numbers["C"],
        "mass_moment": numbers["p"],
        "gravity": 1.0,
    }
    top = toytop.Top.sliding(com_height=numbers["s"], **shared) if numbers["s"] else toytop.Top.fixed(**shared)
    params = of["params"]
    if "omega0" in params:
        alpha, beta = ([float(part) for part in params[key]] for key in ("alpha0", "beta0"))
        text = top.release(tilt=0.1, spin=1.0).to_toml().split("[motion]")[0]
        omega = [float(part) for part in params["omega0"]]
        return toytop.Motion.from_toml_text(
            f'{text}[motion]\nkind = "state"\nalpha = {alpha}\nbeta = {beta}\nomega = {omega}\n'
        )
    return top.branch_points(
        *(float(of[key]) for key in ("e1", "e2", "e3")),
        sign_l_plus_n=of["s_plus"],
        sign_l_minus_n=of["s_minus"],
        nutation_phase=float(params["theta0"]),
        arg_alpha=float(params["arg_alpha0"]),
        arg_beta=float(params["arg_beta0"]),
    )

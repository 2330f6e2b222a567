"""Arrays against reference vectors of thirty digits, whose inputs are exact in float64: of a sliding top, a held one, and a launch by state.

The tests of the program compare the orientations of all vectors."""

from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from conftest import VECTORS, motion_of, vector

pytestmark = pytest.mark.skipif(not VECTORS.exists(), reason="the vectors are in the repository")
NAMES = ["exact_generic_pm", "exact_lagrange", "exact_state_generic"]


def samples_of(name: str) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    of = vector(name)
    return of, of["samples"] + of.get("huge_samples", [])


def quaternion(sample: dict[str, Any]) -> list[Decimal]:
    (w, z), (minus_y, x) = ([Decimal(part) for part in sample[key]] for key in ("alpha", "beta"))
    return [w, x, -minus_y, z]


@pytest.mark.parametrize("name", NAMES)
def test_the_orientation_is_within_its_bound(name: str) -> None:
    of, samples = samples_of(name)
    found = motion_of(of).at([float(sample["t"]) for sample in samples])
    exact = np.array([quaternion(sample) for sample in samples], dtype=np.float64)
    errors = 2.0 * np.linalg.norm(found.quaternion - exact, axis=1)
    rounding = 2.0 * np.finfo(float).eps
    assert (errors <= found.error_bound + rounding).all()
    assert (found.error_bound[: len(of["samples"])] < 1e-13).all()


@pytest.mark.parametrize("name", NAMES)
def test_what_follows_from_the_orientation(name: str) -> None:
    of, _ = samples_of(name)
    motion, samples = motion_of(of), of["samples"]
    found = motion.at([float(sample["t"]) for sample in samples])

    def exact(key: str) -> np.ndarray[Any, np.dtype[np.float64]]:
        return np.array([sample[key] for sample in samples], dtype=np.float64)

    scale = max(1.0, float(of["params"]["s"]))
    assert np.abs(found.u - exact("u")).max() < 1e-13
    assert np.abs(found.tip - exact("c")).max() < 1e-13 * scale
    assert (np.abs(found.udot - exact("udot")) <= motion.rate_error_bound(1e3) + 1e-15).all()
    if motion.tip_class == "point":
        assert np.isnan(found.tip_angle).all()
    else:
        radius = np.maximum(np.linalg.norm(exact("c"), axis=1), 1e-3)
        assert (np.abs(found.tip_angle - exact("phi")) * radius < 1e-11 * scale).all()


@pytest.mark.parametrize("name", NAMES)
def test_the_reference_has_thirty_digits(name: str) -> None:
    of, samples = samples_of(name)
    samples = samples[:3] + samples[-1:]
    found = motion_of(of).reference_digits([float(sample["t"]) for sample in samples])
    for sample, digits in zip(samples, found, strict=True):
        assert max(abs(x - y) for x, y in zip(digits, quaternion(sample), strict=True)) < Decimal("1e-28")


def test_the_constants_are_those_of_the_vector() -> None:
    of = vector("exact_generic_pm")
    motion = motion_of(of)
    for name in ("l", "n", "h", "e1", "e2", "e3", "e4"):
        assert getattr(motion, name) == pytest.approx(float(of[name]), rel=1e-15)
    assert motion.period == pytest.approx(float(of["period"]["T"]), rel=1e-15)
    assert motion.regime == "nutating"

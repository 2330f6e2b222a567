"""Against SciPy: its rotations, and its integration of Newton's and Euler's equations."""

from typing import Any

import numpy as np
import pytest

import toytop

pytest.importorskip("scipy")
TIMES = np.linspace(-0.3, 0.7, 101)


def test_a_rotation_is_one_call_away(motion: toytop.Motion) -> None:
    now = motion.at(TIMES)
    rotation = now.rotation()
    assert np.abs(rotation.apply([0.0, 0.0, 1.0]) - now.axis).max() < 1e-15
    assert np.abs(rotation.apply(now.omega_body.copy()) - now.omega).max() < 1e-12
    assert np.abs(rotation.as_quat()[:, [3, 0, 1, 2]] - now.quaternion).max() < 1e-15
    assert motion.at(0.5).rotation().as_quat().shape == (4,)


@pytest.mark.parametrize("sequence", ["zxz", "zyz"])
def test_euler_angles(motion: toytop.Motion, sequence: str) -> None:
    now = motion.at(TIMES)
    expected = now.rotation().as_euler(sequence.upper())
    difference = (now.euler(sequence) - expected + np.pi) % (2.0 * np.pi) - np.pi  # type: ignore[arg-type]
    assert np.abs(difference).max() < 1e-13


def test_a_release_is_what_its_angles_say(top: toytop.Top) -> None:
    motion = top.release(tilt=0.4, spin=90.0, precession=3.0, nutation=-2.0, azimuth=0.7, roll=-1.1)
    now = motion.at(0.0)
    assert now.euler("zyz") == pytest.approx([0.7, 0.4, -1.1], abs=1e-15)
    assert now.omega_body[2] == pytest.approx(90.0, abs=1e-12)
    again = top.launch(now.rotation(), omega_body=now.omega_body)
    assert np.abs(again.at(TIMES).quaternion - motion.at(TIMES).quaternion).max() < 1e-11


def integrated(motion: toytop.Motion, times: Any, rtol: float) -> tuple[Any, Any]:
    """Quaternions and angular velocities by DOP853."""
    from scipy.integrate import solve_ivp

    top, now = motion.top, motion.at(0.0)
    full = pytest.importorskip("top", reason="the full equations are in host/comparisons of the repository")
    equations = full.Equations(
        top.transverse_inertia, top.axial_inertia, top.mass_moment, top.com_height, top.gravity
    )
    start, span = equations.state(now.quaternion, now.omega), (times[0], times[-1])
    states = solve_ivp(equations.slope, span, start, "DOP853", times, rtol=rtol, atol=1e-3 * rtol).y.T
    return states[:, :4], np.array([equations.rates(state)[0] for state in states])


@pytest.mark.parametrize("held", [False, True])
def test_the_motion_solves_the_equations(top: toytop.Top, held: bool) -> None:
    if held:
        top = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5)
    motion = top.release(tilt=0.5, spin=120.0, precession=-4.0, nutation=3.0)
    times = np.linspace(0.0, 1.0, 41)
    quaternion, omega = integrated(motion, times, 1e-12)
    exact = motion.at(times)
    assert np.abs(quaternion - exact.quaternion).max() < 1e-8
    assert np.abs(omega - exact.omega).max() < 1e-5


def test_the_score_of_an_integration(motion: toytop.Motion) -> None:
    times = np.linspace(0.0, 0.5, 501)
    quaternion, omega = integrated(motion, times, 1e-9)
    errors = 2.0 * np.linalg.norm(quaternion - motion.at(times).quaternion, axis=1)
    score = toytop.score(motion, times, quaternion, omega=omega)
    # the score normalises first
    assert score.max_error == pytest.approx(errors.max(), rel=0.3)
    assert 1e-9 < score.max_error < 1e-4 and score.warning is None
    assert score.drift_h is not None and 1e-14 < score.drift_h < 1e-6
    without = toytop.score(motion, times, quaternion)
    assert without.max_error == score.max_error and without.drift_h is None


def test_the_order_of_a_method(motion: toytop.Motion) -> None:
    times, steps = np.linspace(0.0, 0.1, 101), [1e-2, 5e-3, 2.5e-3]
    # runs that are ahead by the fourth power of the step
    runs = [motion.at(times + step**4).quaternion for step in steps]
    errors = [toytop.score(motion, times, run).max_error for run in runs]
    assert toytop.order(steps, errors) == pytest.approx(4.0, abs=0.01)
    assert toytop.order([0.1], [1e-3]) is None


def test_a_result_in_the_wrong_convention_is_told(motion: toytop.Motion) -> None:
    times = np.linspace(0.0, 0.1, 20)
    inverse = motion.at(times).quaternion * [1.0, -1.0, -1.0, -1.0]
    warning = toytop.score(motion, times, inverse).warning
    assert warning is not None and "from fixed to body" in warning

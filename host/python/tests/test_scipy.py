"""Against SciPy: its rotations, and its integration of Newton's and Euler's equations."""

import equations
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


@pytest.mark.parametrize("held", [False, True])
def test_the_motion_solves_the_equations(top: toytop.Top, held: bool) -> None:
    if held:
        top = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5)
    motion = top.release(tilt=0.5, spin=120.0, precession=-4.0, nutation=3.0)
    times = np.linspace(0.0, 1.0, 41)
    found = equations.integrate(motion, times, method="DOP853", rtol=1e-12, atol=1e-14)
    exact = motion.at(times)
    assert np.abs(found[:, :4] - exact.quaternion).max() < 1e-8
    omega = [equations.omega_of(top, equations.axis(y[:4]), y[4:])[0] for y in found]
    assert np.abs(np.array(omega) - exact.omega).max() < 1e-5


def test_the_score_of_an_integration(motion: toytop.Motion) -> None:
    times = np.linspace(0.0, 0.5, 501)
    states = equations.integrate(motion, times, method="DOP853", rtol=1e-9, atol=1e-12)
    errors = 2.0 * np.linalg.norm(states[:, :4] - motion.at(times).quaternion, axis=1)
    omega = [equations.omega_of(motion.top, equations.axis(y[:4]), y[4:])[0] for y in states]
    score = toytop.score(motion, times, states[:, :4], omega=omega)
    # the score normalises first
    assert score.max_error == pytest.approx(errors.max(), rel=0.3)
    assert 1e-9 < score.max_error < 1e-4 and score.warning is None
    assert score.drift_h is not None and 1e-14 < score.drift_h < 1e-6
    without = toytop.score(motion, times, states[:, :4])
    assert without.max_error == score.max_error and without.drift_h is None


def test_the_order_of_a_method(motion: toytop.Motion) -> None:
    slope = equations.slope(motion.top)
    steps, errors = [], []
    for count in (400, 800, 1600):
        times = np.linspace(0.0, 0.1, count + 1)
        h, states = times[1], [equations.start(motion)]
        for t in times[:-1]:
            y = states[-1]
            k1 = slope(t, y)
            k2 = slope(t, y + 0.5 * h * k1)
            k3 = slope(t, y + 0.5 * h * k2)
            k4 = slope(t, y + h * k3)
            states.append(y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4))
        steps.append(h)
        errors.append(toytop.score(motion, times, np.array(states)[:, :4]).max_error)
    assert toytop.order(steps, errors) == pytest.approx(4.0, abs=0.3)
    assert toytop.order([0.1], [1e-3]) is None


def test_a_result_in_the_wrong_convention_is_told(motion: toytop.Motion) -> None:
    times = np.linspace(0.0, 0.1, 20)
    inverse = motion.at(times).quaternion * [1.0, -1.0, -1.0, -1.0]
    warning = toytop.score(motion, times, inverse).warning
    assert warning is not None and "from fixed to body" in warning

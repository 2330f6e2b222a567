"""Launches fitted to simulated samples: the truth is within the error bars, and what is wrong is named."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import toytop

CAMERA: dict[str, Any] = {"orientation": {"noise": 0.002, "every": 2}}
TELEPHONE: dict[str, Any] = {
    "gyroscope": {"noise": 0.002, "bias": 0.0175, "range": 34.91},
    "accelerometer": {"noise": 0.022, "bias": 0.2, "range": 157},
    "magnetometer": {"noise": 0.6, "field": [20.0, 0.0, -43.0], "every": 10},
}
# largest of some ten normal numbers
MAX_DEVIATIONS = 4.5


@pytest.fixture(scope="module")
def truth() -> toytop.Motion:
    top = toytop.Top.sliding(
        mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5, gravity=9.81
    )
    return top.release(tilt=0.35, spin=150.0, precession=2.0)


@pytest.fixture(scope="module")
def samples(truth: toytop.Motion) -> dict[str, Any]:
    return dict(toytop.simulate(truth, duration=0.3, seed=7))


def same(a: toytop.Fitted, b: toytop.Fitted) -> bool:
    return bool((a.quaternion == b.quaternion).all() and (a.covariance == b.covariance).all())


def test_the_truth_is_within_the_error_bars(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    fitted = toytop.fit(samples, truth.top)
    assert fitted.converged and fitted.reason is None and fitted.undetermined == [] and fitted.alternatives == 0
    start = truth.at(fitted.epoch)
    # the covariance is that of omega in the frame that the error of the orientation turns
    (w, *r), body = fitted.quaternion, start.omega_body
    turned = body + 2.0 * np.cross(r, np.cross(r, body) + w * body)
    off = np.abs(turned - fitted.omega) / fitted.deviations[3:6]
    assert 0.01 < off.max() < MAX_DEVIATIONS
    for (value, deviation), true in [(fitted.spin, 150.0), (fitted.tilt, 0.35)]:
        assert 0.0 < abs(value - true) < MAX_DEVIATIONS * deviation < 0.5
    count = len(fitted.unknowns)
    assert fitted.covariance.shape == (count, count) == (12, 12)
    assert np.allclose(np.sqrt(np.diag(fitted.covariance)), fitted.deviations, rtol=1e-12)
    assert 0.8 < fitted.reduced_chi_squared < 1.2 and fitted.saturated == 300
    values, deviations = fitted.biases["gyroscope"]
    assert (values[:2] != 0.0).all() and (deviations[:2] < 0.0175).all()
    # the gyroscope is blind along the axis: what was known before
    assert values[2] == 0.0 and deviations[2] == pytest.approx(0.0175, rel=0.01)
    assert repr(fitted).startswith("<Fitted: tilt 0.3")


def test_a_drift_is_fitted(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    fitted = toytop.fit(samples, truth.top, drift=0.02)
    assert fitted.converged and fitted.epoch == pytest.approx(0.299)
    assert fitted.drift is not None
    rates, deviations = fitted.drift
    assert (deviations > 0.0).all() and (np.abs(rates) < MAX_DEVIATIONS * deviations).all() and (rates != 0.0).all()
    assert fitted.unknowns[6:9] == ["loss_axial", "loss_across", "loss_vertical"]
    assert np.nanstd(fitted.residuals["accel_x"]) == pytest.approx(1.0, abs=0.2)
    assert toytop.fit(samples, truth.top).drift is None
    with pytest.raises(ValueError, match="drift"):
        toytop.fit(samples, truth.top, drift=0.0)
    with pytest.raises(ValueError, match="free"):
        toytop.fit(samples, truth.top, drift=0.02, free=["axial_inertia", "gravity"])


def test_the_motion_predicts(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    fitted = toytop.fit(samples, truth.top)
    times = np.array([[0.0, 0.3], [2.0, 10.0]])
    now, true = fitted.motion.at(times), truth.at(times + fitted.epoch)
    covariance = fitted.orientation_covariance(times)
    assert covariance.shape == (2, 2, 3, 3)
    error = 2.0 * np.minimum(
        np.linalg.norm(now.quaternion - true.quaternion, axis=-1),
        np.linalg.norm(now.quaternion + true.quaternion, axis=-1),
    )
    announced = np.sqrt(np.trace(covariance, axis1=-2, axis2=-1))
    assert (error < MAX_DEVIATIONS * announced).all() and (announced < 0.05).all()
    assert np.abs(now.omega[0, 0] - fitted.omega).max() < 1e-11
    assert fitted.motion.top == truth.top and fitted.motion is fitted.motion


def test_residuals_are_those_of_the_samples(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    fitted = toytop.fit(samples, truth.top, huber=float("inf"))
    residuals = fitted.residuals
    assert list(residuals) == list(samples) and (residuals["t"] == samples["t"]).all()
    # a reading of the gyroscope along the axis is at the end of its range
    for name, least, most in [("gyro_x", 300, 300), ("gyro_z", 0, 0), ("mag_y", 30, 30)]:
        assert least <= np.isfinite(residuals[name]).sum() <= most, name
    found = np.concatenate([column for name, column in residuals.items() if name != "t"])
    found = found[np.isfinite(found)]
    assert len(found) == fitted.used
    assert np.sum(found**2) == pytest.approx(fitted.chi_squared, rel=1e-3)
    camera = toytop.fit(toytop.simulate(truth, CAMERA, duration=0.1), truth.top, CAMERA)
    assert list(camera.residuals) == ["t", "x", "y", "z"]


def test_samples_in_other_containers(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    expected = toytop.fit(samples, truth.top)
    structured = np.empty(len(samples["t"]), dtype=[(name, np.float64) for name in samples])
    for name, column in samples.items():
        structured[name] = column
    lists = {name: list(column) for name, column in samples.items()}
    unread = {**samples, "temperature": np.full(len(samples["t"]), np.nan)}
    for other in (structured, lists, unread):
        assert same(toytop.fit(other, truth.top), expected)
    # the sensors of a telephone, as far as there are columns
    gyroscope = {name: column for name, column in samples.items() if not name.startswith("mag")}
    fitted = toytop.fit(gyroscope, truth.top)
    assert fitted.undetermined == ["yaw"] and fitted.converged


def test_sensors_are_a_mapping_or_a_file(truth: toytop.Motion, tmp_path: Path) -> None:
    file = tmp_path / "sensors.toml"
    file.write_text("[orientation]\nnoise = 0.002\nevery = 2\n")
    a, b = (toytop.simulate(truth, sensors, duration=0.1, seed=3) for sensors in (CAMERA, file))
    # readings of one time in two: rows without one are not written
    assert list(a) == ["t", "w", "x", "y", "z"] and len(a["t"]) == 50
    assert all((a[name] == b[name]).all() for name in a)
    assert same(toytop.fit(a, truth.top, CAMERA), toytop.fit(a, truth.top, str(file)))
    other = toytop.simulate(truth, CAMERA, duration=0.1, seed=4)
    assert (other["t"] == a["t"]).all() and (other["w"] != a["w"]).all()
    with pytest.raises(FileNotFoundError, match="nothing.toml"):
        toytop.simulate(truth, tmp_path / "nothing.toml")


def test_an_unknown_inertia_is_found(truth: toytop.Motion) -> None:
    samples = toytop.simulate(truth, CAMERA, duration=0.3)
    wrong = toytop.Top.sliding(
        mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.06e-5, gravity=9.81
    )
    strict = toytop.fit(samples, wrong, CAMERA)
    assert not strict.converged and strict.reason is not None and strict.reason in repr(strict)
    for refused in (lambda: strict.motion, lambda: strict.orientation_covariance(0.0)):
        with pytest.raises(ValueError, match="^motion: must be that of a fit that has converged"):
            refused()
    fitted = toytop.fit(samples, wrong, CAMERA, free=["axial_inertia"])
    value, deviation = fitted.free["axial_inertia"]
    assert abs(value - 2.0e-5) < MAX_DEVIATIONS * deviation < 1e-6
    assert fitted.unknowns[6] == "axial_inertia" and fitted.motion.top.axial_inertia == value
    # its row of the covariance is that of the logarithm
    assert deviation == pytest.approx(value * fitted.deviations[6], rel=1e-12)


def in_degrees(samples: dict[str, Any]) -> dict[str, Any]:
    return {
        name: np.degrees(column) if name.startswith("gyro") else column for name, column in samples.items()
    }


misspelt: Any = ["spin"]


def changed(samples: dict[str, Any], name: str, row: int, value: float) -> dict[str, Any]:
    column = samples[name].copy()
    column[row] = value
    return {**samples, name: column}


@pytest.mark.parametrize(
    ("message", "call"),
    [
        ("samples: must have a column t", lambda s, m: toytop.fit({"gyro_x": s["t"]}, m.top)),
        ("samples: must have the columns of a sensor", lambda s, m: toytop.fit({"t": s["t"]}, m.top)),
        (
            "samples: must have the columns of the orientation: w, x, y, z",
            lambda s, m: toytop.fit(s, m.top, CAMERA),
        ),
        (
            "samples: gyro_y: must have as many rows as t; has 7",
            lambda s, m: toytop.fit({**s, "gyro_y": s["t"][:7]}, m.top),
        ),
        (
            "samples: gyro_y: must have one axis",
            lambda s, m: toytop.fit({**s, "gyro_y": np.ones((300, 1))}, m.top),
        ),
        ("samples: gyro_y: must be numbers", lambda s, m: toytop.fit({**s, "gyro_y": "a"}, m.top)),
        (
            "samples: gyro_y: row 5: must be a finite number",
            lambda s, m: toytop.fit(changed(s, "gyro_y", 5, np.nan), m.top),
        ),
        (
            "samples: gyro_y: row 5: must be a finite number",
            lambda s, m: toytop.fit(changed(s, "gyro_y", 5, np.inf), m.top),
        ),
        (
            "samples: gyro_x: row 0: must be at most the range of the sensor",
            lambda s, m: toytop.fit(in_degrees(s), m.top),
        ),
        ("samples: t: row 5: must be a finite", lambda s, m: toytop.fit(changed(s, "t", 5, np.nan), m.top)),
        ("samples: t: row 6: must not be earlier", lambda s, m: toytop.fit(changed(s, "t", 5, 9.0), m.top)),
        (
            "samples: measurements: must be at least one",
            lambda s, m: toytop.fit({name: column[:0] for name, column in s.items()}, m.top),
        ),
        ("huber: must be a number from 1", lambda s, m: toytop.fit(s, m.top, huber=0.5)),
        ('free: "spin" must be one of transverse_inertia', lambda s, m: toytop.fit(s, m.top, free=misspelt)),
        ("free: mass: must be named once", lambda s, m: toytop.fit(s, m.top, free=["mass", "mass"])),
        ("free: mass_moment: must be", lambda s, m: toytop.fit(s, m.top, free=["mass_moment"])),
        ("sensors: gyroscop: unknown sensor", lambda s, m: toytop.fit(s, m.top, {"gyroscop": {"noise": 1}})),
        (
            "sensors: gyroscope.noise: must be a number from",
            lambda s, m: toytop.fit(s, m.top, {"gyroscope": {"noise": -1}}),
        ),
        (
            "sensors: magnetometer.field: must be an array of 3",
            lambda s, m: toytop.fit(s, m.top, {"magnetometer": {"noise": 1, "field": [1, 2]}}),
        ),
        ("hertz, duration: must give from 1", lambda s, m: toytop.simulate(m, hertz=-1.0)),
        ("hertz, duration: must give from 1", lambda s, m: toytop.simulate(m, duration=1e9)),
    ],
)
def test_what_is_refused_is_named(
    truth: toytop.Motion, samples: dict[str, Any], message: str, call: Any
) -> None:
    with pytest.raises(ValueError, match=f"^{message}"):
        call(samples, truth)


def test_wrong_types_are_type_errors(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    with pytest.raises(TypeError, match="^samples"):
        toytop.fit([1.0, 2.0], truth.top)
    with pytest.raises(TypeError, match="^sensors"):
        toytop.fit(samples, truth.top, 3)  # type: ignore[arg-type]


def test_samples_without_a_launch_are_said_so(truth: toytop.Motion, samples: dict[str, Any]) -> None:
    few = {name: column[:1] for name, column in samples.items()}
    fast = {**TELEPHONE, "gyroscope": {"noise": 0.002, "bias": 0.0175}}
    degrees = in_degrees(toytop.simulate(truth, fast, duration=0.3))
    for wrong, sensors, reason in [
        (few, TELEPHONE, "fewer observations than unknowns"),
        (degrees, fast, "degrees per second"),
    ]:
        fitted = toytop.fit(wrong, truth.top, sensors)
        assert not fitted.converged and fitted.reason is not None and reason in fitted.reason

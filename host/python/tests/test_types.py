"""Every public name, as mypy --strict sees it."""

import inspect
import re
from pathlib import Path
from typing import Any, assert_type

import numpy as np
from numpy.typing import NDArray

import toytop

Array = NDArray[np.float64]


def use_tops() -> None:
    shared = {"transverse_inertia": 3e-5, "axial_inertia": 2e-5}
    top = toytop.Top.sliding(mass=0.05, com_height=0.03, **shared)
    assert_type(toytop.Top.fixed(mass_moment=1.5e-3, **shared), toytop.Top)
    assert_type(toytop.Top.free(**shared), toytop.Top)
    assert_type(top.launch([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0]), toytop.Motion)
    assert_type(top.branch_points(0.7, 0.9, 1.85, sign_l_plus_n=1, sign_l_minus_n=1), toytop.Motion)
    numbers = (top.transverse_inertia, top.axial_inertia, top.com_height, top.mass_moment, top.rotor_momentum, top.gravity)
    assert sum(numbers) > 0.0 and top.support == "sliding" and assert_type(top.e4, float | None)


def use_motion(motion: toytop.Motion, path: Path) -> None:
    path.write_text(motion.to_toml())
    assert toytop.Motion.from_toml(path) == toytop.Motion.from_toml_text(motion.to_toml())
    assert_type(motion.error_bound(1.0) + motion.rate_error_bound(scalar="f32"), float)
    assert_type(motion.events("tilt", 0.3, start=1.0, count=3, sense="up"), dict[str, NDArray[Any]])
    assert_type(motion.partials([0.0, 1.0])["omega"], Array)
    assert_type(motion.partial_names, tuple[str, ...])
    assert_type(motion.with_impulse([0.0, 0.0, 0.0], [0.0, 0.0, 0.03], t=1.0), toytop.Motion)
    assert_type(motion.reaction_impulse([0.0, 0.0, 0.0], [0.0, 0.0, 0.03]), Array)
    assert_type(motion.reference_digits(0.5, digits=20), NDArray[np.object_])
    assert_type(motion.top, toytop.Top)
    integrals = (motion.l, motion.n, motion.h, motion.e1, motion.e2, motion.e3, motion.one_plus_e1, motion.one_minus_e2)
    differences = (motion.e2_minus_e1, motion.e3_minus_e2, motion.e3_minus_one)
    assert len(integrals + differences) == 11 and motion.sign_l_plus_n * motion.sign_l_minus_n in (1, -1)
    maybe = (motion.e4, motion.period, motion.alpha_turns, motion.beta_turns, motion.phi_per_period, motion.min_normal_force)
    assert_type(maybe[1], float | None)
    assert motion.regime == "nutating" and motion.tip_class == "smooth"


def use_samples(now: toytop.Samples) -> None:
    arrays = (now.t, now.quaternion, now.axis, now.u, now.udot, now.omega, now.omega_body, now.tip, now.tip_angle)
    assert_type(arrays[1] if arrays else now.error_bound, Array)
    assert now.euler("zyz").shape == now.omega.shape and now.rotation() is not None
    assert_type(now.columns(), dict[str, NDArray[Any]])


def use_many(many: toytop.Many) -> None:
    assert_type(many[0], toytop.Motion)
    assert_type(many[:1], toytop.Many)
    assert_type(many.at(1.0, scalar="q31"), toytop.Samples)
    assert_type([motion.e1 for motion in many], list[float])
    assert_type(many.constant("period"), Array)


def use_score(score: toytop.Score) -> None:
    numbers = (score.max_error, score.rms_error, score.final_error, score.max_u_error, score.max_norm_error, score.truth_bound)
    phases = (score.nutation_error, score.precession_error, score.spin_error, score.residual)
    drifts = (score.drift_h, score.drift_l, score.drift_n)
    assert_type(numbers[0], float)
    assert_type((phases + drifts)[0], float | None)
    assert_type(score.warning, str | None)


def use_fitted(fitted: toytop.Fitted) -> None:
    assert fitted.converged and fitted.reason is None and fitted.undetermined == []
    assert_type(fitted.motion, toytop.Motion)
    counts = (fitted.used, fitted.saturated, fitted.outliers, fitted.alternatives)
    assert sum(counts) > 0 and fitted.epoch + fitted.chi_squared + fitted.reduced_chi_squared > 0.0
    arrays = (fitted.quaternion, fitted.omega, fitted.covariance, fitted.deviations, fitted.orientation_covariance(0.1))
    assert_type(arrays[0], Array)
    assert_type(fitted.spin, tuple[float, float])
    assert fitted.tilt[1] > 0.0 and len(fitted.unknowns) == len(fitted.deviations)
    assert_type(fitted.losses, dict[str, tuple[float, float]] | None)
    assert fitted.drift is None and fitted.free == {} and set(fitted.biases) <= set(fitted.residuals) | set(fitted.biases)


def test_every_public_name(top: toytop.Top, motion: toytop.Motion, tmp_path: Path) -> None:
    use_tops()
    use_motion(motion, tmp_path / "motion.toml")
    many = toytop.many(top, {"tilt": [0.1, 0.2], "spin": 150.0})
    use_many(many)
    times = np.linspace(0.0, 0.1, 11)
    use_samples(motion.at(times))
    use_samples(motion.reference(times))
    form = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2e-5).release(tilt=0.5, spin=200.0)
    assert_type(form.closed_form(), toytop.ClosedForm)
    assert form.closed_form().kind == "lagrange" and len(form.closed_form().at(times)) == 11
    use_score(toytop.score(motion, times, motion.at(times).quaternion))
    assert_type(toytop.order([0.1, 0.2], [1.0, 2.0]), float | None)
    use_fitted(toytop.fit(toytop.simulate(motion, duration=0.3), top))
    page = motion.view()
    page.save(tmp_path / "page.html")
    assert isinstance(page, toytop.Page) and isinstance(page.html, str)
    assert_type(toytop.__version__, str)


def test_no_public_name_is_missing_here() -> None:
    here = Path(__file__).read_text()
    classes = [getattr(toytop, name) for name in toytop.__all__ if inspect.isclass(getattr(toytop, name))]
    names = {name for of in [toytop, *classes] for name in dir(of) if not name.startswith("_")}
    names -= {"_toytop", "annotations"}
    unused = {name for name in names if not re.search(rf"\b{name}\b", here)}
    assert not unused

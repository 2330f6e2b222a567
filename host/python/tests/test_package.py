"""The package as Python sees it: shapes, refusals, pickles, threads, pictures."""

import doctest
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

import toytop

TOP: dict[str, Any] = {
    "mass": 0.05,
    "com_height": 0.03,
    "transverse_inertia": 3.0e-5,
    "axial_inertia": 2.0e-5,
}


def test_doctests() -> None:
    results = [doctest.testmod(module) for module in (toytop, sys.modules[toytop.Top.__module__])]
    assert sum(result.failed for result in results) == 0 and sum(result.attempted for result in results) >= 8


def test_the_import_loads_no_numpy() -> None:
    program = "import sys, toytop; assert 'numpy' not in sys.modules"
    subprocess.run([sys.executable, "-c", program], check=True)


def test_shapes_follow_the_times(motion: toytop.Motion) -> None:
    for shape in [(), (3,), (2, 5), (0,)]:
        now = motion.at(np.full(shape, 0.25))
        assert now.t.shape == now.u.shape == now.udot.shape == now.tip_angle.shape == shape
        assert now.error_bound.shape == shape
        assert now.quaternion.shape == (*shape, 4) and now.tip.shape == (*shape, 2)
        assert now.axis.shape == now.omega.shape == now.omega_body.shape == now.euler().shape == (*shape, 3)
    assert motion.at(0.25).quaternion.tolist() == motion.at([0.25]).quaternion[0].tolist()
    assert motion.at(1).u == motion.at(np.int64(1)).u == motion.at(np.float32(1.0)).u
    assert len(motion.at([1, 2, 3])) == 3
    with pytest.raises(TypeError):
        len(motion.at(1.0))
    # not contiguous, and in other types
    times = np.linspace(0.0, 1.0, 20)
    assert (motion.at(times[::3]).u == motion.at(times).u[::3]).all()
    columns = np.asfortranarray(times.reshape(4, 5))
    assert (motion.at(columns).u == motion.at(times).u.reshape(4, 5)).all()
    quaternions = np.asfortranarray(motion.at(times).quaternion)
    assert toytop.score(motion, times, quaternions).max_error < 1e-14
    assert (motion.at(list(range(4))).u == motion.at(np.arange(4)).u).all()


def test_an_attribute_is_computed_once(motion: toytop.Motion) -> None:
    now = motion.at([1.0, 2.0])
    assert now.quaternion is now.quaternion and now.u is not now.axis
    columns = now.columns()
    fixed, body = (["omega_x", "omega_y", "omega_z"], ["omega_body_x", "omega_body_y", "omega_body_z"])
    assert list(columns) == ["t", "w", "x", "y", "z", *fixed, *body, "u", "tip_x", "tip_y", "phi"]
    assert (columns["y"] == now.quaternion[:, 2]).all() and (columns["omega_x"] == now.omega[:, 0]).all()
    assert (columns["omega_body_z"] == now.omega_body[:, 2]).all()


def test_scalars_are_as_exact_as_their_bounds_say(motion: toytop.Motion) -> None:
    times = np.linspace(-100.0, 100.0, 5001)
    exact = motion.at(times).quaternion
    limits = {"f32": (1e-8, 1e-6), "q31": (1e-10, 1e-8), "q15": (1e-5, 1e-3)}
    for scalar, (least, most) in limits.items():
        now = motion.at(times, scalar=scalar)  # type: ignore[arg-type]
        errors = 2.0 * np.linalg.norm(now.quaternion - exact, axis=1)
        assert (errors <= now.error_bound + 1e-14).all() and least < errors.max() < most
        assert now.error_bound[0] == motion.error_bound(-100.0, scalar=scalar)  # type: ignore[arg-type]


def test_the_rates_are_derivatives(motion: toytop.Motion) -> None:
    times, h = np.linspace(0.0, 0.5, 50), 1e-6
    after, before, now = motion.at(times + h), motion.at(times - h), motion.at(times)
    assert np.abs((after.u - before.u) / (2.0 * h) - now.udot).max() < 1e-6
    slope = (after.axis - before.axis) / (2.0 * h)
    assert np.abs(np.cross(now.omega, now.axis) - slope).max() < 1e-5


def test_truth_and_closed_form_agree_with_the_table() -> None:
    top = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5)
    motion = top.release(tilt=0.5, spin=200.0, precession=1.0)
    times = [0.0, 0.1, 3.0, -2.5]
    table, truth, form = motion.at(times), motion.reference(times), motion.closed_form()
    assert form.kind == "lagrange"
    for other in (truth, form.at(times)):
        assert np.abs(other.quaternion - table.quaternion).max() < 1e-14
        assert np.abs(other.omega - table.omega).max() < 1e-11
        assert np.abs(other.tip - table.tip).max() < 1e-14
        assert np.abs(other.tip_angle - table.tip_angle).max() < 1e-13
    with pytest.raises(ValueError, match="no closed form"):
        toytop.Top.sliding(**TOP).release(tilt=0.4, spin=150.0).closed_form()


def test_a_mass_moment_is_not_rounded() -> None:
    """0.05 x 0.03 is no float64: after 10^5 periods the rounding would show."""
    motion = toytop.Top.sliding(**TOP).release(tilt=0.35, spin=150.0)
    now = motion.at(8e3)
    error = 2.0 * np.linalg.norm(now.quaternion - motion.reference(8e3).quaternion)
    # the reference is rounded to float64 too; a rounded mass moment would be off by some 1e-11 rad
    assert error < now.error_bound + 1e-15 and now.error_bound < 1e-14


@pytest.mark.parametrize(
    ("name", "make"),
    [
        ("mass", lambda top: toytop.Top.sliding(**{**TOP, "mass": -1.0})),
        ("mass", lambda top: toytop.Top.sliding(**{**TOP, "mass_moment": 1.0})),
        ("axial_inertia", lambda top: toytop.Top.fixed(**{**TOP, "axial_inertia": 1.0})),
        ("tilt", lambda top: top.release(tilt=4.0, spin=1.0)),
        ("precession", lambda top: top.release(tilt=1.0, spin=1.0, precession=9e10)),
        ("spin", lambda top: top.release(tilt=1.0, spin=float("nan"))),
        ("quaternion", lambda top: top.launch([1.0, 0.0, 0.1, 0.0], [0.0, 0.0, 1.0])),
        ("quaternion", lambda top: top.launch([1.0, 0.0, 0.0], [0.0, 0.0, 1.0])),
        ("omega", lambda top: top.launch([1.0, 0.0, 0.0, 0.0], [0.0, 1.0])),
        ("omega", lambda top: top.launch([1.0, 0.0, 0.0, 0.0])),
        ("omega_body", lambda top: top.launch([1.0, 0.0, 0.0, 0.0], omega_body=[0.0, 0.0, 1e13])),
        ("e2", lambda top: top.branch_points(0.5, 1.5, 2.0, sign_l_plus_n=1, sign_l_minus_n=1)),
        ("sign_l_minus_n", lambda top: top.branch_points(0.5, 0.9, 2.0, sign_l_plus_n=1, sign_l_minus_n=0)),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at([0.0, float("inf")])),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at(1e18)),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at("soon")),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at(np.timedelta64(1500, "ms"))),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at(np.array(["2026-01-01"], "datetime64[s]"))),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at(np.array([timedelta(seconds=1)]))),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at(np.ma.masked_array([0.0, 1.0], [False, True]))),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at([0.0, None])),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at([True])),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).at(1j)),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).error_bound(float("nan"))),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).rate_error_bound([0.0, 1.0])),
        ("t", lambda top: top.release(tilt=1.0, spin=1.0).reference(np.timedelta64(1, "s"))),
        ("duration", lambda top: toytop.simulate(top.release(tilt=1.0, spin=1.0), duration=cast(Any, np.timedelta64(1, "s")))),
        ("seed", lambda top: toytop.simulate(top.release(tilt=1.0, spin=1.0), seed=-1)),
        ("digits", lambda top: top.release(tilt=1.0, spin=1.0).reference_digits(0.0, digits=-1)),
        ("omega", lambda top: top.launch([1.0, 0.0, 0.0, 0.0], [[0.0, 0.0, 1.0]])),
        ("quaternion", lambda top: top.launch([[1.0, 0.0, 0.0, 0.0]], [0.0, 0.0, 1.0])),
        ("releases", lambda top: toytop.many(top, [])),
        ("releases", lambda top: toytop.many(top, {"tilt": [], "spin": []})),
        ("releases", lambda top: toytop.many(top)),
        ("tops", lambda top: toytop.many([], {"tilt": 0.1, "spin": 1.0})),
        ("releases: spin", lambda top: toytop.many(top, {"tilt": 0.1, "spin": [np.nan, 1.0]})),
        ("omega", lambda top: toytop.many(top, quaternion=[[1, 0, 0, 0]], omega=[[0, 0, 1], [0, 0, 2]])),
        ("omega_body", lambda top: toytop.many(top, quaternion=[[1, 0, 0, 0]], omega_body=[0, 0, 1])),
        (r"quaternion\[1\]: quaternion", lambda top: toytop.many(top, quaternion=[[1, 0, 0, 0], [1, 1, 0, 0]], omega=[[0, 0, 1]] * 2)),
        ("scalar", lambda top: top.release(tilt=1.0, spin=1.0).at(0.0, scalar="f16")),
        ("digits", lambda top: top.release(tilt=1.0, spin=1.0).reference_digits(0.0, digits=0)),
        ("sequence", lambda top: top.release(tilt=1.0, spin=1.0).at(0.0).euler("xyz")),
        ("releases: tilt_deg", lambda top: toytop.many(top, {"tilt_deg": 1.0, "spin": 1.0})),
        ("releases: tilt", lambda top: toytop.many(top, {"spin": 1.0})),
        ("releases: spin", lambda top: toytop.many(top, {"tilt": [0.1, 0.2, 0.3], "spin": [1.0, 2.0]})),
        (r"releases\[1\]: tilt", lambda top: toytop.many(top, {"tilt": [0.1, 4.0], "spin": 1.0})),
        ("tops", lambda top: toytop.many([top] * 3, {"tilt": [0.1, 0.2], "spin": 1.0})),
        ("name", lambda top: toytop.many(top, {"tilt": 0.1, "spin": 1.0}).constant("e5")),
        ("text: top", lambda top: toytop.Motion.from_toml_text("[motion]")),
        ("text: motion.spin", lambda top: toytop.Motion.from_toml_text(bad_scenario(top))),
    ],
)
def test_what_is_refused_is_named(top: toytop.Top, name: str, make: Any) -> None:
    with pytest.raises(ValueError, match=f"^{name}"):
        make(top)


def bad_scenario(top: toytop.Top) -> str:
    text = top.release(tilt=0.1, spin=1.0).to_toml().split("[motion]")[0]
    return text + '[motion]\nkind = "release"\ntilt_deg = 10\nspin = "fast"\n'


def test_a_score_refuses_what_is_no_trajectory(motion: toytop.Motion) -> None:
    times = [0.0, 0.1, 0.2]
    q = motion.at(times).quaternion
    for name, arguments in [
        ("t", ([0.0, 0.2, 0.1], q)),
        ("t", ([], q[:0])),
        ("quaternion", (times, q[:2])),
        ("quaternion", (times, q[:, :3])),
        ("quaternion", (times, 0.0 * q)),
    ]:
        with pytest.raises(ValueError, match=f"^{name}"):
            toytop.score(motion, *arguments)
    with pytest.raises(ValueError, match="^omega"):
        toytop.score(motion, times, q, omega=[[0.0] * 3], omega_body=None)


def test_scenario_files(motion: toytop.Motion, tmp_path: Path) -> None:
    file = tmp_path / "top.toml"
    file.write_text(motion.to_toml())
    read = toytop.Motion.from_toml(file)
    assert read == motion and (read.at([1.0, 2.0]).quaternion == motion.at([1.0, 2.0]).quaternion).all()
    text = motion.to_toml()
    assert "mass = 0.05\n" in text
    in_grams = toytop.Motion.from_toml_text(text.replace("mass = 0.05\n", 'mass = "50 g"\n'))
    assert in_grams.to_toml() == text
    with pytest.raises(FileNotFoundError, match="nothing.toml"):
        toytop.Motion.from_toml(tmp_path / "nothing.toml")


def test_pickles_are_exact(top: toytop.Top, motion: toytop.Motion) -> None:
    assert pickle.loads(pickle.dumps(top)) == top and hash(pickle.loads(pickle.dumps(top))) == hash(top)
    points = top.branch_points(
        0.7, 0.9, 1.85, sign_l_plus_n=1, sign_l_minus_n=-1, nutation_phase=0.3, arg_alpha=-0.2, arg_beta=1.0
    )
    for of in (motion, points):
        again = pickle.loads(pickle.dumps(of))
        assert again == of and hash(again) == hash(of)
        assert (again.at([0.3, 7.0]).quaternion == of.at([0.3, 7.0]).quaternion).all()
        assert (again.reference(0.3).quaternion == of.reference(0.3).quaternion).all()
    assert points != motion and points != 3


def test_many_are_the_single_ones(top: toytop.Top) -> None:
    other = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5)
    spins, times = np.array([90.0, 150.0]), np.array([[0.0, 0.5, 2.0], [1.0, -1.0, 4.0]])
    many = toytop.many([top, other], {"tilt": 0.3, "spin": spins, "roll": [0.1]})
    assert len(many) == 2
    now = many.at(times)
    assert now.quaternion.shape == (2, 2, 3, 4) and now.t.shape == (2, 2, 3)
    for index, (top_, spin) in enumerate(zip([top, other], spins, strict=True)):
        single = top_.release(tilt=0.3, spin=spin, roll=0.1)
        alone = single.at(times)
        assert many[index] == single == many[index - 2]
        assert (now.quaternion[index] == alone.quaternion).all()
        assert (now.error_bound[index] == alone.error_bound).all()
        assert now.omega[index] == pytest.approx(alone.omega, abs=1e-10)
        assert now.udot[index] == pytest.approx(alone.udot, abs=1e-10)
        assert now.tip[index] == pytest.approx(alone.tip, abs=1e-15)
        assert now.tip_angle[index] == pytest.approx(alone.tip_angle, abs=1e-12)
        assert many.constant("period")[index] == single.period
    assert np.isnan(many.constant("e4")[1])
    rows = toytop.many(top, [{"tilt": 0.3, "spin": 90.0, "roll": 0.1}, {"tilt": 0.2, "spin": 91.0}])
    assert rows[0] == many[0] and len(rows) == 2
    with pytest.raises(IndexError):
        many[2]


def test_threads_share_a_motion(top: toytop.Top) -> None:
    motion, times = top.release(tilt=0.3, spin=150.0), np.linspace(0.0, 10.0, 20_000)
    alone = top.release(tilt=0.3, spin=150.0).at(times).quaternion
    now = motion.at(times)
    with ThreadPoolExecutor(8) as pool:
        fresh = pool.map(lambda _: motion.at(times).quaternion, range(16))
        shared = pool.map(lambda _: now.quaternion, range(16))
        assert all((found == alone).all() for found in (*fresh, *shared))


def test_pictures(motion: toytop.Motion, tmp_path: Path) -> None:
    picture = motion._repr_html_()
    assert picture.startswith("<svg ") and picture.count(",") > 100 and picture.count("<circle") == 3
    page = motion.view()
    assert page.html.startswith("<!") and "srcdoc=" in page._repr_html_()
    page.save(tmp_path / "top.html")
    assert (tmp_path / "top.html").read_text() == page.html
    assert "nutating" in repr(motion) and repr(motion.top).startswith("Top.sliding(transverse_inertia=")


def test_a_free_body_keeps_its_rate_and_a_rotor_its_momentum() -> None:
    body = toytop.Top.free(transverse_inertia=1.1e-3, axial_inertia=2.0e-3)
    motion = body.release(tilt=0.4, spin=20.0, precession=3.0, nutation=-4.0)
    times = np.linspace(0.0, 5.0, 11)
    rates = np.linalg.norm(motion.at(times).omega, axis=1)
    assert body.support == "free" and np.ptp(rates) < 1e-13 * rates[0]
    assert np.abs(motion.at(times).quaternion - motion.reference(times).quaternion).max() < 1e-13
    wheel = toytop.Top.sliding(**TOP, rotor_momentum=0.01)
    turned = wheel.release(tilt=0.35, spin=150.0)
    assert wheel.rotor_momentum == 0.01
    assert np.abs(turned.at(times).quaternion - turned.reference(times).quaternion).max() < 1e-13

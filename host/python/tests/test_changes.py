"""Events, partial derivatives and impulses, against differences and balances."""

from typing import Any

import numpy as np
import pytest

import toytop


NAMES = ["t", "t_error", "up", "u", "tip_x", "tip_y", "phi"]


def test_turning_points(motion: toytop.Motion) -> None:
    events = motion.events("turning", count=2500)
    assert list(events) == NAMES and events["t"].shape == (2500,) and events["up"].dtype == bool
    assert np.abs(np.diff(events["t"][::2]) - motion.period).max() < 1e-11
    assert np.abs(np.where(events["up"], motion.e2, motion.e1) - events["u"]).max() < 1e-14
    upper = motion.events("turning", start=-1.0, count=3, sense="up")
    assert upper["up"].all() and upper["t"][0] >= -1.0 and upper["t"].shape == (3,)
    assert np.isnan(upper["t_error"]).all()


@pytest.mark.parametrize("kind", ["tilt", "circle", "tip_angle", "tip-angle"])
def test_crossings_are_where_they_say(motion: toytop.Motion, kind: Any) -> None:
    tilt = float(np.arccos(0.5 * (motion.e1 + motion.e2)))
    scale = motion.top.com_height
    value = {"tilt": tilt, "circle": scale * float(np.sin(tilt))}.get(kind, 1.0)
    events = motion.events(kind, value, start=3.0, count=40)
    now = motion.at(events["t"])
    assert len(events["t"]) == 40 and events["t"][0] >= 3.0 and (np.diff(events["t"]) > 0.0).all()
    off = {
        "tilt": now.u - np.cos(tilt),
        "circle": (np.linalg.norm(now.tip, axis=1) - value) / scale,
    }.get(kind, (now.tip_angle - value + np.pi) % (2.0 * np.pi) - np.pi)
    assert np.abs(off).max() < 1e-11
    assert ((events["t_error"] > 0.0) & (events["t_error"] < 1e-12)).all()
    assert (events["phi"] == pytest.approx(now.tip_angle)) and (events["tip_x"] == pytest.approx(now.tip[:, 0]))


def test_crossings_of_one_sense(motion: toytop.Motion) -> None:
    tilt = float(np.arccos(0.5 * (motion.e1 + motion.e2)))
    down = motion.events("tilt", tilt, count=10, sense="down")
    assert (motion.at(down["t"]).udot < 0.0).all()
    assert len(motion.events("tilt", 3.0)["t"]) == 0


def test_lift_off(top: toytop.Top) -> None:
    wild = top.release(tilt=1.0, spin=20.0, nutation=60.0)
    assert wild.min_normal_force is not None and wild.min_normal_force < 0.0
    events = wild.events("lift_off", count=4)
    assert events["up"].tolist() in ([True, False] * 2, [False, True] * 2)
    assert (wild.events("lift-off", count=4)["t"] == events["t"]).all()
    assert len(top.release(tilt=0.1, spin=150.0).events("lift_off")["t"]) == 0


def test_partials_are_derivatives(top: toytop.Top) -> None:
    from scipy.spatial.transform import Rotation

    motion = top.release(tilt=0.5, spin=120.0, precession=2.0, azimuth=0.4)
    t, launch = np.array([[0.0, 0.05], [0.3, 2.0]]), motion.at(0.0)
    partials = motion.partials(t)
    shapes = {name: array.shape for name, array in partials.items()}
    assert shapes == {
        **dict.fromkeys(["orientation", "omega", "omega_body", "axis"], (2, 2, 3, 10)),
        "tip": (2, 2, 2, 10),
        "tip_angle": (2, 2, 10),
    }
    assert toytop.Motion.partial_names[3] == "omega_x" and len(toytop.Motion.partial_names) == 10
    assert np.abs(partials["omega"][0, 0, :, 3:6] - np.eye(3)).max() < 1e-12
    step = 1e-6
    for column in range(6):
        ends = []
        for sign in (1.0, -1.0):
            change = np.zeros(6)
            change[column] = sign * step
            turn = Rotation.from_rotvec(change[:3])
            x, y, z, w = (turn * launch.rotation()).as_quat()
            ends.append(top.launch([w, x, y, z], turn.apply(launch.omega + change[3:])).at(t))
        for name in ("omega", "axis", "tip", "tip_angle", "omega_body"):
            slope = (getattr(ends[0], name) - getattr(ends[1], name)) / (2.0 * step)
            found = partials[name][..., column]
            assert np.abs(slope - found).max() < 1e-6 * max(1.0, np.abs(found).max()), (name, column)


def test_an_impulse_changes_the_momentum(top: toytop.Top, motion: toytop.Motion) -> None:
    impulse, point = np.array([1e-3, 2e-3, -1e-3]), np.array([0.02, 0.0, 0.03])
    for t in (0.0, 1.25):
        before, struck = motion.at(t), motion.with_impulse(impulse, point, t=t)
        after = struck.at(0.0)
        assert np.abs(after.quaternion - before.quaternion).max() < 1e-14
        reaction = motion.reaction_impulse(impulse, point, t=t)
        assert reaction[:2].tolist() == [0.0, 0.0]
        # balance of the angular momentum about the centre of mass
        a, c, s = top.transverse_inertia, top.axial_inertia, top.com_height
        change, axis = after.omega - before.omega, before.axis
        momentum = a * change + (c - a) * (change @ axis) * axis
        arm = before.rotation().apply(point) - s * axis
        moment = np.cross(arm, impulse) - s * np.cross(axis, reaction)
        assert np.abs(momentum - moment).max() < 1e-12 * np.abs(moment).max()
    body = toytop.Top.free(transverse_inertia=1.1e-3, axial_inertia=2.0e-3).release(tilt=0.4, spin=20.0)
    assert body.reaction_impulse(impulse, point).tolist() == [0.0, 0.0, 0.0]


def test_losses_are_fitted_with_a_drift(top: toytop.Top, motion: toytop.Motion) -> None:
    samples = toytop.simulate(motion, duration=0.5)
    assert toytop.fit(samples, top).losses is None
    losses = toytop.fit(samples, top, drift=1e-2).losses
    assert losses is not None and list(losses) == ["loss_axial", "loss_across", "loss_vertical"]
    assert all(abs(loss) < 5.0 * deviation <= 5e-2 for loss, deviation in losses.values())


@pytest.mark.parametrize(
    ("name", "arguments", "options"),
    [
        ("kind", ("turn",), {}),
        ("kind", ("lift_off",), {}),
        ("value", ("tilt",), {}),
        ("value", ("turning", 1.0), {}),
        ("value", ("tilt", 4.0), {}),
        ("value", ("circle", 2.0), {}),
        ("value", ("tip_angle", np.nan), {}),
        ("value", ("tip_angle", 2e6), {}),
        ("start", ("turning",), {"start": 1e300}),
        ("start", ("turning",), {"start": np.timedelta64(1, "s")}),
        ("count", ("turning",), {"count": -1}),
        ("sense", ("turning",), {"sense": "left"}),
    ],
)
def test_events_refuse_by_name(name: str, arguments: Any, options: Any) -> None:
    held = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5)
    motion = held.release(tilt=0.5, spin=200.0)
    with pytest.raises(ValueError, match=f"^{name}: "):
        motion.events(*arguments, **options)


def test_impulses_and_partials_refuse_by_name(motion: toytop.Motion) -> None:
    cases: list[tuple[str, Any]] = [
        ("impulse", lambda: motion.with_impulse([1e30, 0.0, 0.0], [0.0, 0.0, 0.0])),
        ("impulse", lambda: motion.reaction_impulse([0.0, 0.0], [0.0, 0.0, 0.0])),
        ("point", lambda: motion.with_impulse([0.0, 0.0, 1.0], [[0.0, 0.0, 0.0]])),
        ("t", lambda: motion.with_impulse([0.0, 0.0, 1.0], [0.0, 0.0, 0.0], t=1e300)),
        ("t", lambda: motion.partials(1e300)),
    ]
    for name, call in cases:
        with pytest.raises(ValueError, match=f"^{name}: "):
            call()

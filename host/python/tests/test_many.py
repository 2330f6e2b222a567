"""Many motions: tables are kept, samples are lazy, launches come from any columns, and everything can be sent to another process."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

import numpy as np
import pytest

import toytop
from toytop import _toytop

TIMES = np.linspace(0.0, 2.0, 33)


@pytest.fixture
def releases() -> dict[str, Any]:
    random = np.random.default_rng(1)
    return {"tilt": random.uniform(0.1, 1.0, 200), "spin": random.uniform(100.0, 300.0, 200)}


@pytest.fixture
def many(top: toytop.Top, releases: dict[str, Any]) -> toytop.Many:
    return toytop.many(top, releases)


def test_tables_are_kept_and_shared(many: toytop.Many) -> None:
    now = many.at(TIMES)
    assert now.quaternion is now.quaternion and now.quaternion.shape == (200, 33, 4)
    assert (many[7].at(TIMES).quaternion == now.quaternion[7]).all()
    assert (many.at(0.3, scalar="q31").u[7] == many[7].at(0.3, scalar="q31").u).all()


def test_slices_share_the_tables(many: toytop.Many) -> None:
    part = many[10:100:30]
    assert isinstance(part, toytop.Many) and len(part) == 3 and part[1] == many[40]
    assert (part.at(TIMES).u == many.at(TIMES).u[10:100:30]).all()
    assert len(many[300:]) == 0 and many[:0].at(TIMES).quaternion.shape == (0, 33, 4)
    assert [motion.e1 for motion in many[::-100]] == [many[199].e1, many[99].e1]


def test_launches_from_quaternions_and_rates(top: toytop.Top, many: toytop.Many) -> None:
    now = many.at(0.0)
    for rates in ({"omega": now.omega}, {"omega_body": now.omega_body}):
        again = toytop.many(top, quaternion=now.quaternion, **rates)
        assert np.abs(again.at(TIMES).quaternion - many.at(TIMES).quaternion).max() < 1e-11
        single = {name: rate[5] for name, rate in rates.items()}
        assert again[5] == top.launch(now.quaternion[5], **single)
    pytest.importorskip("scipy")
    turned = toytop.many([top] * 200, quaternion=now.rotation(), omega=now.omega)
    assert np.abs(turned.at(TIMES).quaternion - many.at(TIMES).quaternion).max() < 1e-11


def test_columns_begin_with_the_motion(many: toytop.Many) -> None:
    now = many.at(TIMES)
    columns = now.columns()
    assert list(columns)[:3] == ["motion", "t", "w"]
    assert {column.shape for column in columns.values()} == {(200 * 33,)}
    rows = columns["motion"] == 7
    assert (columns["t"][rows] == TIMES).all() and (columns["omega_y"][rows] == now.omega[7, :, 1]).all()


def test_arrays_are_read_only(many: toytop.Many) -> None:
    for now in (many.at(TIMES), many[0].at(TIMES), many[0].reference(0.1), many[0].at([0.1]).columns()):
        names = ("t", "quaternion", "u", "error_bound", "tip_angle")
        arrays = now.values() if isinstance(now, dict) else [getattr(now, name) for name in names]
        for array in arrays:
            with pytest.raises(ValueError, match="read-only"):
                array[...] = 0.0


def bits(samples: Any) -> bytes:
    return bytes(samples.quaternion.tobytes() + samples.tip_angle.tobytes() + samples.t.tobytes())


def test_samples_and_many_are_copied_and_pickled(top: toytop.Top, many: toytop.Many) -> None:
    held = toytop.Top.fixed(mass_moment=1.5e-3, transverse_inertia=7.5e-5, axial_inertia=2.0e-5)
    motion = held.release(tilt=0.4, spin=90.0)
    tops = toytop.many([top, held], {"tilt": 0.3, "spin": 150.0})
    for samples in (
        many.at(TIMES),
        tops.at(0.5, scalar="f32"),
        motion.at(TIMES[:3]),
        motion.at(0.5, scalar="q31"),
        motion.reference([0.1, 0.2]),
        motion.closed_form().at(TIMES),
    ):
        assert copy.copy(samples) is samples and copy.deepcopy(samples) is samples
        assert bits(pickle.loads(pickle.dumps(samples))) == bits(samples)
    for some in (many, many[3:9], tops):
        again = pickle.loads(pickle.dumps(some))
        assert copy.copy(some) is some and copy.deepcopy(some) is some
        assert len(again) == len(some) and all(one == other for one, other in zip(again, some, strict=True))


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_processes(many: toytop.Many, method: str) -> None:
    expected = bits(many.at(TIMES))
    with ProcessPoolExecutor(1, get_context(method)) as pool:
        assert pool.submit(bits, many.at(TIMES)).result(60) == expected
        halves = pool.map(toytop.Many.at, [many[:100], many[100:]], [TIMES, TIMES])
        assert np.concatenate([half.u for half in halves]).tobytes() == many.at(TIMES).u.tobytes()


@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_data_frames(top: toytop.Top, many: toytop.Many, releases: dict[str, Any], library: str) -> None:
    frames: Any = pytest.importorskip(library)
    make = frames.table if library == "pyarrow" else frames.DataFrame
    frame = make(releases)
    assert toytop.many(top, frame)[11] == many[11]
    assert (many[0].at(make({"t": TIMES})["t"]).u == many[0].at(TIMES).u).all()
    samples = make(toytop.simulate(many[0], duration=0.2))
    assert toytop.fit(samples, top).converged
    if library == "pandas":
        assert toytop.fit(samples.set_index("t"), top).converged
        with pytest.raises(ValueError, match="^t: must be numbers, not timedelta64"):
            many.at(frames.to_timedelta([1.0, 2.0], "s"))
    assert make(many.at(TIMES).columns()).shape == (200 * 33, 16)


def test_rows_of_one_axis_are_refused(top: toytop.Top) -> None:
    with pytest.raises(TypeError):
        _toytop.launch_many([top._core], "omega", np.zeros(7))

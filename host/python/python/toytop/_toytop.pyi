"""Compiled part of toytop. Import from toytop instead."""

from collections.abc import Sequence
from typing import Any, Literal, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "PARTIAL_NAMES",
    "ClosedFormCore",
    "FittedLaunch",
    "MotionCore",
    "Sampler",
    "TopCore",
    "__version__",
    "constant_of_many",
    "fit",
    "launch_many",
    "order",
    "sample_many",
    "score",
    "simulate",
]

PARTIAL_NAMES: list[str]
__version__: str

_Array: TypeAlias = NDArray[np.float64]
_Scalar: TypeAlias = Literal["f64", "f32", "q31", "q15"]

@final
class TopCore:
    def __new__(
        cls,
        support: str,
        transverse_inertia: float,
        axial_inertia: float,
        com_height: float,
        mass: float,
        mass_moment: float,
        gravity: float,
        rotor_momentum: float,
    ) -> TopCore: ...
    @property
    def support(self) -> Literal["sliding", "fixed", "free"]: ...
    def number(self, name: str) -> float: ...
    def e4(self) -> float | None: ...
    def given(self) -> list[tuple[str, float]]: ...
    def release(
        self, tilt: float, spin: float, precession: float, nutation: float, azimuth: float, roll: float
    ) -> MotionCore: ...
    def launch(self, quaternion: Sequence[float], name: str, omega: Sequence[float]) -> MotionCore: ...
    def branch_points(self, e: Sequence[float], positive: Sequence[bool], phases: Sequence[float]) -> MotionCore: ...

@final
class MotionCore:
    def __new__(cls, file: str, text: str) -> MotionCore: ...
    @property
    def top(self) -> TopCore: ...
    @property
    def regime(
        self,
    ) -> Literal[
        "nutating", "regular_precession", "sleeping_stable", "sleeping_unstable", "hanging", "aperiodic"
    ]: ...
    @property
    def tip_class(
        self,
    ) -> Literal["smooth", "cusp", "loops", "circle", "through_origin", "spiral", "point"]: ...
    def constant(self, name: str) -> float: ...
    def to_toml(self) -> str: ...
    def view(self) -> str: ...
    def tip_curve(self) -> str: ...
    def at(self, t: ArrayLike, scalar: _Scalar) -> Sampler: ...
    def error_bounds(self, t: float, scalar: _Scalar) -> list[float]: ...
    def events(
        self, kind: str, value: float | None, start: float, count: int, upward: bool | None
    ) -> _Array: ...
    def partials(self, t: ArrayLike) -> _Array: ...
    def with_impulse(self, impulse: Sequence[float], point: Sequence[float], t: float) -> MotionCore: ...
    def reaction_impulse(self, impulse: Sequence[float], point: Sequence[float], t: float) -> _Array: ...
    def reference(self, t: ArrayLike) -> Sampler: ...
    def reference_digits(self, t: ArrayLike, digits: int) -> tuple[list[list[str]], list[int]]: ...

@final
class Sampler:
    @property
    def times(self) -> _Array: ...
    @property
    def motions(self) -> int | None: ...
    def column(self, name: str) -> _Array: ...

@final
class ClosedFormCore:
    def __new__(cls, of: MotionCore) -> ClosedFormCore: ...
    @property
    def kind(
        self,
    ) -> Literal["free_body", "regular_precession", "aperiodic", "e3_equals_e4", "lagrange"]: ...
    def at(self, t: ArrayLike) -> Sampler: ...

@final
class FittedLaunch:
    def orientation_covariance(self, motion: MotionCore, t: ArrayLike) -> _Array: ...

def constant_of_many(motions: Sequence[MotionCore], name: str) -> _Array: ...
def fit(
    samples: dict[str, Any],
    top: TopCore,
    sensors: tuple[str, Any] | None,
    free: Sequence[str],
    huber: float,
    drift: float | None,
) -> dict[str, Any]: ...
def launch_many(tops: Sequence[TopCore], omega_name: str, rows: _Array) -> list[MotionCore]: ...
def order(runs: Sequence[tuple[float, float]]) -> float | None: ...
def sample_many(motions: Sequence[MotionCore], t: ArrayLike, scalar: _Scalar) -> Sampler: ...
def score(
    motion: MotionCore, t: _Array, quaternion: _Array, omega: _Array | None, in_body: bool
) -> dict[str, Any]: ...
def simulate(
    motion: MotionCore,
    sensors: tuple[str, Any] | None,
    hertz: float,
    duration: float,
    seed: int,
) -> dict[str, _Array]: ...

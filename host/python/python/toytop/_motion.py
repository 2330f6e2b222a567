"""The class Motion computes a motion at any time, and the class ClosedForm its closed form."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Literal, final

from . import _toytop
from ._arguments import number, vector
from ._constants import Constants
from ._notebook import Page
from ._samples import Samples, decimals

if TYPE_CHECKING:
    from os import PathLike

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._top import Top
    from ._toytop import _Array, _Scalar

# quantities of partial derivatives, and their components
PARTIALS = {"orientation": 3, "omega": 3, "omega_body": 3, "axis": 3, "tip": 2, "tip_angle": 1}


@final
class Motion(Constants):
    """Exact motion of one launch, at any time, past or future.

    It is made by a Top, or by Motion.from_toml from a scenario file, and is immutable: threads may share it. Its constants are
    attributes. The first call of at sets up a table, from which every time costs the same and has an error within a stated bound.

    Attributes:
        partial_names: names of the derivatives in the last axis of the arrays of partials.
    """

    __slots__ = ()
    partial_names: ClassVar[tuple[str, ...]] = tuple(_toytop.PARTIAL_NAMES)

    @staticmethod
    def from_toml(path: str | PathLike[str]) -> Motion:
        """Motion of a scenario file, whose keys host/scenarios/README.md explains.

        Raises:
            ValueError: a key is wrong; the message names the file, the key and what is allowed.
            OSError: the file cannot be read.
        """
        return Motion(_toytop.MotionCore(str(path), Path(path).read_text(encoding="utf-8")))

    @staticmethod
    def from_toml_text(text: str) -> Motion:
        """Motion of the text of a scenario file.

        Raises:
            ValueError: a key is wrong; the message names it and what is allowed.
        """
        return Motion(_toytop.MotionCore("text", text))

    def to_toml(self) -> str:
        """Text of a scenario file with this motion, exact to the last bit."""
        return self._core.to_toml()

    def at(self, t: ArrayLike, *, scalar: _Scalar = "f64") -> Samples:
        """Samples of the motion at time t, s: a number, or an array of any shape.

        Args:
            scalar: number type of the arithmetic, "f64", "f32", "q31" or "q15" (fixed point of 32 and of 16 bits); the arrays are
                float64 in any case, and hold the scalar's numbers without rounding.

        Raises:
            ValueError: t is not finite or beyond 2^62 ticks; no table in this scalar is large enough.
        """
        return Samples(self._core.at(t, scalar), (self, "at", {"scalar": scalar}))

    def error_bound(self, t: float = 0.0, *, scalar: _Scalar = "f64") -> float:
        """Upper bound on the orientation error at time t, rad: 2 sqrt(|d alpha|^2 + |d beta|^2), which is the angle of the rotation
        between both where it is small.
        """
        return self._core.error_bounds(number("t", t), scalar)[0]

    def rate_error_bound(self, t: float = 0.0, *, scalar: _Scalar = "f64") -> float:
        """Upper bound on the error of omega, omega_body and udot at time t, rad/s.

        For an aperiodic motion in f64, it is not derived: it is the error that the tests of the closed form allow.
        """
        return self._core.error_bounds(number("t", t), scalar)[1]

    def events(
        self,
        kind: Literal["turning", "tilt", "tip_angle", "circle", "lift_off", "tip-angle", "lift-off"],
        value: float | None = None,
        *,
        start: float = 0.0,
        count: int = 100,
        sense: Literal["up", "down"] | None = None,
    ) -> dict[str, NDArray[Any]]:
        """Events of the motion, in the order of time, as arrays by name.

        Args:
            kind: "turning": the tilt has an extreme value. "tilt": it has the given value, rad. "tip_angle": the tip angle has the given
                value, rad, whole turns aside. "circle": the tip is at the given distance from the centre, m (the sine of the tilt for a
                fixed tip). "lift_off": the normal force is 0. A hyphen may stand for the underscore, as in `toytop events`.
            value: of the kinds tilt, tip_angle and circle.
            start: time of the earliest event, s.
            count: greatest number of events, at most a million.
            sense: "up" or "down": only events at which u, the cosine of the tilt, increases or decreases, or the tip angle does; of
                turning points, only those with the least or with the greatest tilt.

        Returns:
            t (s), t_error (upper bound, s; NaN where none is known), up (bool), u, tip_x, tip_y, phi (tip angle).

        Raises:
            ValueError: an argument is out of range; the message names it.
        """
        if sense not in (None, "up", "down"):
            raise ValueError("sense: must be 'up' or 'down'")
        if not 1 <= count <= 1_000_000:
            raise ValueError("count: must be between 1 and 1000000")
        upward = None if sense is None else sense == "up"
        given = None if value is None else number("value", value)
        rows = self._core.events(kind, given, number("start", start), count, upward)
        t, t_error, up, u, tip_x, tip_y, phi = rows.T.copy()
        return {"t": t, "t_error": t_error, "up": up > 0.0, "u": u, "tip_x": tip_x, "tip_y": tip_y, "phi": phi}

    def partials(self, t: ArrayLike) -> dict[str, _Array]:
        """Partial derivatives at time t, s, as arrays by name: the shape of t comes first, then the components, then the ten
        derivatives that partial_names lists.

        They are with respect to the rotation vector (rad, fixed frame) that turns orientation and omega of the launch, to omega of the
        launch (rad/s, fixed frame), and to the numbers A/C, A/(p s) (A/p for a fixed tip), s and g of the top, while the launch and the
        other three are kept. Relative to the largest derivative of a column the error is about 1e-12.

        Returns:
            orientation (rotation vectors in the fixed frame, rad), omega, omega_body, axis, tip and tip_angle.

        Raises:
            ValueError: t is not finite or too far.
        """
        rows, end, partials = self._core.partials(t), 0, {}
        for name, components in PARTIALS.items():
            end += components
            partials[name] = rows[..., end - components : end, :]
        partials["tip_angle"] = partials["tip_angle"][..., 0, :]
        return partials

    def with_impulse(self, impulse: ArrayLike, point: ArrayLike, *, t: float = 0.0) -> Motion:
        """Motion after an impulse at time t, whose own time begins then.

        Args:
            impulse: N s, in the fixed frame.
            point: where it acts, m, in the body frame from the tip (from the centre of mass of a free body).
            t: time of the impulse, s.

        Raises:
            ValueError: a number is out of range; the message names it.
        """
        acting = vector("impulse", impulse, 3), vector("point", point, 3)
        return Motion(self._core.with_impulse(*acting, number("t", t)))

    def reaction_impulse(self, impulse: ArrayLike, point: ArrayLike, *, t: float = 0.0) -> _Array:
        """Impulse of the support's reaction to an impulse, N s in the fixed frame. Where its third component is negative, a real sliding
        top leaves the plane and does not follow the motion of with_impulse.

        Args:
            impulse, point, t: as those of with_impulse.

        Raises:
            ValueError: a number is out of range; the message names it.
        """
        acting = vector("impulse", impulse, 3), vector("point", point, 3)
        return self._core.reaction_impulse(*acting, number("t", t))

    def closed_form(self) -> ClosedForm:
        """Closed form of the motion, in elementary or elliptic functions.

        Raises:
            ValueError: the motion has none; the message says which motions do.
        """
        return ClosedForm(self)

    def reference(self, t: ArrayLike) -> Samples:
        """Truth at time t, s, rounded to float64: the paper's integrals in numbers of 640 bits, which share no formula and no
        arithmetic with Motion.at. Only the whole turns of tip_angle, and tip_angle near the centre, are those of Motion.at. It takes
        some milliseconds a time.

        Raises:
            ValueError: t is not finite or beyond 2^62 ticks.
        """
        return Samples(self._core.reference(t), (self, "reference", {}))

    def reference_digits(self, t: ArrayLike, *, digits: int = 30) -> NDArray[np.object_]:
        """Truth at time t, s, to as many digits as wanted: an array of decimal.Decimal with the quaternion w, x, y, z in its last
        axis.

        Args:
            digits: significant digits, from 1 to 50; the truth itself has more than thirty.
        """
        if not 1 <= digits <= 50:
            raise ValueError("digits: must be between 1 and 50")
        return decimals(*self._core.reference_digits(t, digits))

    def view(self) -> Page:
        """Page with the top in motion, for a notebook or a browser: it computes in the page itself and needs no network."""
        return Page(self._core.view())

    def _repr_html_(self) -> str:
        """Picture of the curve that the tip draws, for a notebook."""
        return self._core.tip_curve()

    @property
    def top(self) -> Top:
        """Top of the motion."""
        from ._top import Top

        return Top(self._core.top)

    def __repr__(self) -> str:
        return f"<Motion of a {self.top.support} top: {self.regime}, e1 = {self.e1}, e2 = {self.e2}, e3 = {self.e3}>"

    def __eq__(self, other: object, /) -> bool:
        return isinstance(other, Motion) and self.to_toml() == other.to_toml()

    def __hash__(self) -> int:
        return hash(self.to_toml())

    def __reduce__(self) -> tuple[Any, ...]:
        return Motion.from_toml_text, (self.to_toml(),)


@final
class ClosedForm:
    """Motion in elementary or elliptic functions: no step, no table, no quadrature. It is slower than Motion.at."""

    __slots__ = ("_core", "_motion")

    def __init__(self, motion: Motion, /) -> None:
        self._motion = motion
        self._core = _toytop.ClosedFormCore(motion._core)

    @property
    def kind(self) -> Literal["free_body", "regular_precession", "aperiodic", "e3_equals_e4", "lagrange"]:
        """Kind of the form."""
        return self._core.kind

    def at(self, t: ArrayLike) -> Samples:
        """Samples of the motion at time t, s: a number, or an array of any shape.

        Raises:
            ValueError: t is not finite, or beyond 1e12 periods.
        """
        return Samples(self._core.at(t), (self, "at", {}))

    def __reduce__(self) -> tuple[Any, ...]:
        return Motion.closed_form, (self._motion,)

    def __repr__(self) -> str:
        return f"<ClosedForm: {self.kind}>"

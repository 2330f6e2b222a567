"""The constants of a motion are attributes of its class."""

from typing import Literal

from . import _toytop


class Constants:
    """Constants of a motion."""

    __slots__ = ("_core",)

    def __init__(self, core: _toytop.MotionCore, /) -> None:
        self._core = core

    @property
    def regime(
        self,
    ) -> Literal["nutating", "regular_precession", "sleeping_stable", "sleeping_unstable", "hanging", "aperiodic"]:
        """Kind of motion: nutating, regular_precession, sleeping_stable, sleeping_unstable, hanging, aperiodic."""
        return self._core.regime

    @property
    def tip_class(self) -> Literal["smooth", "cusp", "loops", "circle", "through_origin", "spiral", "point"]:
        """Class of the curve of the tip: smooth, cusp, loops, circle, through_origin, spiral, point."""
        return self._core.tip_class

    @property
    def l(self) -> float:  # noqa: E743: the name of the paper
        """Angular momentum about the vertical (kg m²/s)."""
        return self._core.constant("l")

    @property
    def n(self) -> float:
        """Angular momentum about the symmetry axis, C spin + K (kg m²/s)."""
        return self._core.constant("n")

    @property
    def h(self) -> float:
        """Energy; the potential energy is 0 where the centre of mass is at the height of the tip (J)."""
        return self._core.constant("h")

    @property
    def e1(self) -> float:
        """Least cosine of the tilt."""
        return self._core.constant("e1")

    @property
    def e2(self) -> float:
        """Greatest cosine of the tilt."""
        return self._core.constant("e2")

    @property
    def e3(self) -> float:
        """Third root, at least 1, of the cubic whose other roots are e1 and e2; infinite without torque."""
        return self._core.constant("e3")

    @property
    def e4(self) -> float | None:
        """Measure √(1 + A/(p s)) of the effect of the sliding tip; none for a held tip or a free body."""
        return self._if_any("e4")

    @property
    def one_plus_e1(self) -> float:
        """Sum 1 + e1, without the rounding of e1."""
        return self._core.constant("one_plus_e1")

    @property
    def one_minus_e2(self) -> float:
        """Difference 1 - e2, without the rounding of e2."""
        return self._core.constant("one_minus_e2")

    @property
    def e2_minus_e1(self) -> float:
        """Difference e2 - e1, without the rounding of either."""
        return self._core.constant("e2_minus_e1")

    @property
    def e3_minus_e2(self) -> float:
        """Difference e3 - e2, without the rounding of either."""
        return self._core.constant("e3_minus_e2")

    @property
    def e3_minus_one(self) -> float:
        """Difference e3 - 1, without the rounding of e3."""
        return self._core.constant("e3_minus_one")

    @property
    def sign_l_plus_n(self) -> int:
        """Sign of l + n: 1 or -1; 1 for 0."""
        return int(self._core.constant("sign_l_plus_n"))

    @property
    def sign_l_minus_n(self) -> int:
        """Sign of l - n: 1 or -1; 1 for 0."""
        return int(self._core.constant("sign_l_minus_n"))

    @property
    def period(self) -> float | None:
        """Nutation period; where the tilt is constant, that of a small nutation; none where no motion nearby is periodic (s)."""
        return self._if_any("period")

    @property
    def alpha_turns(self) -> float | None:
        """Advance of the argument of the Cayley-Klein parameter α in a period, whole turns included (turns)."""
        return self._if_any("alpha_turns")

    @property
    def beta_turns(self) -> float | None:
        """Advance of the argument of the Cayley-Klein parameter β in a period, whole turns included (turns)."""
        return self._if_any("beta_turns")

    @property
    def phi_per_period(self) -> float | None:
        """Advance of the tip angle in a period; none where the axis is vertical (rad)."""
        return self._if_any("phi_per_period")

    @property
    def min_normal_force(self) -> float | None:
        """Least normal force of the plane, below 0 where a real top leaves it; none for a held tip or a free body (weights)."""
        return self._if_any("min_normal_force")

    def _if_any(self, name: str) -> float | None:
        """Constant of this name; None where it does not exist."""
        found = self._core.constant(name)
        return found if found == found else None

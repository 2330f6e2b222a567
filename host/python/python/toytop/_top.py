"""The class Top has the numbers of a top, and launches its motions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final, Literal, final

from . import _toytop
from ._arguments import rates, vector
from ._motion import Motion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

# default of gravity, m/s²
STANDARD_GRAVITY: Final = 9.80665


@final
class Top:
    """Symmetric top whose tip slides on a horizontal plane, or is held at a point, or a free symmetric body.

    It is made by Top.sliding, Top.fixed or Top.free, in SI or any consistent units, and is immutable.

    >>> import toytop
    >>> top = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)
    >>> motion = top.release(tilt=0.35, spin=150.0)
    >>> round(motion.period, 6)
    0.075985
    """

    __slots__ = ("_core",)

    def __init__(self, core: _toytop.TopCore, /) -> None:
        self._core = core

    @staticmethod
    def sliding(
        *,
        com_height: float,
        transverse_inertia: float,
        axial_inertia: float,
        mass: float = 0.0,
        mass_moment: float = 0.0,
        gravity: float = STANDARD_GRAVITY,
        rotor_momentum: float = 0.0,
    ) -> Top:
        """Top whose tip slides without friction on a horizontal plane: Springborn's toy top.

        Args:
            mass: mass M, kg; either this or mass_moment.
            mass_moment: mass moment p = M s, kg m.
            com_height: distance s of the centre of mass from the tip, m.
            transverse_inertia: moment of inertia A about a transverse axis through the centre of mass, kg m².
            axial_inertia: moment of inertia C <= 2A about the axis of symmetry, kg m².
            gravity: gravity g, m/s².
            rotor_momentum: axial angular momentum K of a wheel inside, relative to the body, kg m²/s.

        Raises:
            ValueError: a parameter is out of range; the message names it.
        """
        numbers = transverse_inertia, axial_inertia, com_height, mass, mass_moment, gravity, rotor_momentum
        return Top(_toytop.TopCore("sliding", *numbers))

    @staticmethod
    def fixed(
        *,
        transverse_inertia: float,
        axial_inertia: float,
        mass_moment: float = 0.0,
        mass: float = 0.0,
        com_height: float = 0.0,
        gravity: float = STANDARD_GRAVITY,
        rotor_momentum: float = 0.0,
    ) -> Top:
        """Top whose tip is held at a fixed point: the Lagrange top.

        Args:
            mass_moment: mass moment p = M s, kg m; either this, or mass and com_height.
            mass: mass M, kg.
            com_height: distance of the centre of mass from the tip, m; only together with mass.
            transverse_inertia: moment of inertia A about a transverse axis through the tip, kg m².
            axial_inertia: moment of inertia C about the axis of symmetry, kg m².
            gravity: gravity g, m/s².
            rotor_momentum: axial angular momentum K of a wheel inside, relative to the body, kg m²/s.

        Raises:
            ValueError: a parameter is out of range; the message names it.
        """
        numbers = transverse_inertia, axial_inertia, com_height, mass, mass_moment, gravity, rotor_momentum
        return Top(_toytop.TopCore("fixed", *numbers))

    @staticmethod
    def free(*, transverse_inertia: float, axial_inertia: float, rotor_momentum: float = 0.0) -> Top:
        """Body without torque: thrown, or in orbit. Its tip is 2 alpha beta, the axis as a complex number.

        Args:
            transverse_inertia: moment of inertia A about a transverse axis through the centre of mass, kg m².
            axial_inertia: moment of inertia C <= 2A about the axis of symmetry, kg m².
            rotor_momentum: axial angular momentum K of a wheel inside, relative to the body, kg m²/s.

        Raises:
            ValueError: a parameter is out of range; the message names it.
        """
        numbers = transverse_inertia, axial_inertia, 0.0, 0.0, 0.0, STANDARD_GRAVITY, rotor_momentum
        return Top(_toytop.TopCore("free", *numbers))

    def release(
        self,
        *,
        tilt: float,
        spin: float,
        precession: float = 0.0,
        nutation: float = 0.0,
        azimuth: float = 0.0,
        roll: float = 0.0,
    ) -> Motion:
        """Motion of this top when it is released with these angles (rad) and rates (rad/s).

        Args:
            tilt: angle of the axis from the upward vertical, in [0, pi].
            spin: the whole component of the angular velocity along the axis, precession included.
            precession: rate of the azimuth.
            nutation: rate of the tilt.
            azimuth: horizontal direction in which the axis leans, from the first fixed axis.
            roll: rotation of the body about its axis.

        Raises:
            ValueError: a number is out of range; the message names it.
        """
        return Motion(self._core.release(tilt, spin, precession, nutation, azimuth, roll))

    # quaternion: also a scipy Rotation, which is no dependency
    def launch(self, quaternion: Any, omega: ArrayLike | None = None, *, omega_body: ArrayLike | None = None) -> Motion:
        """Motion of this top from an orientation and an angular velocity, as sensors measure them.

        Args:
            quaternion: unit quaternion w, x, y, z from body to fixed coordinates, or a scipy Rotation. Its norm may differ from 1
                by 1e-6. The third body axis points from the tip to the centre of mass, the third fixed axis upward.
            omega: angular velocity in the fixed frame, rad/s; either this or omega_body.
            omega_body: angular velocity in the body frame, rad/s, as a gyroscope measures it.

        Raises:
            ValueError: a number is out of range; the message names it.
        """
        name, rate = rates(omega, omega_body)
        if rate is None:
            raise ValueError("omega: must be given, or else omega_body")
        return Motion(self._core.launch(vector("quaternion", quaternion, 4), name, vector(name, rate, 3)))

    def branch_points(
        self,
        e1: float,
        e2: float,
        e3: float,
        *,
        sign_l_plus_n: float,
        sign_l_minus_n: float,
        nutation_phase: float = 0.0,
        arg_alpha: float = 0.0,
        arg_beta: float = 0.0,
    ) -> Motion:
        """Motion of this top with given branch points -1 <= e1 <= e2 <= 1 <= e3 of the paper: u, the cosine of the tilt, oscillates
        between e1 and e2.

        Args:
            sign_l_plus_n, sign_l_minus_n: signs of l + n and of l - n, 1 or -1.
            nutation_phase: phase of the nutation at t = 0, rad: 0 at u = e1, pi at u = e2.
            arg_alpha, arg_beta: arguments of the Cayley-Klein parameters at t = 0, rad; of the derivative where a parameter is 0.

        Raises:
            ValueError: a number is out of range; the message names it.
        """
        for name, sign in (("sign_l_plus_n", sign_l_plus_n), ("sign_l_minus_n", sign_l_minus_n)):
            if sign not in (1, -1):
                raise ValueError(f"{name}: must be 1 or -1")
        signs, phases = (sign_l_plus_n > 0, sign_l_minus_n > 0), (nutation_phase, arg_alpha, arg_beta)
        return Motion(self._core.branch_points((e1, e2, e3), signs, phases))

    @property
    def support(self) -> Literal["sliding", "fixed", "free"]:
        """Support of the tip: "sliding", "fixed" or "free"."""
        return self._core.support

    @property
    def transverse_inertia(self) -> float:
        """Transverse moment of inertia A, kg m²: about the centre of mass for a sliding tip, about the tip for a fixed one."""
        return self._core.number("transverse_inertia")

    @property
    def axial_inertia(self) -> float:
        """Axial moment of inertia C, kg m²."""
        return self._core.number("axial_inertia")

    @property
    def com_height(self) -> float:
        """Distance s of the centre of mass from a sliding tip, m; 0 for a fixed tip, for which only the mass moment matters."""
        return self._core.number("com_height")

    @property
    def mass_moment(self) -> float:
        """Mass moment p = M s, kg m."""
        return self._core.number("mass_moment")

    @property
    def gravity(self) -> float:
        """Gravity g, m/s²."""
        return self._core.number("gravity")

    @property
    def rotor_momentum(self) -> float:
        """Axial angular momentum K of a wheel inside, relative to the body, kg m²/s."""
        return self._core.number("rotor_momentum")

    @property
    def e4(self) -> float | None:
        """Branch point e4 = sqrt(1 + A/(p s)); None for a fixed tip and for a free body."""
        return self._core.e4()

    def __repr__(self) -> str:
        arguments = ", ".join(f"{name}={number!r}" for name, number in self._core.given())
        return f"Top.{self.support}({arguments})"

    def __eq__(self, other: object, /) -> bool:
        return isinstance(other, Top) and repr(self) == repr(other)

    def __hash__(self) -> int:
        return hash(repr(self))

    def __reduce__(self) -> tuple[Any, ...]:
        return _remade, (self.support, dict(self._core.given()))


def _remade(support: str, numbers: dict[str, float]) -> Any:
    """Top of the arguments of its repr."""
    return getattr(Top, support)(**numbers)

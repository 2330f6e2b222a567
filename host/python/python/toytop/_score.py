"""The output of an integrator is compared with the exact motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

from . import _toytop
from ._arguments import finite, rates, rows
from ._motion import Motion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def score(
    motion: Motion,
    t: ArrayLike,
    quaternion: Any,
    *,
    omega: ArrayLike | None = None,
    omega_body: ArrayLike | None = None,
) -> Score:
    """Errors of the output of an integrator against the exact motion.

    The integrator starts from the state of motion.at(t[0]).

    Args:
        t: times, s, which go on in one direction.
        quaternion: an array of shape (len(t), 4) with w, x, y, z from body to fixed coordinates, or a scipy Rotation.
        omega: angular velocities in the fixed frame, rad/s, of shape (len(t), 3).
        omega_body: angular velocities in the body frame instead. Without either, the drifts are None.

    Raises:
        ValueError: an array is of the wrong shape, holds no rotation, or t does not go on; the message names it.
    """
    name, rate = rates(omega, omega_body)
    times, quaternions = finite("t", t).ravel(), rows("quaternion", quaternion, 4)
    velocities = None if rate is None else rows(name, rate, 3)
    for column, array in (("quaternion", quaternions), (name, velocities)):
        if array is not None and len(array) != len(times):
            raise ValueError(f"{column}: must have {len(times)} rows, as t; has {len(array)}")
    if len(times) == 0 or not ((times[1:] > times[:-1]).all() or (times[1:] < times[:-1]).all()):
        raise ValueError("t: must be at least one time, and go on in one direction")
    found = _toytop.score(motion._core, times, quaternions, velocities, name == "omega_body")
    del found["max_position_error"]  # the arrays have no positions
    return Score(**{key.removesuffix("_rad"): value for key, value in found.items()})


def order(steps: ArrayLike, errors: ArrayLike) -> float | None:
    """Order of convergence, fitted to the errors of several step sizes; None where fewer than two of them tell it."""
    given, found = finite("steps", steps).ravel(), finite("errors", errors).ravel()
    if len(given) != len(found):
        raise ValueError(f"errors: must be {len(given)} numbers, as steps")
    return _toytop.order(list(zip(given.tolist(), found.tolist(), strict=True)))


@final
@dataclass(frozen=True, repr=False)
class Score:
    """Errors of an integrator's output against the exact motion.

    Attributes:
        max_error: greatest error of the orientation, 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer sign, rad.
        rms_error: root of the mean square error of the orientation, rad.
        final_error: error of the orientation in the last row, rad.
        max_u_error: greatest error of u, the cosine of the tilt.
        nutation_error: phase error of the nutation over the last nutation period, rad, above 0 where the result is ahead; None where the
            axis does not nutate, or for an aperiodic motion.
        precession_error: phase error of the precession over the last nutation period, rad; None where the axis is vertical.
        spin_error: phase error of the spin over the last nutation period, rad.
        residual: root of the mean square of the error that no phase error explains, rad.
        drift_h: greatest change of h in units of the greater of |h| and p g; None without angular velocity.
        drift_l: greatest change of l in units of the greatest of |l|, |n| and sqrt(2 A p g); None without angular velocity.
        drift_n: greatest change of n in the unit of drift_l; None without angular velocity.
        max_norm_error: greatest distance of the quaternions from unit norm.
        truth_bound: upper bound on the error of the exact motion itself, rad.
        warning: likely reason why the first row is far from the motion, if it is; otherwise None.
    """

    max_error: float
    rms_error: float
    final_error: float
    max_u_error: float
    nutation_error: float | None
    precession_error: float | None
    spin_error: float | None
    residual: float | None
    drift_h: float | None
    drift_l: float | None
    drift_n: float | None
    max_norm_error: float
    truth_bound: float
    warning: str | None

    def __repr__(self) -> str:
        errors = self.max_error, self.rms_error, self.final_error
        return "<Score: greatest error {:.1e} rad, rms {:.1e} rad, last {:.1e} rad>".format(*errors)

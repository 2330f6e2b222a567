"""A launch is fitted to samples of sensors, and sensors are simulated."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, final

from . import _toytop
from ._arguments import columns, number, numbers
from ._motion import Motion
from ._top import Top

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._toytop import _Array

    _Free: TypeAlias = Literal[
        "transverse_inertia", "axial_inertia", "com_height", "mass", "mass_moment", "gravity"
    ]
    _Sensors: TypeAlias = Mapping[str, Any] | str | os.PathLike[str] | None


def fit(
    samples: Any,
    top: Top,
    sensors: _Sensors = None,
    *,
    free: Sequence[_Free] = (),
    huber: float = 3.0,
    drift: float | None = None,
) -> Fitted:
    """Launch of a top, fitted to samples of sensors on it or beside it, without a first guess.

    A launch that must not be trusted has converged = False and a reason; this is no exception.

    Args:
        samples: columns by name, in a mapping, a structured array or a data frame: t (s), and those of the sensors, such as gyro_x,
            gyro_y, gyro_z. NaN means that a sensor has no reading at this time. Other columns are not read.
        top: the top.
        sensors: noise, bias, range and mounting of the sensors, as a mapping of mappings with the keys of host/docs/fit.md, such as
            {"gyroscope": {"noise": 0.002}}, or the path of such a TOML file; without it, those of a telephone, as far as the samples
            have their columns.
        free: names of numbers of the top that are unknown too, at most four, such as ["axial_inertia"].
        huber: residual, in standard deviations, from which a sample is an outlier, at least 1; inf for least squares.
        drift: expected loss of rotation, 1/s: 1/60 if the spin may be lost in a minute. The losses are then unknowns too, and the launch
            is that of the last sample.

    Raises:
        ValueError: a column, a sensor, a key or a row is wrong; the message names it.
    """
    import numpy as np

    given = columns("samples", samples)
    found = _toytop.fit(given, top._core, described(sensors), free, huber, drift)
    launched, drifted = found["launched"], found["drift"]
    covariance = np.array(found["covariance"])
    deviations = np.sqrt(covariance.diagonal())
    of_losses = deviations[6 + len(found["free"]) :].tolist()
    found.update(
        _launched=launched if isinstance(launched, str) else Motion(launched),
        quaternion=np.array(found["quaternion"]),
        omega=np.array(found["omega"]),
        spin=(found["spin"], found["spin_deviation"]),
        covariance=covariance,
        deviations=deviations,
        drift=drifted and (np.array(drifted["rates"]), np.array(drifted["deviation"])),
        free={key: (one["value"], one["deviation"]) for key, one in found["free"].items()},
        losses=drifted and dict(zip(found["loss_names"], zip(drifted["losses"], of_losses, strict=False), strict=True)),
        biases={
            name: (np.array(one["value"]), np.array(one["deviation"])) for name, one in found["biases"].items()
        },
    )
    return Fitted(**{field.name: found[field.name] for field in fields(Fitted)})


def simulate(
    motion: Motion,
    sensors: _Sensors = None,
    *,
    hertz: float = 1000.0,
    duration: float = 1.0,
    seed: int = 1,
) -> dict[str, _Array]:
    """Samples that sensors on a top would give: arrays by name, as fit takes them, with NaN where a sensor has no reading.

    Args:
        sensors: as those of fit; without it, a gyroscope, an accelerometer and a magnetometer of a telephone at the centre of mass.
        hertz: samples a second.
        duration: length of the recording, s, from t = 0.
        seed: another seed gives other noise and other biases.

    Raises:
        ValueError: a number or a sensor is wrong, or the motion has no period and cannot be followed for so long.
    """
    rate, length = number("hertz", hertz), number("duration", duration)
    return _toytop.simulate(motion._core, described(sensors), rate, length, seed)


def described(sensors: _Sensors) -> tuple[str, Any] | None:
    """Name of a description of sensors, and the mapping or the text of the TOML file."""
    if sensors is None:
        return None
    if isinstance(sensors, Mapping):
        return "sensors", plain(sensors)
    try:
        path = os.fspath(sensors)
    except TypeError:
        raise TypeError("sensors: must be a mapping or the path of a file") from None
    return path, Path(path).read_text(encoding="utf-8")


def plain(value: Any) -> Any:
    """Mappings, numbers and arrays of numbers as dictionaries, floats and lists."""
    if isinstance(value, Mapping):
        return {str(name): plain(inner) for name, inner in value.items()}
    array = numbers("sensors", value)
    return array.ravel().tolist() if array.ndim else float(array)


@final
@dataclass(frozen=True, eq=False, repr=False)
class Fitted:
    """Launch of a top fitted to samples, with its error bars. It is made by toytop.fit.

    Attributes:
        reason: reason why the launch must not be trusted; None where it may be.
        epoch: time of the launch among the samples, s: that of the first one; with a drift, that of the last one.
        quaternion: quaternion w, x, y, z of the launch.
        omega: angular velocity of the launch in the fixed frame, rad/s.
        spin: component of the angular velocity along the axis, rad/s, and its standard deviation.
        tilt: angle of the axis from the upward vertical at the epoch, rad, and its standard deviation.
        covariance: covariance of the unknowns. In a direction that is undetermined the standard deviation is 10 rad, or ten times omega.
        deviations: standard deviations of the unknowns.
        drift: mean rates of change of the first integrals l, n (N m) and h (W) during the samples, and their standard deviations; None
            where no drift was fitted.
        free: free numbers of the top by name, each with its standard deviation.
        losses: losses of rotation about the axis, across it, and about the vertical, in units of the rotation itself per second, each
            with its standard deviation; None where no drift was fitted.
        biases: biases by sensor: three values, and their standard deviations.
        undetermined: directions of the launch that the samples do not determine: "yaw", "roll", "spin", or "other".
        alternatives: number of other launches that fit the first samples as well.
        chi_squared: sum of the squares of the residuals in standard deviations, those of outliers at the limit.
        reduced_chi_squared: sum of squares by degrees of freedom: about 1 where the model and the noise are right.
        used: number of values that were used.
        saturated: number of values at the end of their range, which were not used.
        outliers: number of values beyond the Huber limit.
        residuals: residuals in standard deviations by column, and t; NaN where there is no reading or it is at the end of its range. Those
            of an orientation are x, y, z of the rotation vector in the fixed frame.
    """

    _core: _toytop.FittedLaunch
    _launched: Motion | str
    reason: str | None
    epoch: float
    quaternion: _Array
    omega: _Array
    spin: tuple[float, float]
    tilt: tuple[float, float]
    covariance: _Array
    deviations: _Array
    drift: tuple[_Array, _Array] | None
    free: dict[str, tuple[float, float]]
    losses: dict[str, tuple[float, float]] | None
    biases: dict[str, tuple[_Array, _Array]]
    undetermined: list[Literal["yaw", "roll", "spin", "other"]]
    alternatives: int
    chi_squared: float
    reduced_chi_squared: float
    used: int
    saturated: int
    outliers: int
    residuals: dict[str, _Array]

    @property
    def converged(self) -> bool:
        """Whether the launch may be trusted."""
        return self.reason is None

    @property
    def unknowns(self) -> list[str]:
        """Names of the rows and columns of the covariance, in this order:

        * rotation vector of the orientation in the fixed frame, rad;
        * change of omega in the frame that this rotation turns, rad/s, so that an uncertain yaw does not make omega uncertain;
        * logarithms of the free numbers of the top;
        * losses of rotation, 1/s, if there is a drift;
        * biases, in the units of their sensors.
        """
        of_biases = [f"{name}_bias_{axis}" for name in self.biases for axis in "xyz"]
        return [*Motion.partial_names[:6], *self.free, *(self.losses or ()), *of_biases]

    @property
    def motion(self) -> Motion:
        """Motion of the launch, whose t = 0 is the epoch.

        Raises:
            ValueError: the fit has not converged.
        """
        if isinstance(self._launched, str):
            raise ValueError(f"motion: {self._launched}")
        return self._launched

    def orientation_covariance(self, t: ArrayLike) -> _Array:
        """Covariance of the predicted orientation at the time t of the motion, as a rotation vector in the fixed frame, rad²: the shape
        of t comes first, (..., 3, 3).

        Raises:
            ValueError: the fit has not converged, or the motion has no period and cannot be followed for so long.
        """
        return self._core.orientation_covariance(self.motion._core, t)

    def __repr__(self) -> str:
        if self.reason is not None:
            return f"<Fitted: not converged: {self.reason}>"
        (spin, spin_deviation), (tilt, tilt_deviation) = self.spin, self.tilt
        return (
            f"<Fitted: tilt {tilt:.6f} +- {tilt_deviation:.1e} rad, spin {spin:.6f} +- {spin_deviation:.1e} rad/s, "
            f"reduced chi squared {self.reduced_chi_squared:.3f}>"
        )

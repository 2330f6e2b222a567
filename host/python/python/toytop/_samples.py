"""Samples are motions at given times, as arrays and as columns of a table."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from importlib import import_module
from operator import methodcaller
from typing import TYPE_CHECKING, Any, Literal, final

from . import _toytop

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._toytop import _Array


@final
class Samples:
    """A motion at given times, or many of them, as arrays. An attribute is computed when it is first asked for, and kept.

    The number of motions, if there are many, and the shape of t come first in every array; vectors and quaternions add an axis. The
    arrays are read-only. Frames: the third fixed axis points upward, the third body axis from the tip to the centre of mass.
    """

    __slots__ = ("_arrays", "_origin", "_sampler")

    def __init__(self, sampler: _toytop.Sampler, origin: tuple[Any, str, dict[str, str]], /) -> None:
        self._arrays: dict[str, _Array] = {}
        self._sampler = sampler
        self._origin = origin

    def _array(self, name: str) -> _Array:
        """Array of the quantity of this name, kept for the next call."""
        if name not in self._arrays:
            self._arrays.setdefault(name, self._sampler.column(name))
        return self._arrays[name]

    @property
    def t(self) -> _Array:
        """Times, s."""
        import numpy as np

        times, motions = self._sampler.times, self._sampler.motions
        return np.broadcast_to(times, times.shape if motions is None else (motions, *times.shape))

    @property
    def quaternion(self) -> _Array:
        """Unit quaternions w, x, y, z (scalar first) from body to fixed coordinates. Their sign is continuous in time."""
        return self._array("quaternion")

    @property
    def axis(self) -> _Array:
        """Unit vectors from the tip to the centre of mass, in the fixed frame."""
        return self._array("axis")

    @property
    def u(self) -> _Array:
        """Cosines of the tilt."""
        return self._array("u")

    @property
    def udot(self) -> _Array:
        """Rates of u, 1/s."""
        return self._array("udot")

    @property
    def omega(self) -> _Array:
        """Angular velocities in the fixed frame, rad/s."""
        return self._array("omega")

    @property
    def omega_body(self) -> _Array:
        """Angular velocities in the body frame, rad/s."""
        return self._array("omega_body")

    @property
    def tip(self) -> _Array:
        """Positions x, y of the tip on the plane relative to the point below the centre of mass, m; for a fixed tip minus the
        horizontal part of the axis, without unit.
        """
        return self._array("tip")

    @property
    def tip_angle(self) -> _Array:
        """Angles of the tip's position, continued from t = 0, rad; NaN where the axis is vertical at all times."""
        return self._array("phi")

    @property
    def error_bound(self) -> _Array:
        """Upper bounds on the orientation error, rad; NaN where none is known, as for a closed form."""
        return self._array("error_bound")

    def euler(self, sequence: Literal["zxz", "zyz"] = "zxz") -> _Array:
        """Euler angles, rad: of the sequence "zxz" (phi, theta, psi: Rz(phi) Rx(theta) Rz(psi)) or "zyz" (azimuth, tilt, roll, as
        Top.release takes them: Rz(azimuth) Ry(tilt) Rz(roll)).

        Raises:
            ValueError: another sequence; rotation().as_euler has all.
        """
        if sequence == "zxz":
            return self._array("euler_zxz")
        if sequence != "zyz":
            raise ValueError("sequence: must be 'zxz' or 'zyz'; rotation().as_euler() has all")
        angles = self._array("angles")[..., [1, 0, 2]]
        angles.setflags(write=False)
        return angles

    def rotation(self) -> Any:
        """Rotations from body to fixed coordinates as one scipy.spatial.transform.Rotation, for at most one axis of times and motions."""
        import numpy as np

        transform = import_module("scipy.spatial.transform")
        return transform.Rotation.from_quat(np.roll(self.quaternion, -1, axis=-1))

    def columns(self) -> dict[str, NDArray[Any]]:
        """Columns of a table, one-dimensional arrays by name: t, w, x, y, z (quaternion), omega_x, omega_y, omega_z (fixed frame),
        omega_body_x, omega_body_y, omega_body_z (body frame), u, tip_x, tip_y, phi (tip angle). Samples of many motions begin
        with the column motion, the index of the motion.
        """
        import numpy as np

        times, motions = self._sampler.times, self._sampler.motions
        columns: dict[str, NDArray[Any]] = {}
        if motions is not None:
            columns["motion"] = np.arange(motions).repeat(times.size)
        columns["t"] = self.t.ravel()
        quantities = {
            "w x y z": self.quaternion,
            "omega_x omega_y omega_z": self.omega,
            "omega_body_x omega_body_y omega_body_z": self.omega_body,
            "u": self.u,
            "tip_x tip_y": self.tip,
            "phi": self.tip_angle,
        }
        for names, numbers in quantities.items():
            columns |= zip(names.split(), numbers.reshape(-1, len(names.split())).T)
        return columns

    def __len__(self) -> int:
        if not self.t.shape:
            raise TypeError("samples at a single time have no length")
        return len(self.t)

    def __repr__(self) -> str:
        return f"<Samples of shape {list(self.t.shape)}>"

    def __copy__(self) -> Samples:
        return self

    def __deepcopy__(self, _memo: Any) -> Samples:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        source, method, options = self._origin
        return methodcaller(method, self._sampler.times, **options), (source,)


def decimals(texts: Sequence[Sequence[str]], shape: Sequence[int]) -> NDArray[np.object_]:
    """Rows of decimal numbers in an array whose first axes have this shape."""
    import numpy as np

    numbers = np.array([Decimal(text) for row in texts for text in row], dtype=object)
    return numbers.reshape(*shape, 4)

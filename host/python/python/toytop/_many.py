"""Motions of many tops or many launches are computed on all cores."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, final, overload

from . import _toytop
from ._arguments import columns, finite, rates, rows
from ._motion import Motion
from ._samples import Samples
from ._top import Top

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._toytop import _Scalar

RELEASE = ("tilt", "spin", "precession", "nutation", "azimuth", "roll")
REQUIRED = RELEASE[:2]


def many(
    tops: Top | Iterable[Top],
    releases: Any = None,
    *,
    quaternion: Any = None,
    omega: ArrayLike | None = None,
    omega_body: ArrayLike | None = None,
) -> Many:
    """Motions of many tops or many launches.

    Tops and launches are equal in number, or one of them is single.

    Args:
        tops: a Top for all, or a sequence of them.
        releases: a mapping from the arguments of Top.release to numbers or one-dimensional arrays, such as a dict or a data frame, or a
            sequence of mappings to numbers.
        quaternion: in place of releases, an array of shape (n, 4) with w, x, y, z from body to fixed coordinates, or a scipy Rotation.
        omega: angular velocities in the fixed frame, rad/s, of shape (n, 3); either this or
        omega_body: angular velocities in the body frame, rad/s, of shape (n, 3).

    Raises:
        ValueError: a number is out of range; the message names the launch and the number.
    """
    import numpy as np

    cores = [top._core for top in ([tops] if isinstance(tops, Top) else tops)]
    name, rate = rates(omega, omega_body)
    if releases is not None and quaternion is None and rate is None:
        kind, launches = "releases", release_rows(releases)
    elif releases is None and quaternion is not None and rate is not None:
        kind, quaternions, velocities = "quaternion", rows("quaternion", quaternion, 4), rows(name, rate, 3)
        if len(velocities) != len(quaternions):
            raise ValueError(f"{name}: must have {len(quaternions)} rows, as quaternion; has {len(velocities)}")
        launches = np.hstack([quaternions, velocities])
    else:
        raise ValueError("releases: must be given, or else quaternion and one of omega and omega_body")
    for given, length in (("tops", len(cores)), (kind, len(launches))):
        if length == 0:
            raise ValueError(f"{given}: must not be empty")
    if len(cores) != len(launches) and 1 not in (len(cores), len(launches)):
        raise ValueError(f"tops: must be one or {len(launches)} as {kind}, not {len(cores)}")
    return Many([Motion(core) for core in _toytop.launch_many(cores, name, launches)])


@final
class Many:
    """Motions of many tops or many launches, computed on all cores without the interpreter's lock.

    An index gives a Motion, a slice another Many with the same tables. The first call of at sets up the tables, some ten kilobytes a
    motion, which are kept.
    """

    __slots__ = ("_motions",)

    def __init__(self, motions: Sequence[Motion], /) -> None:
        self._motions = motions

    def at(self, t: ArrayLike, *, scalar: _Scalar = "f64") -> Samples:
        """Samples of all motions at time t, s: a number or an array for all, whose shape follows the number of motions in the arrays.

        Args:
            scalar: as that of Motion.at.

        Raises:
            ValueError: t is not finite or beyond 2^62 ticks of a motion.
        """
        cores = [motion._core for motion in self._motions]
        return Samples(_toytop.sample_many(cores, t, scalar), (self, "at", {"scalar": scalar}))

    def constant(self, name: str) -> NDArray[np.float64]:
        """Constant of every motion as an array, NaN where it does not exist.

        Args:
            name: as in `toytop constants --format json`: e1, period, min_normal_force and others.

        Raises:
            ValueError: there is no constant of this name; the message lists them.
        """
        return _toytop.constant_of_many([motion._core for motion in self._motions], name)

    def __len__(self) -> int:
        return len(self._motions)

    @overload
    def __getitem__(self, index: int, /) -> Motion: ...
    @overload
    def __getitem__(self, index: slice, /) -> Many: ...
    def __getitem__(self, index: int | slice, /) -> Motion | Many:
        found = self._motions[index]
        return found if isinstance(found, Motion) else Many(found)

    def __iter__(self) -> Iterator[Motion]:
        return iter(self._motions)

    def __repr__(self) -> str:
        return f"<Many: {len(self)} motions>"

    def __copy__(self) -> Many:
        return self

    def __deepcopy__(self, _memo: Any) -> Many:
        return self


def release_rows(releases: Any) -> NDArray[np.float64]:
    """Rows of the numbers of a release, one for each launch."""
    import numpy as np

    if not isinstance(releases, (list, tuple)):
        return rows_of_columns("releases", releases)
    found = [rows_of_columns(f"releases[{index}]", release) for index, release in enumerate(releases)]
    for index, row in enumerate(found):
        if len(row) != 1:
            raise ValueError(f"releases[{index}]: must hold numbers, not arrays")
    return np.concatenate([np.empty((0, len(RELEASE))), *found])


def rows_of_columns(parameter: str, release: Any) -> NDArray[np.float64]:
    """Rows of a mapping from names to numbers or arrays; a number, or an array of one, counts for all rows."""
    import numpy as np

    given = columns(parameter, release)
    for name in given:
        if name not in RELEASE:
            raise ValueError(f"{parameter}: {name}: unknown; allowed: {', '.join(RELEASE)}")
    for name in REQUIRED:
        if name not in given:
            raise ValueError(f"{parameter}: {name}: missing")
    read = {name: finite(f"{parameter}: {name}", given[name]) for name in RELEASE if name in given}
    length = next((column.size for column in read.values() if column.ndim and column.size != 1), 1)
    found = np.zeros((length, len(RELEASE)))
    for name, column in read.items():
        if column.ndim > 1 or column.size not in (1, length):
            raise ValueError(f"{parameter}: {name}: must be a number or of shape ({length},), as the others")
        found[:, RELEASE.index(name)] = column
    return found

"""Arguments are read as numbers, arrays, rows, and columns by name."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def numbers(name: str, given: Any) -> NDArray[np.float64]:
    """Array of anything that numpy.asarray makes an array of numbers of; a scipy Rotation becomes quaternions w, x, y, z.

    Raises:
        ValueError: dates, intervals, texts, or an array with a mask; the message begins with the name.
    """
    import numpy as np

    if name == "quaternion" and hasattr(given, "as_quat"):
        given = np.roll(given.as_quat(), 1, axis=-1)
    if hasattr(given, "mask") and hasattr(given, "filled"):
        raise ValueError(f"{name}: must have no mask: use its method filled or compressed")
    try:
        array = np.asarray(given)
        numbers = np.asarray(array, dtype=np.float64) if array.dtype.kind in "iufO" else None
    except Exception as error:
        raise ValueError(f"{name}: must be numbers ({error})") from None
    if numbers is None:
        raise ValueError(f"{name}: must be numbers, not {array.dtype}")
    return numbers


def finite(name: str, given: Any) -> NDArray[np.float64]:
    """Array of finite numbers.

    Raises:
        ValueError: as numbers, or a number is not finite.
    """
    import numpy as np

    array = numbers(name, given)
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: must be finite")
    return array


def rows(name: str, given: Any, width: int) -> NDArray[np.float64]:
    """Array of finite numbers in rows of this width.

    Raises:
        ValueError: as finite, or another shape.
    """
    array = finite(name, given)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name}: must be of shape (n, {width}), not {list(array.shape)}")
    return array


def number(name: str, given: Any) -> float:
    """Finite number.

    Raises:
        ValueError: as finite, or an array.
    """
    if type(given) is float and math.isfinite(given):
        return given
    found = finite(name, given)
    if found.ndim:
        raise ValueError(f"{name}: must be a number, not of shape {list(found.shape)}")
    return float(found)


def vector(name: str, given: Any, length: int) -> list[float]:
    """Finite numbers, this many.

    Raises:
        ValueError: as finite, or another shape.
    """
    found = finite(name, given)
    if found.shape != (length,):
        raise ValueError(f"{name}: must be {length} numbers, not of shape {list(found.shape)}")
    return [float(x) for x in found]


def rates(omega: Any, omega_body: Any) -> tuple[str, Any]:
    """Name and value of the one of two angular velocities that is given; the value is None where neither is.

    Raises:
        ValueError: both are given.
    """
    if omega is None and omega_body is not None:
        return "omega_body", omega_body
    if omega_body is not None:
        raise ValueError("omega: must be left out if omega_body is given")
    return "omega", omega


def columns(parameter: str, given: Any) -> dict[str, Any]:
    """Columns by name of a mapping, a structured array, or a data frame of pandas, polars or pyarrow.

    The index of a data frame of pandas is a column if it has a name.

    Raises:
        TypeError: there are no columns.
    """
    if getattr(getattr(given, "index", None), "name", None) is not None:
        given = given.reset_index()
    names = getattr(getattr(given, "dtype", None), "names", None)
    for attribute in ("column_names", "keys", "columns"):
        if names is None:
            names = getattr(given, attribute, None)
    if names is None:
        raise TypeError(f"{parameter}: must be columns by name, as a mapping or a data frame")
    return {str(name): given[name] for name in (names() if callable(names) else names)}

"""Samples as columns of a table, and as decimal numbers."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Any

from . import _toytop

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def columns(samples: _toytop.Samples, motions: int | None, times: int) -> dict[str, NDArray[Any]]:
    """One-dimensional arrays by name, as Samples.columns returns them."""
    import numpy as np

    columns: dict[str, NDArray[Any]] = {} if motions is None else {"motion": np.arange(motions).repeat(times)}
    columns["t"] = samples.t.ravel()
    quantities = {
        "w x y z": samples.quaternion,
        "omega_x omega_y omega_z": samples.omega,
        "omega_body_x omega_body_y omega_body_z": samples.omega_body,
        "u": samples.u,
        "tip_x tip_y": samples.tip,
        "phi": samples.tip_angle,
    }
    for names, numbers in quantities.items():
        columns |= zip(names.split(), numbers.reshape(-1, len(names.split())).T)
    return columns


def decimals(texts: Sequence[Sequence[str]], shape: Sequence[int]) -> NDArray[np.object_]:
    """Rows of decimal numbers in an array whose first axes have this shape."""
    import numpy as np

    numbers = np.array([Decimal(text) for row in texts for text in row], dtype=object)
    return numbers.reshape(*shape, 4)

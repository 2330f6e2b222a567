"""Newton's and Euler's equations of a top, for integrators: no formula of the package is used.

The state is the quaternion w, x, y, z and the vector m = A omega + (C - A) (omega . r) r + p s (omega . q) q with q = r x k.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

import toytop

Array = NDArray[np.float64]


def axis(q: Array) -> Array:
    w, x, y, z = q
    return np.array([2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z])


def omega_of(top: toytop.Top, r: Array, m: Array) -> tuple[Array, float]:
    """Angular velocity in the fixed frame, and p s u'."""
    a, c, ps = top.transverse_inertia, top.axial_inertia, top.mass_moment * top.com_height
    q = np.array([r[1], -r[0], 0.0])
    rise = ps * (m @ q) / (a + ps * (q @ q))
    return (m - (c - a) / c * (m @ r) * r - rise * q) / a, rise


def momentum(top: toytop.Top, r: Array, omega: Array) -> Array:
    a, c, ps = top.transverse_inertia, top.axial_inertia, top.mass_moment * top.com_height
    q = np.array([r[1], -r[0], 0.0])
    return np.asarray(a * omega + (c - a) * (omega @ r) * r + ps * (omega @ q) * q)


def start(motion: toytop.Motion) -> Array:
    now = motion.at(0.0)
    return np.concatenate([now.quaternion, momentum(motion.top, now.axis, now.omega)])


def slope(top: toytop.Top) -> Callable[[float, Array], Array]:
    weight = top.mass_moment * top.gravity

    def of(_: float, y: Array) -> Array:
        q, m = y[:4], y[4:]
        r = axis(q)
        (w1, w2, w3), rise = omega_of(top, r, m)
        w, x, y_, z = q
        turned = 0.5 * np.array(
            [
                -w1 * x - w2 * y_ - w3 * z,
                w1 * w + w2 * z - w3 * y_,
                w2 * w + w3 * x - w1 * z,
                w3 * w + w1 * y_ - w2 * x,
            ]
        )
        d1, d2 = w2 * r[2] - w3 * r[1], w3 * r[0] - w1 * r[2]
        return np.concatenate([turned, [rise * d2 - weight * r[1], -rise * d1 + weight * r[0], 0.0]])

    return of


def integrate(motion: toytop.Motion, times: Array, **options: Any) -> Array:
    """States at these times by SciPy."""
    from scipy.integrate import solve_ivp

    span = (times[0], times[-1])
    return np.asarray(solve_ivp(slope(motion.top), span, start(motion), t_eval=times, **options).y.T)

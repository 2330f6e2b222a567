"""Taylor integration of Newton's and Euler's equations of a heavy top that is held, or of a free body, in quaternions.

Euler's equations in the source's own body axes, with the three principal moments J about the held point, and Poisson's equation of the
vertical in the body, carried by the quaternion itself:

    J w' = J w x w - p g (axis x z),   z = third row of the rotation matrix,   q' = q (0, w) / 2

Nothing here knows that the body is symmetric, its integrals or its reduction, and no formula is shared with newton_euler.py.
"""
from mpmath import mp, mpf

ORDER = 70


def dot(a, b, n):
    """Coefficient n of the product of two series."""
    return mp.fdot(zip(a[:n + 1], b[n::-1]))


def series(moments, weight, axis, state, order):
    """Taylor coefficients of w, x, y, z (quaternion) and the body's angular velocity."""
    q, w = [[v] for v in state[:4]], [[v] for v in state[4:]]
    up = [[], [], []]
    for n in range(order):
        product = lambda i, j: dot(q[i], q[j], n)
        up[0].append(2 * (product(1, 3) - product(0, 2)))
        up[1].append(2 * (product(2, 3) + product(0, 1)))
        up[2].append(product(0, 0) - product(1, 1) - product(2, 2) + product(3, 3))
        half = 1 / mpf(2 * (n + 1))
        turn = lambda i, j: dot(q[i], w[j], n)
        step = [
            -turn(1, 0) - turn(2, 1) - turn(3, 2), turn(0, 0) + turn(2, 2) - turn(3, 1),
            turn(0, 1) + turn(3, 0) - turn(1, 2), turn(0, 2) + turn(1, 1) - turn(2, 0),
        ]
        rates = []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            torque = (up[j][n] if k == axis else 0) - (up[k][n] if j == axis else 0)
            rates.append(((moments[j] - moments[k]) * dot(w[j], w[k], n) + weight * torque) / moments[i])
        for coefficients, rate in zip(q, step):
            coefficients.append(rate * half)
        for coefficients, rate in zip(w, rates):
            coefficients.append(rate / (n + 1))
    return q + w


def integrate(moments, weight, axis, state, times, tolerance):
    """States at increasing times."""
    t, out = mpf(0), []
    for end in times:
        while t < end:
            rows = series(moments, weight, axis, state, ORDER)
            last = max(abs(row[-1]) / (1 + abs(row[0])) for row in rows)
            before = max(abs(row[-2]) / (1 + abs(row[0])) for row in rows)
            reach = min((tolerance / last) ** (mpf(1) / ORDER), (tolerance / before) ** (mpf(1) / (ORDER - 1)))
            h = min(reach, end - t)
            state = [mp.polyval(row[::-1], h) for row in rows]
            t = end if h == end - t else t + h
        out.append(state)
    return out

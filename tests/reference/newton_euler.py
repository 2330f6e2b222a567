"""Direct integration of the three-dimensional equations of the toy top, to any precision.

Nothing here knows the integrals of the motion, the reduction to u, or the closed-form solution: the
only input is Newton's law for the height of the centre of mass, Euler's law for the angular momentum
about it, and the kinematics of the attitude. generate.py compares every vector it writes with this.

    height   M s u'' = N - M g                 u = <r,k>; p = M s, N the force of the plane
    spin     (A w + ((C-A) <w,r> + K) r)' = (-s r) x (N k)      K: a rotor inside, 0 if nothing is said
    attitude Phi' = omega Phi                  Phi = [[al, be], [-conj(be), conj(al)]]

The integrator is Gragg's midpoint rule, extrapolated (Bulirsch-Stoer) with the steps H/2, H/4, H/6, ...
"""
from mpmath import mp, mpf

COLUMNS = 18  # extrapolated order 36: at 50 digits a step is then about the natural time scale


def right_hand_side(A, C, s, p, g=1, K=0):
    def f(y):
        a1, a2, b1, b2, w1, w2, w3 = y
        r1, r2 = 2 * (a2 * b2 - a1 * b1), -2 * (a1 * b2 + a2 * b1)
        r3 = a1 * a1 + a2 * a2 - b1 * b1 - b2 * b2
        d1, d2 = w2 * r3 - w3 * r2, w3 * r1 - w1 * r3  # r' = w x r
        d3 = w1 * r2 - w2 * r1
        spin = (C - A) * (w1 * r1 + w2 * r2 + w3 * r3) + K
        # With F = s N and q = r x k = (r2, -r1, 0): the angular equation reads
        #   A w' = -F q - ((C-A) <w,r> + K) r'   (the torque is normal to r, so <w,r>' = 0, also in the limit C = 0),
        # and u'' = <w', q> + <w x r', k> is linear in F, as is the height equation F = p (g + s u'').
        free = w1 * d2 - w2 * d1 - spin * (d1 * r2 - d2 * r1) / A
        F = p * (g + s * free) / (1 + p * s * (r1 * r1 + r2 * r2) / A)
        return (
            (-w3 * a2 + w2 * b1 - w1 * b2) / 2, (w3 * a1 - w2 * b2 - w1 * b1) / 2,
            (-w3 * b2 - w2 * a1 + w1 * a2) / 2, (w3 * b1 + w2 * a2 + w1 * a1) / 2,
            -(F * r2 + spin * d1) / A, (F * r1 - spin * d2) / A, -spin * d3 / A,
        )
    return f


def extrapolated_step(f, y, H):
    """One step of length H: the new state and the size of its last extrapolation correction."""
    row, start = [], f(y)
    for j in range(COLUMNS):
        n = 2 * (j + 1)
        h = H / n
        old, new = y, [v + h * d for v, d in zip(y, start)]
        for _ in range(n - 1):
            old, new = new, [v + 2 * h * d for v, d in zip(old, f(new))]
        previous, row = row, [new]
        for i in range(1, j + 1):  # Aitken-Neville in h^2
            c = 1 / (mpf(j + 1) ** 2 / mpf(j + 1 - i) ** 2 - 1)
            row.append([v + c * (v - w) for v, w in zip(row[-1], previous[i - 1])])
    return row[-1], max(abs(v - w) for v, w in zip(row[-1], row[-2]))


def integrate(A, C, s, p, y, times, tolerance, g=1, K=0):
    """States (a1, a2, b1, b2, w1, w2, w3) at `times`, which all lie on one side of 0, from y at 0."""
    f, t, y = right_hand_side(A, C, s, p, g, K), mpf(0), list(y)
    H, out = 1 / (1 + abs(y[4]) + abs(y[5]) + abs(y[6])), {}
    for end in sorted(times, key=abs):
        while t != end:
            last = abs(end - t) <= H
            step = end - t if last else H * mp.sign(end)
            trial, error = extrapolated_step(f, y, step)
            factor = mpf("0.9") * (tolerance / max(error, mp.eps)) ** (mpf(1) / (2 * COLUMNS - 1))
            if error <= tolerance:
                t, y = (end if last else t + step), trial
                factor = max(factor, H / abs(step)) if last else factor  # a shortened step is no measure for the next one
            H = min(2 * H, factor * abs(step))
        out[end] = y
    return out

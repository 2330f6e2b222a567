"""Motions of the tops that the paper does not have, to 30 digits: with a rotor inside, free, and pendulums.

    python tops.py            write data/tops.json (about a minute, faster with gmpy2)
    python tops.py --check    recompute it and compare; status 1 if a number is off

Each motion is a state, dyadic and so exact in f64, that newton_euler.py integrates at 50 digits with a local tolerance of
1e-42: Newton's law for the height, Euler's for the angular momentum, no first integral and no closed form. A free body is p = 0,
a rod without axial moment of inertia is C = 0, the limit of the same equations.

A second program finds the same numbers: by_taylor() below expands the quaternion and the rates in the body frame in powers of t, 44
terms a step. `crosscheck` is the greatest difference of alpha, beta and w at |t| < 3.
"""
import json
import sys
from pathlib import Path

from mpmath import mp, mpf, nstr

from newton_euler import integrate

mp.dps = 50
FILE = Path(__file__).resolve().parent / "data" / "tops.json"

# (support, A, C, s, p, g, K)
BODY = (1.3125, 0.6875, 0.8125, 1.125)


def unit(*numbers):
    """Numbers of 26 bits in these ratios, whose squares add to 1 to 1e-7; they mean the exactly normalised ones."""
    norm = sum(x * x for x in numbers) ** 0.5
    a, b, c, d = (round(x / norm * 2 ** 26) / 2 ** 26 for x in numbers)
    return (a, b), (c, d)


TILTED, SIDE = unit(0.75, 0.5, -0.25, 0.375), unit(0.625, -0.375, 0.5, 0.4375)
UP, DOWN, SWING = unit(1, 0, 0, 0), unit(0, 0, 1, 0), unit(0, 0.25, 0.9375, 0)
MOTIONS = {
    "rotor_sliding": ("sliding", *BODY, 1.0, 1.75, TILTED, (0.375, -0.6875, 1.1875)),
    "rotor_against_the_spin": ("sliding", *BODY, 1.0, -2.25, TILTED, (0.375, -0.6875, 2.1875)),
    "rotor_body_at_rest": ("sliding", *BODY, 1.0, 2.5, SIDE, (0.0, 0.0, 0.0)),
    "rotor_held": ("fixed", 1.5, 0.75, 0.0, 0.875, 2.0, 3.25, TILTED, (-0.5, 0.3125, 0.625)),
    "rotor_cancels_n": ("fixed", 1.5, 0.75, 0.0, 0.875, 2.0, -1.5, UP, (0.75, -0.25, 2.0)),
    "rotor_upright": ("sliding", *BODY, 1.0, 0.5, UP, (0.5, 0.25, 1.0)),
    "rotor_rod": ("fixed", 1.5, 0.0, 0.0, 0.875, 2.0, 2.0, SIDE, (0.5, -0.25, 0.75)),
    "free_generic": ("free", 1.3125, 0.6875, 0.0, 0.0, 0.0, 0.0, TILTED, (0.375, -0.6875, 1.1875)),
    "free_flat": ("free", 0.75, 1.5, 0.0, 0.0, 0.0, 0.0, SIDE, (-1.0, 0.5, 2.0)),
    "free_rotor": ("free", 1.3125, 0.6875, 0.0, 0.0, 0.0, -1.5, SIDE, (0.5, 0.25, 0.75)),
    "free_rod": ("free", 1.25, 0.0, 0.0, 0.0, 0.0, 0.0, TILTED, (0.5, 1.0, -0.75)),
    "free_through_the_vertical": ("free", 1.3125, 0.6875, 0.0, 0.0, 0.0, 0.0, UP, (0.5, -0.75, 1.0)),
    "held_without_gravity": ("fixed", 1.5, 0.75, 0.0, 0.875, 0.0, 0.0, TILTED, (-0.5, 0.3125, 0.625)),
    "spherical_pendulum": ("fixed", 1.5, 0.0, 0.0, 0.875, 2.0, 0.0, SIDE, (0.5, -0.25, 0.75)),
    "planar_pendulum": ("fixed", 1.5, 0.0, 0.0, 0.875, 2.0, 0.0, SWING, (0.0, 0.0, 0.0)),
    "planar_pendulum_over_the_top": ("fixed", 1.5, 0.0, 0.0, 0.875, 2.0, 0.0, DOWN, (0.0, 2.5, 0.0)),
    "planar_pendulum_with_roll": ("fixed", 1.5, 0.0, 0.0, 0.875, 2.0, 0.0, DOWN, (0.0, 1.5, -0.5)),
    "planar_disc": ("fixed", 1.5, 0.75, 0.0, 0.875, 2.0, 0.0, DOWN, (2.0, 0.0, 0.0)),
    "planar_pendulum_on_the_separatrix": ("fixed", 1.75, 0.0, 0.0, 0.875, 2.0, 0.0, DOWN, (0.0, 2.0, 0.0)),
    "ring": ("sliding", 0.75, 1.5, 0.8125, 1.125, 1.0, 0.0, TILTED, (0.375, -0.6875, 1.1875)),
    "sliding_rod": ("sliding", 1.3125, 0.0, 0.8125, 1.125, 1.0, 0.0, TILTED, (0.375, -0.6875, 1.1875)),
    "spin_zero": ("sliding", *BODY, 1.0, 0.0, SIDE, (0.625, 0.75, -0.4375)),
}
TIMES = [mpf(x) for x in ("0.5", "1.25", "2.75", "5.5", "9", "-0.75", "-3.5")]


def start(motion):
    """alpha, beta and w at t = 0; (alpha, beta) means the normalised pair."""
    *_, (alpha, beta), omega = motion
    norm = mp.sqrt(sum(mpf(x) ** 2 for x in alpha + beta))
    return [mpf(x) / norm for x in alpha + beta] + [mpf(x) for x in omega]


def by_extrapolation(motion):
    _, A, C, s, p, g, K, *_ = motion
    body = [mpf(x) for x in (A, C, s, p)]
    states = {}
    for side in ([t for t in TIMES if t > 0], [t for t in TIMES if t < 0]):
        states.update(integrate(*body, start(motion), side, mpf("1e-42"), mpf(g), mpf(K)))
    return states


def taylor_step(motion, y, room, terms=44):
    """State after a step of the Taylor series of quaternion and body rates, and its length, at most `room`."""
    _, A, C, s, p, g, K, *_ = motion
    A, C, s, p, g, K = map(mpf, (A, C, s, p, g, K))
    Q, W = [[x] for x in y[:4]], [[x] for x in y[4:]]  # Q = (w, x, y, z), W in the body frame

    def product(a, b, n):
        return mp.fsum(a[i] * b[n - i] for i in range(n + 1))

    # series of the vertical k in the body frame, of D = A + p s (1 - k3^2), of the force F and of products of them
    k1, k2, k3, D, F = [], [], [], [], []
    spin = W[2][0]  # constant
    axial = (C - A) * spin + K
    k1k1, k2k2, Wk1, Wk2, udot = [], [], [], [], []
    for n in range(terms):
        w, x, yy, z = Q
        k1.append(2 * (product(x, z, n) - product(w, yy, n)))
        k2.append(2 * (product(yy, z, n) + product(w, x, n)))
        k3.append(product(w, w, n) - product(x, x, n) - product(yy, yy, n) + product(z, z, n))
        k1k1.append(product(k1, k1, n))
        k2k2.append(product(k2, k2, n))
        # in the body frame r = (0, 0, 1), q = r x k = (-k2, k1, 0), r' = W x r = (W2, -W1, 0)
        # M' + W x M = -F q with M = A W + ((C-A) W3 + K) r
        udot.append(product(W[1], k1, n) - product(W[0], k2, n))
        D.append((A if n == 0 else mpf(0)) + p * s * (k1k1[n] + k2k2[n]))
        # u'' = (W2' k1 - W1' k2) + W2 k1' - W1 k2', with k' = k x W
        # W1' = (F k2 - c W2)/A, W2' = (-F k1 + c W1)/A with c = (C-A) W3 + K, and W3' = 0
        c = axial
        free = (c * (product(W[0], k1, n) + product(W[1], k2, n)) / A
                + product(W[1], [a - b for a, b in zip(
                    [product(k2, W[2], i) for i in range(n + 1)], [product(k3, W[1], i) for i in range(n + 1)])], n)
                - product(W[0], [a - b for a, b in zip(
                    [product(k3, W[0], i) for i in range(n + 1)], [product(k1, W[2], i) for i in range(n + 1)])], n))
        # F D = A p (g + s free)
        right = A * p * ((g if n == 0 else 0) + s * free)
        F.append((right - mp.fsum(D[i] * F[n - i] for i in range(1, n + 1))) / D[0])
        W[0].append((product(F, k2, n) - c * W[1][n]) / A / (n + 1))
        W[1].append((-product(F, k1, n) + c * W[0][n]) / A / (n + 1))
        W[2].append(mpf(0))
        rates = (
            -product(x, W[0], n) - product(yy, W[1], n) - product(z, W[2], n),
            product(w, W[0], n) + product(yy, W[2], n) - product(z, W[1], n),
            product(w, W[1], n) + product(z, W[0], n) - product(x, W[2], n),
            product(w, W[2], n) + product(x, W[1], n) - product(yy, W[0], n),
        )
        for series, rate in zip(Q, rates):
            series.append(rate / 2 / (n + 1))
    last = max(abs(x) for series in Q + W for x in series[-2:])
    h = mp.sign(room) * min(abs(room), (mpf("1e-44") / last) ** (mpf(1) / terms) if last else abs(room))
    return [mp.polyval(series[::-1], h) for series in Q + W], h


def rotated(Q, v, back=False):
    w, x, y, z = Q if not back else (Q[0], -Q[1], -Q[2], -Q[3])
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


def by_taylor(motion):
    a1, a2, b1, b2, *omega = start(motion)
    Q = [a1, b2, -b1, a2]
    y0 = Q + rotated(Q, omega, back=True)
    states = {}
    for sign in (1, -1):
        y, t = y0, mpf(0)
        for end in sorted((t for t in TIMES if 0 < t * sign < 3), key=abs):
            while t != end:
                y, h = taylor_step(motion, y, end - t)
                t = end if h == end - t else t + h
            w, x, yy, z = y[:4]
            states[end] = [w, z, -yy, x] + rotated(y[:4], y[4:])
    return states


def digits(x):
    return nstr(x if abs(x) > mpf("1e-40") else mpf(0), 30)


def vector(name):
    support, A, C, s, p, g, K, (alpha, beta), omega = motion = MOTIONS[name]
    states, others = by_extrapolation(motion), by_taylor(motion)
    apart = max(abs(x - y) for t in others for x, y in zip(states[t], others[t]))
    assert apart < mpf("1e-33"), (name, nstr(apart, 3))
    samples = [dict(t=str(float(t)), alpha=[digits(x) for x in states[t][:2]], beta=[digits(x) for x in states[t][2:4]],
                    omega=[digits(x) for x in states[t][4:]]) for t in TIMES]
    return dict(name=name, support=support, A=A, C=C, s=s, p=p, g=g, K=K, alpha=alpha, beta=beta, omega=omega,
                crosscheck=nstr(apart, 2), samples=samples)


def main():
    from multiprocessing import Pool
    with Pool(2) as pool:
        made = pool.map(vector, MOTIONS)
    if "--check" in sys.argv:
        kept = json.loads(FILE.read_text())["motions"]
        same = [dict(x, crosscheck=None) for x in json.loads(json.dumps(made))] == [dict(x, crosscheck=None) for x in kept]
        print("as stored" if same else "OFF")
        sys.exit(0 if same else 1)
    FILE.write_text(json.dumps(dict(made_by="tops.py", motions=made), indent=1) + "\n")
    for motion in made:
        print(f"{motion['name']:32} {motion['crosscheck']}")


if __name__ == "__main__":
    main()

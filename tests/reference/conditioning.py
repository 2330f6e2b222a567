"""Makes data/conditioning.json: states near every degenerate corner, and the branch points of exactly those states.

A state is computed from branch points and a phase and then rounded to f64; the rounding moves the branch points a
little, so their truth is recomputed, at 120 digits, from the rounded numbers: the roots of the monomial cubic
u^3 - (H + k n^2) u^2 + (2 k l n - 1) u + H - k l^2 (k = 1/(2 A p), H = (h - n^2/2C)/p), with l, n, h by their
definitions from the exactly normalised state. It shares no formula with the library, which never forms this cubic.

Usage: python conditioning.py > data/conditioning.json      (mpmath, see requirements.txt)
"""

import json
from mpmath import mp, mpf, mpc, sqrt, cos, sin, exp, polyroots, conj, nstr

mp.dps = 120
A, C, S, P = mpf("1.25"), mpf("0.75"), mpf("0.5"), mpf("1.125")

CORNERS = [
    ("e2-e1 = 1e-6", "0.4", "0.400001", "2.2"),
    ("e2-e1 = 1e-8", "0.4", "0.40000001", "2.2"),
    ("e2-e1 = 1e-8, nearly upright", "0.99999998", "0.99999999", "1.7"),
    ("e2-e1 = 1e-8, nearly hanging", "-0.99999999", "-0.99999998", "1.7"),
    ("1-e2 = 1e-8", "-0.2", "0.99999999", "1.6"),
    ("1+e1 = 1e-8", "-0.99999999", "0.3", "1.6"),
    ("e3-e2 = 1e-6", "-0.3", "0.9999995", "1.0000005"),
    ("e3-e2 = 1e-9", "-0.3", "0.9999999995", "1.0000000005"),
    ("e3-e2 = 1e-6 and 1+e1 = 1e-6", "-0.999999", "0.9999995", "1.0000005"),
    ("e3-1 = 1e-9", "0.1", "0.6", "1.000000001"),
    ("e3 = 1e4", "0.3", "0.302", "10000"),
    ("all three near 1", "0.999", "0.9999", "1.0003"),
]


def state(e1, e2, e3, plus, minus, theta, a0, b0):
    """alpha, beta, omega at nutation phase theta, from |alpha|, |beta| and their logarithmic derivatives."""
    scale = sqrt(2 * A * P)
    lpn = plus * scale * sqrt((1 + e1) * (1 + e2) * (1 + e3))
    lmn = minus * scale * sqrt((1 - e1) * (1 - e2) * (e3 - 1))
    l, n = (lpn + lmn) / 2, (lpn - lmn) / 2
    c, s = cos(theta / 2), sin(theta / 2)
    alpha = abs(mpc(sqrt((1 + e1) / 2) * c, sqrt((1 + e2) / 2) * s)) * exp(1j * a0)
    beta = abs(mpc(sqrt((1 - e1) / 2) * c, sqrt((1 - e2) / 2) * s)) * exp(1j * b0)
    u = abs(alpha) ** 2 - abs(beta) ** 2
    d = A / P + S * (1 - u * u)
    udot = (e2 - e1) / 2 * sin(theta) * sqrt(2 * (e3 - u) / d)
    tau = (1 / C - 1 / A) * n
    ad = alpha * (udot + 1j * (lpn / A + (1 + u) * tau)) / (2 * (1 + u))
    bd = beta * (-udot + 1j * (lmn / A - (1 - u) * tau)) / (2 * (1 - u))
    upper = bd * alpha - ad * beta
    diagonal = ad * conj(alpha) + bd * conj(beta)
    return alpha, beta, (2 * upper.imag, -2 * upper.real, 2 * diagonal.imag)


def truth(alpha, beta, omega):
    norm = sqrt(abs(alpha) ** 2 + abs(beta) ** 2)
    alpha, beta = alpha / norm, beta / norm
    h12 = -2 * alpha * beta
    r = (h12.real, h12.imag, abs(alpha) ** 2 - abs(beta) ** 2)
    w, u = omega, r[2]
    spin = sum(x * y for x, y in zip(w, r))
    udot = w[0] * r[1] - w[1] * r[0]
    l = A * w[2] + (C - A) * spin * u
    n = C * spin
    h = A * sum(x * x for x in w) / 2 + (C - A) * spin**2 / 2 + P * S * udot**2 / 2 + P * u
    k, big_h = 1 / (2 * A * P), (h - n * n / (2 * C)) / P
    roots = polyroots([1, -(big_h + k * n * n), 2 * k * l * n - 1, big_h - k * l * l], maxsteps=2000, extraprec=800)
    e1, e2, e3 = sorted(root.real for root in roots)
    return e1, e2, e3


def main():
    cases = []
    for name, e1, e2, e3 in CORNERS:
        for i, (plus, minus, theta) in enumerate([(1, 1, "0.4"), (1, -1, "1.7"), (-1, 1, "-2.6"), (-1, -1, "3.1")]):
            exact = state(mpf(e1), mpf(e2), mpf(e3), plus, minus, mpf(theta), mpf("0.3") + i, mpf("-1.1") - i)
            alpha, beta, omega = exact
            alpha = [float(alpha.real), float(alpha.imag)]
            beta = [float(beta.real), float(beta.imag)]
            omega = [float(x) for x in omega]
            e = truth(mpc(*alpha), mpc(*beta), [mpf(x) for x in omega])
            digits = lambda x: nstr(x, 30, strip_zeros=False)
            differences = {
                "one_plus_e1": 1 + e[0],
                "one_minus_e2": 1 - e[1],
                "e2_minus_e1": e[1] - e[0],
                "e3_minus_e2": e[2] - e[1],
                "e3_minus_one": e[2] - 1,
            }
            cases.append(
                {"corner": name, "alpha": alpha, "beta": beta, "omega": omega}
                | {key: digits(x) for key, x in zip(("e1", "e2", "e3"), e)}
                | {key: digits(x) for key, x in differences.items()}
            )
    top = {"A": float(A), "C": float(C), "s": float(S), "p": float(P)}
    print(json.dumps({"top": top, "cases": cases}, indent=1))


main()

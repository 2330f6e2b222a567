"""Motions by the formulas of the paper for e3 = e4 (section 5.1) and e2 = e3 = 1 (section 5.3), with the errata corrected, at 50 digits.

Weierstrass's functions are those of errata.py, from theta functions. A = C = 5/4, s = p = 1, so that e4 = 3/2. Run without arguments to write
data/paper_formulas.json; it exits with 1 if the formulas miss the full equations of newton_euler.py.
"""
import json
import os
import sys

from mpmath import exp, log, mpc, mpf, nstr, sqrt

from errata import I, Lattice, at_turning_point, from_root, full

A, E4, ONE = mpf("1.25"), mpf("1.5"), mpf(1)
ROOT2 = sqrt(mpf(2))
worst = mpf(0)


def sign(x):
    return 1 if x > 0 else -1


def momenta(e, signs):
    (e1, e2, e3), (plus, minus) = e, signs
    return (plus * sqrt(2 * A * (1 + e1) * (1 + e2) * (1 + e3)), minus * sqrt(2 * A * (1 - e1) * (1 - e2) * (e3 - 1)))


def e3_equals_e4(e1, e2, signs):
    """Equations (5.3) to (5.8): (t, alpha, beta) at points x of the imaginary axis."""
    plus, minus = momenta((e1, e2, E4), signs)
    centre = (e1 + e2 - E4) / 3
    f = Lattice([e2 - centre, e1 - centre, -E4 - centre])
    w1, w2 = -I * f.imaginary, f.real
    at_minus, at_plus = ROOT2 * (E4 - 1) * plus / A, ROOT2 * (E4 + 1) * minus / A
    a = -sign(at_minus) * (w1 + from_root(e1, -ONE, [e2, -E4]))
    b = sign(at_plus) * from_root(e2, ONE, [e1, -E4])
    k1, k2 = f.sigma(w2) / f.sigma(a) * sqrt((1 + e2) / 2), I * f.sigma(w2) / f.sigma(b) * sqrt((1 - e2) / 2)
    l1, l3 = f.zeta(a - w2) + at_minus / (2 * (E4 - 1)), f.zeta(b - w2) + at_plus / (2 * (E4 + 1))

    def at(share):
        x = -w1 * share
        t = I * ROOT2 * (f.zeta(x - w2) + f.zeta(w2) - (e1 + e2 + 2 * E4) * x / 3)
        alpha = k1 * exp(l1 * x) * f.sigma(x - a) / f.sigma(x - w2)
        return t.real, alpha, k2 * exp(-l3 * x) * f.sigma(x + b) / f.sigma(x + w2)

    return at


def aperiodic(e1, signs):
    """Equations (5.14) to (5.17): (t, alpha, beta) at points x between -b and b."""
    plus, _ = momenta((e1, ONE, ONE), signs)
    f = Lattice([E4 - e1 / 3, e1 - e1 / 3, -E4 - e1 / 3])
    w3 = f.real + I * f.imaginary
    at_minus = ROOT2 * (1 - E4 ** 2) * plus / (2 * A)
    a, b = from_root(e1, -ONE, [E4, -E4]), -I * from_root(e1, ONE, [E4, -E4])
    a *= sign(f.dp(a - w3).real) * sign(at_minus)
    at_plus = f.dp(b - w3)
    p = at_minus / (2 * at_plus)
    k = sqrt((1 + e1) / 2) * f.sigma(w3) / f.sigma(a)
    l = at_minus / 4 - at_minus / (1 - E4 ** 2) + f.zeta(a - w3) - p * (f.zeta(a + b) - f.zeta(a - b))

    def at(share):
        x = b * share
        pole = log(-f.sigma(x - b) / f.sigma(x + b))
        third = pole + 2 * (f.zeta(w3) + f.zeta(b - w3)) * x
        t = I * ROOT2 * (-f.zeta(x - w3) - f.zeta(w3) + (1 + e1 / 3) * x + (1 - E4 ** 2) / at_plus * third)
        alpha = k * exp(l * x - p * pole) * f.sigma(x - a) / f.sigma(x - w3)
        return t.real, alpha, I * sqrt((1 - (f.p(x - w3) + e1 / 3)) / 2)

    return at


def case(e, signs, theta, at, shares):
    global worst
    samples = []
    for share in shares:
        t, alpha, beta = at(mpf(share))
        parts = {key: [nstr(mpc(z).real, 30), nstr(mpc(z).imag, 30)] for key, z in (("alpha", alpha), ("beta", beta))}
        samples.append({"t": nstr(t, 30), **parts})
    start = at_turning_point(A, A, e[0] if theta == "0" else e[1], *momenta(e, signs))
    alpha_now, beta_now, _, _ = full((A, A, ONE, ONE), start, t)
    worst = max(worst, abs(alpha - alpha_now), abs(beta - beta_now))
    numbers = {"A": "1.25", "C": "1.25", "s": "1", "p": "1", "e": [nstr(x, 30) for x in e], "signs": list(signs)}
    return {**numbers, "theta": theta, "arg_alpha": "0", "arg_beta": "pi/2", "samples": samples}


if __name__ == "__main__":
    cases = []
    for pair in (("-0.375", "0.625"), ("0.25", "0.875"), ("-0.875", "-0.25")):
        for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            e1, e2 = map(mpf, pair)
            at = e3_equals_e4(e1, e2, signs)
            cases.append(case((e1, e2, E4), signs, "pi", at, ["-2.9", "-0.999", "-0.3", "0", "0.001", "2.2", "0.7"]))
    for e1 in map(mpf, ("-0.75", "-0.25", "0.5", "0.875")):
        for signs in ((1, 1), (-1, 1)):
            at = aperiodic(e1, signs)
            cases.append(case((e1, ONE, ONE), signs, "0", at, ["-0.99", "-0.35", "0", "1e-6", "0.95", "0.999", "0.6"]))
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "data", "paper_formulas.json"), "w") as file:
        json.dump({"cases": cases}, file, indent=1)
        file.write("\n")
    print("greatest difference from the full equations", nstr(worst, 3))
    sys.exit(worst > mpf("1e-40"))

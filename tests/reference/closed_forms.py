"""Makes data/closed_forms.json: motions that have a closed form, where several differences of the branch points are small together.

Every number of a case is an f64 and counts as exact; alpha and beta are `exact_motion.py`'s, which knows no elliptic function.
A case whose e3 is not e4 to the last digit says so by `refused`.

Usage: python closed_forms.py > data/closed_forms.json      (mpmath, see requirements.txt)
"""

import json
from mpmath import mp, mpf, nstr

from exact_motion import Motion

NEAR_ONE = 1 + 2.0**-19
EQUAL = NEAR_ONE**2 - 1  # A/(ps) = e3^2 - 1, exactly
SHALLOW = [-0.9999999999984295, -0.9999999690829054, NEAR_ONE]
CLUSTER = [0.9999999979879689, 0.9999999979929988, 1.0000000010736048]

CASES = [
    # name, A, C, s, p, e, signs, phase, arg alpha, arg beta, times
    ("e3 = e4 but for 2.5e-11 of e3 - 1", 3.8147009037e-06, 1.66 * 3.8147009037e-06, 1.0, 1.0,
     SHALLOW[:2] + [1.0000019073486328], (1, 1), -0.2871338431077186, 0.0, 0.0, [0.003, 2.0]),
    ("e3 = e4 near 1, 1 + e1 and 1 + e2 small", EQUAL, 1.66 * EQUAL, 1.0, 1.0,
     SHALLOW, (1, 1), -0.2871338431077186, 0.0, 0.0, [-0.7, 0.003, 2.0, 300.0]),
    ("e3 = e4 near 1, 1 - e1 and 1 - e2 small", EQUAL, 0.3 * EQUAL, 1.0, 1.0,
     [1 - 2.0**-30, 1 - 2.0**-33, NEAR_ONE], (1, -1), 1.1, 0.4, -0.9, [-0.7, 0.003, 2.0, 300.0]),
    ("e3 = e4 near 1, e2 = 1", EQUAL, 0.8 * EQUAL, 1.0, 1.0,
     [-0.3, 1.0, NEAR_ONE], (1, -1), 0.9, 0.7, -2.1, [-0.7, 0.25, 2.0, 1e6]),
    ("e3 = e4 near 1, 1 - e2 = 2^-20", EQUAL, 0.8 * EQUAL, 1.0, 1.0,
     [0.9990234375, 1 - 2.0**-20, NEAR_ONE], (1, -1), 0.9, 0.7, -2.1, [-0.7, 0.25, 2.0, 1e6]),
    ("sliding, aperiodic, 1 - e1 = 2^-50", 1.0, 1.0, 1.0, 1.0,
     [1 - 2.0**-50, 1.0, 1.0], (1, 1), 2.0, 0.0, 0.0, [-3.0, 0.5, 100.0, 1e5]),
    ("fixed, aperiodic, 1 - e1 = 2^-50", 1.0, 1.0, 0.0, 1.0,
     [1 - 2.0**-50, 1.0, 1.0], (1, 1), 2.0, 0.0, 0.0, [-3.0, 0.5, 100.0, 1e5]),
    ("sliding, aperiodic, 1 + e1 = 2^-40", 1.0, 0.001, 1.0, 1.0,
     [-1 + 2.0**-40, 1.0, 1.0], (-1, 1), 2.0, 0.3, -0.2, [-3.0, 0.5, 20.0]),
    ("fixed, all three near 1", 1.0, 2.0, 0.0, 1.0,
     CLUSTER, (1, -1), 1.129196223257733, 0.0, 0.0, [3.0, 3e4, 1e7]),
    ("fixed, C/A = 1e-3", 1.0, 0.001, 0.0, 1.0,
     [-0.25, 0.5, 1.5], (1, -1), 1.0, 0.0, 0.0, [1.0, 20.0, 1e4, 1e7]),
    ("fixed, e2 - e1 = 2^-23", 1.0, 0.75, 0.0, 1.0,
     [0.25, 0.25 + 2.0**-23, 1.5], (1, -1), 1.0, 0.0, 0.0, [1.0, 20.0, 1e4, 1e7]),
    ("fixed, all three near 1, e1 near -1", 1.0, 0.5, 0.0, 1.0,
     [-1 + 2.0**-40, 1 - 2.0**-44, 1 + 2.0**-46], (-1, 1), 2.5, 0.1, 0.2, [1.0, 30.0, 1e5]),
]


def digits(z):
    return [nstr(z.real, 30), nstr(z.imag, 30)]


def case(name, a, c, s, p, e, signs, phase, arg_alpha, arg_beta, times):
    exact = [mpf(x) for x in e]
    motion = Motion([mpf(x) for x in (a, c, s, p)], exact, signs, mpf(phase), [mpf(arg_alpha), mpf(arg_beta)])
    samples = []
    for t in times:
        _, _, alpha, beta, _, _ = motion.state(mpf(t))
        samples.append({"t": t, "alpha": digits(alpha), "beta": digits(beta)})
    aperiodic = exact[2] == 1
    refused = bool(s > 0 and not aperiodic and exact[2] ** 2 - 1 != mpf(a) / (mpf(p) * mpf(s)))
    return {"name": name, "A": a, "C": c, "s": s, "p": p, "e": e, "signs": signs, "theta": phase,
            "arg_alpha": arg_alpha, "arg_beta": arg_beta, "refused": refused, "samples": samples}


def main():
    assert mp.dps >= 50
    print(json.dumps({"cases": [case(*entry) for entry in CASES]}, indent=1))


main()

"""Makes data/normal_force.json: the least normal force of motions with given branch points, slender tops among them.

N(u) = 1 + s d(f/D)/du with f = (u - e1)(u - e2)(u - e3) and D = A/p + s (1 - u^2). The numbers e1, e2, e3, A, p, s are
f64 and count as exact. The stationary points are the real roots in (e1, e2) of the numerator of d2(f/D)/du2, a cubic,
found at 400 digits. The library uses partial fractions in u = e4 and u = -e4 instead.

Usage: python normal_force.py > data/normal_force.json      (mpmath, see requirements.txt)
"""

import json
import random
from mpmath import mp, mpf, nstr, polyroots

mp.dps = 400


def product(a, b):
    out = [mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def total(*polynomials):
    length = max(map(len, polynomials))
    return [sum((p[i] for p in polynomials if i < len(p)), mpf(0)) for i in range(length)]


def slope(a):
    return [i * x for i, x in enumerate(a)][1:]


def value(a, x):
    out = mpf(0)
    for c in reversed(a):
        out = out * x + c
    return out


def least(e, a, p, s):
    e1, e2, e3 = map(mpf, e)
    f = product(product([-e1, 1], [-e2, 1]), [-e3, 1])
    d = [mpf(a) / mpf(p) + mpf(s), mpf(0), -mpf(s)]
    df, dd = slope(f), slope(d)
    ddf, ddd = slope(df), slope(dd)
    scaled = lambda k, q: [k * x for x in q]
    numerator = total(
        product(ddf, product(d, d)),
        scaled(-2, product(df, product(dd, d))),
        scaled(-1, product(f, product(ddd, d))),
        scaled(2, product(f, product(dd, dd))),
    )[:4]
    force = lambda u: 1 + mpf(s) * (value(df, u) * value(d, u) - value(f, u) * value(dd, u)) / value(d, u) ** 2
    roots = polyroots(list(reversed(numerator)), maxsteps=5000, extraprec=2000)
    inside = [r.real for r in roots if abs(r.imag) < mpf(10) ** -150 and e1 < r.real < e2]
    return min([force(e1), force(e2)] + [force(u) for u in inside])


def cases():
    draw = random.Random(20)
    yield [-0.6474482095870493, 1.0, 1.0000061321270899], 1.0, 1.0, 398830.32246723166
    small = lambda: 10 ** draw.uniform(-15, 0)
    for _ in range(300):
        # A/(ps) from 1e-6 to 100, most of them slender; one of the differences, or several, small
        spread = 10 ** (draw.uniform(-6, -3) if draw.random() < 0.7 else draw.uniform(-3, 2))
        p, s = 10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-1, 1)
        a = spread * p * s * 1.000001
        e3 = 1 + small() * 10 ** draw.choice([0, 0, 0, 2, 6])
        e2 = draw.choice([1.0, 1 - small(), 1 - small(), draw.uniform(-1, 1)])
        e1 = draw.choice([-1.0, -1 + small(), e2 - small(), draw.uniform(-1, 1), draw.uniform(-1, 1)])
        e1, e2 = sorted([max(-1.0, e1), e2])
        if e1 < e2:
            yield [e1, e2, e3], a, p, s


def main():
    digits = lambda x: nstr(x, 30, strip_zeros=False)
    out = [
        {"e": [repr(x) for x in e], "A": repr(a), "p": repr(p), "s": repr(s), "least": digits(least(e, a, p, s))}
        for e, a, p, s in cases()
    ]
    print(json.dumps({"made_by": "normal_force.py", "cases": out}, indent=1))


main()

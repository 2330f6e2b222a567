"""Makes data/elliptic.json: Weierstrass's and Jacobi's functions to 30 digits, at arguments that are exact in f64.

The Weierstrass functions come from their Laurent series at 0 and the duplication formulas, at 300 digits: z is halved until
the series converges, then doubled again. Jacobi's come from the theta series of mpmath at 60 digits, K from its AGM with the
complementary parameter. The library uses neither: it has theta series for the first and Landen's chain for the second.

Usage: python elliptic.py > data/elliptic.json            (mpmath, see requirements.txt)
       python elliptic.py sweep > data/elliptic_sweep.json    (quotients of the root differences and K, densely)
"""

import json
import random
import sys
from mpmath import mp, mpf, mpc, nstr, log, agm, pi, sqrt, nint, jtheta, exp

mp.dps = 300


def laurent(g2, g3, terms=170):
    """c_k of p(z) = z^-2 + sum c_k z^(2k-2), k >= 2."""
    c = {2: g2 / 20, 3: g3 / 28}
    for k in range(4, terms):
        c[k] = 3 / mpf((2 * k + 1) * (k - 3)) * sum(c[m] * c[k - m] for m in range(2, k - 1))
    return c


def weierstrass(e, z, c):
    """p, p', zeta, sigma."""
    halvings = 0
    radius = min(half_periods(e))
    while abs(z) > radius / 8:
        z, halvings = z / 2, halvings + 1
    p = 1 / z**2 + sum(ck * z ** (2 * k - 2) for k, ck in c.items())
    slope = -2 / z**3 + sum((2 * k - 2) * ck * z ** (2 * k - 3) for k, ck in c.items())
    zeta = 1 / z - sum(ck * z ** (2 * k - 1) / (2 * k - 1) for k, ck in c.items())
    sigma = z * mp.exp(-sum(ck * z ** (2 * k) / (2 * k * (2 * k - 1)) for k, ck in c.items()))
    g2 = 2 * sum(x * x for x in e)
    for _ in range(halvings):
        second = 6 * p * p - g2 / 2
        q = second / (2 * slope)
        sigma = -slope * sigma**4
        zeta = 2 * zeta + q
        third = 12 * p * slope
        p, slope = -2 * p + q * q, -slope + q * (third * slope - second**2) / (2 * slope**2)
    return p, slope, zeta, sigma


def half_periods(e):
    e1, e2, e3 = e
    return pi / 2 / agm(sqrt(e1 - e3), sqrt(e1 - e2)), pi / 2 / agm(sqrt(e1 - e3), sqrt(e2 - e3))


def digits(x, zero="1e-45"):
    """To 30 digits; what is below the rounding of its computation counts as 0."""
    if isinstance(x, mpc):
        return [digits(x.real, "1e-90"), digits(x.imag, "1e-90")]
    return nstr(mpf(0) if abs(x) < mpf(zero) else mpf(x), 30, strip_zeros=False)


def lattice(upper, lower, generator):
    d1, d2 = mpf(upper), mpf(lower)
    e = (2 * d1 + d2) / 3, (d2 - d1) / 3, -(d1 + 2 * d2) / 3
    real, imaginary = half_periods(e)
    c = laurent(2 * sum(x * x for x in e), 4 * e[0] * e[1] * e[2])
    functions = lambda z: weierstrass(e, z, c)
    points = []
    shares = [(0.3, 0.2), (0.7, 0.4), (0.45, 0.0), (0.0, 0.6), (1.0, 0.3), (0.6, 1.0), (0.95, 0.97), (1e-5, -1e-5)]
    shares += [(generator.uniform(-1, 1), generator.uniform(-1, 1)) for _ in range(8)]
    shares += [(generator.uniform(-9, 9), generator.uniform(-9, 9)) for _ in range(6)]
    for x, y in shares:
        z = float(real * x), float(imaginary * y)
        p, slope, zeta, sigma = functions(mpc(*z))
        points.append({"z": z, "p": digits(p), "p_prime": digits(slope), "zeta": digits(zeta),
                       "ln_sigma": digits(log(sigma))})
    eta, eta_imaginary = functions(mpc(real, 0))[2].real, functions(mpc(0, imaginary))[2].imag
    return {"upper_gap": upper, "lower_gap": lower, "half_periods": [digits(real), digits(imaginary)],
            "quasi_periods": [digits(eta), digits(eta_imaginary)], "points": points}


def jacobi(m1, generator):
    complement = mpf(m1)
    m = 1 - complement
    quarter, other = pi / 2 / agm(1, sqrt(complement)), pi / 2 / agm(1, sqrt(m))
    q = exp(-pi * other / quarter)
    points = []
    shares = [0.0, 0.03, 0.5, 0.8, 0.999, 1.0, 1.3, 2.0, 2.4, -0.6, -1.9] + [generator.uniform(-12, 12) for _ in range(8)]
    for share in shares:
        u = float(quarter * share)
        zeta = mpf(u) * pi / (2 * quarter)
        th = [None] + [jtheta(n, zeta, q) for n in (1, 2, 3, 4)]
        at = [None] + [jtheta(n, 0, q) for n in (1, 2, 3, 4)]
        sn = at[3] / at[2] * th[1] / th[4]
        cn = at[4] / at[2] * th[2] / th[4]
        dn = at[4] / at[3] * th[3] / th[4]
        halves = nint(mpf(u) / (2 * quarter))
        am = halves * pi + mp.atan2(sn * (-1) ** int(halves), cn * (-1) ** int(halves))
        points.append({"u": u, "sn": digits(sn), "cn": digits(cn), "dn": digits(dn), "am": digits(am)})
    return {"m": float(m), "m1": m1, "quarter_period": digits(quarter), "points": points}


def sweep():
    """Four quotients of the root differences a decade from 1e-28 to 1e28, with two points each, and four K a decade."""
    generator = random.Random(15)
    lattices = []
    for k in range(-112, 113):
        upper, lower = (10 ** (k / 4), 1.0) if k < 0 else (1.0, 10 ** (-k / 4))
        d1, d2 = mpf(upper), mpf(lower)
        e = (2 * d1 + d2) / 3, (d2 - d1) / 3, -(d1 + 2 * d2) / 3
        real, imaginary = half_periods(e)
        c = laurent(2 * sum(x * x for x in e), 4 * e[0] * e[1] * e[2])
        points = []
        for _ in range(2):
            z = float(real * generator.uniform(-1, 1)), float(imaginary * generator.uniform(-1, 1))
            p, slope, zeta, _ = weierstrass(e, mpc(*z), c)
            points.append({"z": z, "p": digits(p), "p_prime": digits(slope), "zeta": digits(zeta)})
        lattices.append({"upper_gap": upper, "lower_gap": lower, "points": points})
    mp.dps = 60
    complements = [10 ** (-k / 4) for k in range(1, 1200)]
    quarters = [{"m1": m1, "quarter_period": digits(pi / 2 / agm(1, sqrt(mpf(m1))))} for m1 in complements]
    print(json.dumps({"lattices": lattices, "jacobi": quarters}, separators=(",", ":")).replace("},{", "},\n{"))


def main():
    generator = random.Random(6)
    gaps = [(1.0, 1.0), (0.5, 2.0), (2.0, 0.5), (1.5, 1e-3), (1e-3, 1.5), (1e-9, 0.75), (0.75, 1e-9), (3e4, 7e3),
            (1e-4, 3e-4), (0.00390625, 1024.0), (1.0, 3e-24), (2e-24, 0.75), (7e-25, 40.0), (1e-30, 1e-7)]
    lattices = [lattice(upper, lower, generator) for upper, lower in gaps]
    mp.dps = 60
    # most are dyadic, so that m + m1 = 1 is exact if m has enough digits
    complements = [0.5, 0.25, 0.75, 0.9990234375, 2.0**-10, 2.0**-30, 2.0**-52, 2.0**-70, 6e-31, 2.0**-100, 3e-18]
    jacobis = [jacobi(m1, generator) for m1 in complements]
    print(json.dumps({"lattices": lattices, "jacobi": jacobis}, indent=1))


sweep() if sys.argv[1:] == ["sweep"] else main()

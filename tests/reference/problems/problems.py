"""The problems of the catalogue in exact numbers, in the conventions of their sources.

A: transverse inertia, about the point that is held, or about the centre of mass of a body that slides or is free. s: distance from
the tip to the centre of mass in the equations of a sliding top, 0 for a held or free one. p: mass moment. q: unit quaternion from
source's body axes to fixed axes. w: angular velocity in the source's body axes. axis: the body axis of symmetry. up: always z.
"""
from mpmath import mp, mpf


def half(angle, axis):
    """Quaternion of a rotation about a fixed axis."""
    sine = mp.sin(angle / 2)
    return [mp.cos(angle / 2)] + [sine if i == axis else mpf(0) for i in range(3)]


def numbers(*texts):
    return [mpf(text) for text in texts]


def springborn(e3):
    """Figure 3 of the paper: e1, e2 = 0.7, 0.9 with different signs, A = C = s = p = g = 1; starts at e2, azimuth 180 degrees."""
    e1, e2, e3 = numbers("0.7", "0.9", e3)
    plus = mp.sqrt(2 * (1 + e1) * (1 + e2) * (1 + e3))
    minus = -mp.sqrt(2 * (1 - e1) * (1 - e2) * (e3 - 1))
    l, n = (plus + minus) / 2, (plus - minus) / 2
    # at a turning point r = (sin, 0, cos) the body turns about r and k: w = spin r + rate (k - u r)
    u, sine = e2, mp.sqrt((1 - e2) * (1 + e2))
    rate = (l - n * u) / sine ** 2
    tilt = mp.acos(u)
    return dict(A=mpf(1), C=mpf(1), s=mpf(1), p=mpf(1), g=mpf(1), q=half(tilt, 1), w=[-rate * sine, mpf(0), n],
                axis=2, length=1, times=["1", "10", "100"])


def problems():
    bruls = dict(A=mpf("15.234375"), C=mpf("0.46875"), p=mpf(15), g=mpf("9.81"), q=numbers(1, 0, 0, 0),
                 w=numbers(0, 150, "-4.61538"), axis=1, length=1, times=["0.2", "0.8", "1", "2"])
    simo = dict(A=mpf(5), C=mpf(1), p=mpf(20), g=mpf(1), q=half(mpf("0.05"), 0), w=numbers(0, 0, 50), axis=2, length=1,
                times=["1", "10"])
    kinon = dict(A=mpf("0.006375"), C=mpf("0.00075"), p=mpf("0.075"), g=mpf("9.81"), q=half(mp.pi / 3, 0),
                 w=[mpf(0), 10 * mp.sin(mp.pi / 3), mpf("140.6")], axis=2, length=mpf("0.075"), times=["0.001", "1", "2"])
    diffman = dict(A=mpf("0.875"), C=mpf("0.25"), p=mp.sqrt(3) / 2, g=mpf("9.81"), q=half(-mp.pi / 16, 0), w=numbers(0, 0, 1),
                   axis=2, length=mp.sqrt(3) / 2, times=["1", "5"])
    parker = dict(A=mpf(1), C=mpf("0.2"), p=mpf(20), g=mpf(1), q=half(mp.pi / 10, 1), w=numbers(0, 0, 100), axis=2, length=1,
                  times=["0.4"])
    drake = dict(A=mpf("0.04"), C=mpf("0.02"), p=mpf(0), g=mpf(1), q=numbers(1, 0, 0, 0), w=numbers(2, 4, 6), axis=2, length=1,
                 times=["1", "10"])
    critical = dict(A=mpf(1), C=mpf("0.5"), p=mpf(1), g=mpf(1), q=numbers(1, 0, 0, 0), w=numbers(0, "0.0078125", 4), axis=2, length=1,
                    times=["10", "100"])
    held = dict(bruls_cardona=bruls, simo_wong=simo, kinon_betsch=kinon, diffman=diffman, parker=parker, drake_cylinder=drake,
                critical_spin=critical)
    for problem in held.values():
        problem["s"] = mpf(0)
    return held | dict(springborn_cusp=springborn("1.85"), springborn_loops=springborn("3"))

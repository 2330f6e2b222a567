"""Makes data/events.json: the instants at which exact motions turn, cross a level or a circle, reach a tip angle, or lift off.

Each is found by a search in time and then by the secant method, to 25 digits or more, on the motion of exact_motion.py at 45 digits. The
normal force is 1 + s u'' with u'' by a central difference. The library searches its table in the nutation phase instead.

Usage: python events.py > data/events.json      (mpmath, see requirements.txt; two minutes)
"""
import json
import sys

from mpmath import mp, mpf

import exact_motion
from generate import MOTIONS, build

mp.dps = 45
exact_motion.QUADRATURE = mpf("1e-36")
HERTZ = 1024  # a tick is a dyadic number of units of time
PER_PERIOD = 61  # steps of the search in a period
CASES = {
    "exact_generic_pp": ([0.5, -0.25], [0.5], [0.125, -0.375]),
    "exact_generic_pm": ([0.5, 0.59375], [0.5625], [0.125, -0.375]),
    "exact_generic_mm": ([0.0, -0.3125], [0.75], [0.25]),
    "exact_lagrange": ([0.25, 0.484375], [0.9375], [0.0, 0.4375]),
    "exact_e2_1": ([0.5, 0.9990234375], [0.03125], [0.25]),
    "exact_e1_m1": ([-0.5, -0.9990234375], [0.03125], [0.25]),
    "exact_near_separatrix_straddle": ([0.5, 0.9990234375], [0.25], [0.125]),
    "exact_small_A": ([0.5, 0.9296875], [0.5], [0.125]),
    "exact_aperiodic": ([0.5, 0.9990234375], [0.25], [0.125]),
    "exact_fast_spin": ([0.2978515625], [], [0.125]),
}
LIFTING = "exact_generic_pp", "exact_generic_mm", "exact_small_A", "exact_e2_1"


def root(f, a, b, fa, fb):
    """Zero of f between a and b, and its slope there."""
    low, high = a, b
    for _ in range(100):
        c = b - fb * (b - a) / (fb - fa) if fb != fa else b
        if not low <= c <= high:
            c = (low + high) / 2
        a, fa, b, fb = b, fb, c, f(c)
        if abs(b - a) < mpf("1e-30") * (1 + abs(b)):
            break
    h = mpf("1e-12")
    return b, (f(b + h) - f(b - h)) / (2 * h)


def functions(motion, levels, radii, angles):
    """(kind, value, function of a state whose zeros are the events)"""
    yield "turning", None, lambda state: state[1]
    for level in levels:
        yield "level", level, lambda state, level=level: state[0] - mpf(level)
    for radius in radii:
        yield "circle", radius, lambda state, radius=radius: mp.sqrt(abs((1 - state[0]) * (1 + state[0]))) - mpf(radius)
    for angle in angles:
        yield "tip_angle", angle, lambda state, angle=angle: whole_turns_dropped(state[5] / (2 * mp.pi) - mpf(angle))


def whole_turns_dropped(turns):
    return turns - mp.nint(turns)


def force(motion, t):
    """Normal force in units of the weight, with u'' by a difference of u'."""
    h = mpf("1e-12")
    return 1 + motion.s * (motion.state(t + h)[1] - motion.state(t - h)[1]) / (2 * h)


def changes(values, wraps):
    """Steps in which a function changes its sign, but not by a jump of a whole turn."""
    for i, (before, after) in enumerate(zip(values, values[1:])):
        if before * after <= 0 and not (wraps and abs(before - after) > mpf("0.5")):
            yield i


def digits(x):
    return mp.nstr(x, 25)


cases = []
for name, (levels, radii, angles) in CASES.items():
    motion, _ = build(name)
    unit = motion.T if motion.periodic else 20 * mp.sqrt(motion.A / motion.p)
    for start in (-7, int(10 ** 6 * unit * HERTZ) if motion.periodic else int(-unit / 2 * HERTZ)):
        times = [mpf(start) / HERTZ + unit * i / PER_PERIOD for i in range(2 * PER_PERIOD)]
        states = [motion.state(t) for t in times]
        searches = [(kind, value, [f(state) for state in states], lambda t, f=f: f(motion.state(t)))
                    for kind, value, f in functions(motion, levels, radii, angles)]
        if name in LIFTING:
            searches.append(("lift_off", None, [force(motion, t) for t in times], lambda t: force(motion, t)))
        for kind, value, values, f in searches:
            steps = list(changes(values, kind == "tip_angle"))[:3]
            found = [root(f, times[i], times[i + 1], values[i], values[i + 1]) for i in steps]
            events = [dict(after=digits(t - times[0]), slope=digits(slope)) for t, slope in found]
            cases.append(dict(motion=name, from_tick=start, kind=kind, value=value, events=events))
        print(name, start, file=sys.stderr, flush=True)
print(json.dumps(dict(hertz=HERTZ, cases=cases), indent=1))

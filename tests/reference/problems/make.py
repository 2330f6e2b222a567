"""Writes reference.json of every problem: thirty digits at the source's times, in the source's conventions.

    python make.py [NAME ...]       (mpmath, see tests/reference/requirements.txt; a minute)

The numbers are those of the exact motion (tests/reference/exact_motion.py). They are written only if two integrations of the
equations of motion, which share nothing with it or each other, agree with every printed digit: Gragg's extrapolation in
Cayley-Klein parameters (tests/reference/newton_euler.py), and for a body that is held or free a Taylor series in the source's body
axes (taylor.py). The free body is a rotation by exponentials in closed form.
"""
import json
import sys
from pathlib import Path

from mpmath import mp, mpc, mpf

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import exact_motion  # noqa: E402
import newton_euler  # noqa: E402
import taylor  # noqa: E402
from problems import problems  # noqa: E402

DIGITS, WORKING = 30, 60
AGREE = mpf("1e-32")


def times(a, b):
    """Product of two quaternions."""
    (w, x, y, z), (W, X, Y, Z) = a, b
    return [w * W - x * X - y * Y - z * Z, w * X + x * W + y * Z - z * Y, w * Y + y * W + z * X - x * Z, w * Z + z * W + x * Y - y * X]


def turned(q, v):
    conjugate = [q[0]] + [-x for x in q[1:]]
    return times(times(q, [mpf(0)] + list(v)), conjugate)[1:]


def to_third(axis):
    """Quaternion P that takes the source's axis of symmetry to the third body axis of the paper."""
    root = mp.sqrt(mpf(1) / 2)
    return {1: [root, root, mpf(0), mpf(0)], 2: [mpf(1), mpf(0), mpf(0), mpf(0)]}[axis]


def cayley_klein(q):
    w, x, y, z = q
    return mpc(w, z), mpc(-y, x)


def quaternion(alpha, beta):
    return [alpha.real, beta.imag, -beta.real, alpha.imag]


def exact(problem, conjugate, t):
    """Quaternion and fixed angular velocity of the exact motion."""
    if problem["p"] == 0:
        return free(problem, conjugate, t)
    root = mp.sqrt(problem["g"])
    if "motion" not in problem:
        q = times(problem["q"], conjugate)
        w = turned(problem["q"], problem["w"])
        body = [problem[key] for key in ("A", "C", "s", "p")]
        problem["motion"] = exact_motion.Motion(body, state=(*cayley_klein(q), [x / root for x in w]))
    _, _, alpha, beta, w, _ = problem["motion"].state(t * root)
    return quaternion(alpha, beta), [x * root for x in w]


def free(problem, conjugate, t):
    """A symmetric body without torque turns about L at |L|/A and about its axis at (1 - C/A) times its spin."""
    P = [conjugate[0]] + [-x for x in conjugate[1:]]
    w = turned(P, problem["w"])
    A, C = problem["A"], problem["C"]
    momentum = [A * w[0], A * w[1], C * w[2]]
    size = mp.sqrt(mp.fdot(momentum, momentum))
    about = lambda rate, axis: [mp.cos(rate * t / 2)] + [mp.sin(rate * t / 2) * x for x in axis]
    start = times(problem["q"], conjugate)
    q = times(times(start, about(size / A, [x / size for x in momentum])), about((1 - C / A) * w[2], [mpf(0), mpf(0), mpf(1)]))
    angle = -(1 - C / A) * w[2] * t
    c, s = mp.cos(angle), mp.sin(angle)
    body = [c * w[0] - s * w[1], s * w[0] + c * w[1], w[2]]
    return q, turned(q, body)


def samples(problem):
    P = to_third(problem["axis"])
    conjugate = [P[0]] + [-x for x in P[1:]]
    instants = [mpf(t) for t in problem["times"]]
    found = [exact(problem, conjugate, t) for t in instants]
    start, w = times(problem["q"], conjugate), turned(problem["q"], problem["w"])
    off = {}

    mp.dps = WORKING
    root = mp.sqrt(problem["g"])
    alpha, beta = cayley_klein(start)
    y = [alpha.real, alpha.imag, beta.real, beta.imag] + [x / root for x in w]
    scaled = [t * root for t in instants]
    states = newton_euler.integrate(*[problem[k] for k in ("A", "C", "s", "p")], y, scaled, mpf("1e-48"))
    pairs = [(quaternion(mpc(*s[:2]), mpc(*s[2:4])), [x * root for x in s[4:]]) for s in (states[t] for t in scaled)]
    off["extrapolation"] = distance(found, pairs)

    if problem["s"] == 0:
        A, C, axis = problem["A"], problem["C"], problem["axis"]
        moments = [C if i == axis else A for i in range(3)]
        runs = taylor.integrate(moments, problem["p"] * problem["g"], axis, problem["q"] + problem["w"], instants, mpf("1e-48"))
        pairs = [(times(s[:4], conjugate), turned(s[:4], s[4:])) for s in runs]
        off["taylor"] = distance(found, pairs)

    rows = []
    for text, (q, w) in zip(problem["times"], found):
        source = times(q, P)
        inverse = [source[0]] + [-x for x in source[1:]]
        position = [problem["length"] * x for x in turned(q, [mpf(0), mpf(0), mpf(1)])]
        digits = lambda vector: [mp.nstr(x if abs(x) > mpf("1e-40") else mpf(0), DIGITS, strip_zeros=False) for x in vector]
        rows.append({"t": text, "position": digits(position), "quaternion": digits(source), "omega_body": digits(turned(inverse, w))})
    mp.dps = 80
    return rows, off


def distance(ours, others):
    return max(abs(x - y) for (q, w), (Q, W) in zip(ours, others) for x, y in zip(q + list(w), Q + list(W)))


mp.dps = 80
chosen = sys.argv[1:]
for name, problem in problems().items():
    if chosen and name not in chosen:
        continue
    rows, off = samples(problem)
    agree = all(x < AGREE for x in off.values())
    print(name, {key: mp.nstr(x, 2) for key, x in off.items()}, "written" if agree else "NOT WRITTEN", flush=True)
    if agree:
        folder = HERE.parents[2] / "host" / "problems" / name
        folder.mkdir(exist_ok=True)
        record = {"confirmed_by": {key: mp.nstr(x, 2) for key, x in off.items()}, "samples": rows}
        (folder / "reference.json").write_text(json.dumps(record, indent=1) + "\n")

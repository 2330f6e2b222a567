"""Both versions of every slip of the printed paper, at 50 digits.

The truth is newton_euler.py. Rows are numbered as in core/closed-forms/docs/errata.md. Run without arguments to write data/errata.json; exits with 1 if a
printed version passes or a corrected one fails.
"""
import json
import os
import random
import sys

from mpmath import ellipk, exp, jtheta, log, mp, mpc, mpf, nstr, pi, quad, sqrt

from newton_euler import integrate, right_hand_side

mp.dps = 50
I = mpc(0, 1)
K = [0, 0, 1]
failed, rows = False, []


def row(number, what, printed, corrected):
    global failed
    failed |= not (printed > mpf("0.1") and corrected < mpf("1e-42"))
    rows.append({"number": number, "printed": nstr(printed, 30), "corrected": nstr(corrected, 2)})
    print(f"{number:>2} {what:36} printed {nstr(printed, 3):>7}   corrected {nstr(corrected, 2)}")


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def far(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


def axis(al, be):
    c = -2 * al * be
    return [c.real, c.imag, abs(al) ** 2 - abs(be) ** 2]


def product(x, y):
    (a, b, c, d), (e, f, g, h) = x, y
    return [a * e + b * g, a * f + b * h, c * e + d * g, c * f + d * h]


def inverse(x):
    a, b, c, d = x
    return [d, -b, -c, a]


def su2(x):
    return [mpc(0, x[2]) / 2, mpc(-x[1], x[0]) / 2, mpc(x[1], x[0]) / 2, mpc(0, -x[2]) / 2]


def as_printed(x):
    return [mpc(0, x[2]) / 2, mpc(x[1], x[0]) / 2, mpc(-x[1], x[0]) / 2, mpc(0, x[2]) / 2]


def instant():
    """Sections 2 to 4, at one instant of a generic motion."""
    A, C, s, p = mpf("1.1"), mpf("0.8"), mpf("0.6"), mpf("0.9")
    al, be, w = mpc("0.6", "0.3"), mpc("-0.2", "0.5"), [mpf("0.4"), mpf("-0.7"), mpf("1.3")]
    norm = sqrt(abs(al) ** 2 + abs(be) ** 2)
    al, be = al / norm, be / norm
    slope = right_hand_side(A, C, s, p)([al.real, al.imag, be.real, be.imag, *w])
    ald, bed, wd = mpc(*slope[:2]), mpc(*slope[2:4]), slope[4:]
    phi, rate = [al, be, -be.conjugate(), al.conjugate()], [ald, bed, -bed.conjugate(), ald.conjugate()]
    fixed, turned = product(rate, inverse(phi)), product(inverse(phi), rate)
    W = [2 * turned[1].imag, -2 * turned[1].real, 2 * turned[0].imag]
    row(1, "eqn:omega", far(fixed, as_printed(w)), far(fixed, su2(w)))
    row(2, "eqn:Omega", far(turned, as_printed(W)), far(turned, su2(W)))

    r = axis(al, be)
    q, u, S = cross(r, K), r[2], dot(w, r)
    rd, ud = cross(w, r), dot(w, q)
    qd, ps = cross(rd, K), p * s
    udd = dot(wd, q) + dot(w, qd)
    momentum = [A * w[i] + (C - A) * S * r[i] + ps * ud * q[i] for i in range(3)]
    change = [A * wd[i] + (C - A) * S * rd[i] + ps * (udd * q[i] + ud * qd[i]) for i in range(3)]
    side = [x - y for x, y in zip(change, cross(w, momentum))]
    a, b = cross(r, w), cross(r, cross(K, w))
    dl = {sign: [(C - A) * S * a[i] + ps * ud * b[i] + sign * p * q[i] for i in range(3)] for sign in (1, -1)}
    missed = [[x - y for x, y in zip(side, dl[sign])] for sign in (1, -1)]
    row(3, "DL", *[sqrt(dot(x, x)) for x in missed])
    l, n = momentum[2], dot(momentum, r)
    tau = (1 / C - 1 / A) * n
    row(4, "<omega, k>", abs(w[2] - l / A + tau * u), abs(w[2] - l / A - tau * u))

    e42 = 1 + A / ps
    curve = I * sqrt(s / 2) * (e42 - u * u) * ud
    ratio = (u * u - e42) / (1 - e42)
    truth = [x / y for x, y in zip(rate, phi)]

    def logs(sign):
        minus, plus = [sign * ratio * sqrt(s / 2) / ps * x / curve for x in (l + n, l - n)]
        t = I * tau / 2
        return [(1 + minus) * ud / (2 * (u + 1)) + t, (1 - plus) * ud / (2 * (u - 1)) - t,
                (1 + plus) * ud / (2 * (u - 1)) + t, (1 - minus) * ud / (2 * (u + 1)) - t]

    row(5, "first display of w", far(logs(1), truth), far(logs(-1), truth))
    minus, plus = [-sqrt(s / 2) / ps * x for x in (l + n, l - n)]
    sums = [I * (W[2] + w[2]), -I * (W[2] - w[2])]

    def lines(power):
        f = (power - e42) / (1 - e42) * ud / curve
        return [f * minus + I * (u + 1) * tau, f * plus + I * (u - 1) * tau]

    row(6, "i (Omega3 + omega3) dt", far(lines(u), sums), far(lines(u * u), sums))

    # d log alpha = (1 + F w_{-1}/w) du/(2(u+1)) at u = 1/v^2, w = v^-5 sqrt(...): residue by 64 nodes on |v| = 0.2
    e1, e2, e3 = mpf("-0.3"), mpf("0.6"), mpf("1.4")
    wm = sqrt((1 + e1) * (1 + e2) * (1 + e3) * (e42 - 1))
    total = mpc(0)
    for j in range(256):
        v = mpf("0.2") * exp(2 * pi * I * j / 256)
        z = v * v
        x = 1 / z
        root = sqrt((1 - e1 * z) * (1 - e2 * z) * (1 - e3 * z) * (1 - e42 * z * z)) / v ** 5
        total += (1 + (x * x - e42) / (1 - e42) * wm / root) / (2 * (x + 1)) * (-2 * x)
    total /= 256
    row(7, "residue at infinity", abs(total - 1), abs(total + 1))
    claimed = 2 * s * al * be
    row(8, "name of the curve", abs(be / phi[3] - claimed), abs(-s * mpc(r[0], r[1]) - claimed))


def loops():
    random.seed(1)
    wrong = [0, 0]
    for _ in range(1000):
        e1 = mpf(random.uniform(-0.99, 0.95))
        e2, e3 = mpf(random.uniform(float(e1) + 0.01, 0.99)), 1 + mpf(random.expovariate(0.5))
        plus = sqrt((1 + e1) * (1 + e2) * (1 + e3))
        minus = -sqrt((1 - e1) * (1 - e2) * (e3 - 1))
        turning = [plus * (1 - u) + minus * (1 + u) for u in (e1, e2)]
        truth = turning[0] * turning[1] < 0
        X = (1 + e1) * (1 - e2) / ((1 - e1) * (1 + e2))
        wrong[0] += (-(1 - e3) / (1 + e3) < X < -(1 + e3) / (1 - e3)) != truth
        wrong[1] += (X < (e3 - 1) / (e3 + 1)) != truth
        assert ((1 - e1 * e2) / (e2 - e1) < e3) == truth, "the final condition is right"
    row(9, "loops: share told wrongly", mpf(wrong[0]) / 1000, mpf(wrong[1]) / 1000)


class Lattice:
    """Weierstrass's functions from theta functions."""

    def __init__(self, roots):
        a, b, c = sorted(roots, reverse=True)
        m = (b - c) / (a - c)
        self.real, self.imaginary = ellipk(m) / sqrt(a - c), ellipk(1 - m) / sqrt(a - c)
        self.q, self.scale = exp(-pi * self.imaginary / self.real), pi / (2 * self.real)
        self.first = jtheta(1, 0, self.q, 1)
        self.eta = -pi ** 2 / (12 * self.real) * jtheta(1, 0, self.q, 3) / self.first

    def theta(self, z, order=0):
        return jtheta(1, self.scale * z, self.q, order)

    def sigma(self, z):
        return exp(self.eta * z * z / (2 * self.real)) * self.theta(z) / (self.scale * self.first)

    def zeta(self, z):
        return self.eta * z / self.real + self.scale * self.theta(z, 1) / self.theta(z)

    def p(self, z):
        slope = self.theta(z, 1) / self.theta(z)
        return -self.eta / self.real - self.scale ** 2 * (self.theta(z, 2) / self.theta(z) - slope ** 2)

    def dp(self, z):
        a, b, c, d = [self.theta(z, order) for order in range(4)]
        return -self.scale ** 3 * (d / a - 3 * c * b / a ** 2 + 2 * (b / a) ** 3)


def from_root(root, end, others, printed=False):
    """int du/sqrt|4 (u - root)(u - others)| by u = root +- y^2; printed: of the root of R itself."""
    side = 1 if end > root else -1

    def integrand(y):
        size = mpf(1)
        for other in others:
            size *= abs(root + side * y * y - other)
        return 4 * y * y * sqrt(size) if printed else 1 / sqrt(size)

    return quad(integrand, [0, sqrt(abs(end - root))])


def at_turning_point(A, C, u, plus, minus):
    l, n = (plus + minus) / 2, (plus - minus) / 2
    al, be = mpc(sqrt((1 + u) / 2)), mpc(0, sqrt((1 - u) / 2))
    r, turning = axis(al, be), (l - n * u) / (A * (1 - u * u))
    w = [(n / C - turning * u) * r[i] + turning * K[i] for i in range(3)]
    return [al.real, al.imag, be.real, be.imag, *w]


def full(top, start, t):
    y = integrate(*top, start, [t], mpf(10) ** -45)[t]
    al, be = mpc(*y[:2]), mpc(*y[2:4])
    r = axis(al, be)
    return al, be, r[2], dot(y[4:], cross(r, K))


def e3_equals_e4():
    one, A = mpf(1), mpf("1.25")
    e1, e2, e3 = mpf("-0.3"), mpf("0.6"), mpf("1.5")
    centre = (e1 + e2 - e3) / 3
    f = Lattice([e2 - centre, e1 - centre, -e3 - centre])
    w1, w2 = -I * f.imaginary, f.real
    plus = sqrt(2 * A * (1 + e1) * (1 + e2) * (1 + e3))
    minus = -sqrt(2 * A * (1 - e1) * (1 - e2) * (e3 - 1))
    x = mpf("0.7") * I
    t = (I * sqrt(mpf(2)) * (f.zeta(x - w2) + f.zeta(w2) - (e1 + e2 + 2 * e3) * x / 3)).real
    _, _, u, ud = full((A, A, one, one), at_turning_point(A, A, e2, plus, minus), t)
    row(10, "shift", abs(f.p(x - w1) + centre - u), abs(f.p(x - w2) + centre - u))

    def ends(printed):
        a, b = w1 + from_root(e1, -one, [e2, -e3], printed), from_root(e2, one, [e1, -e3], printed)
        return max(abs(f.p(a - w2) + centre + 1), abs(f.p(b - w2) + centre - 1))

    row(11, "a, b", ends(True), ends(False))
    way = ud / f.dp(x - w2)
    way /= abs(way)
    row(12, "direction of x", abs(way + I), abs(way - I))


def aperiodic():
    one, p, e1, e4 = mpf(1), mpf("0.8"), mpf("-0.2"), mpf("1.5")
    f = Lattice([e4 - e1 / 3, e1 - e1 / 3, -e4 - e1 / 3])
    w3, root2 = f.real + I * f.imaginary, sqrt(mpf(2))

    def ends(printed):
        return from_root(e1, -one, [e4, -e4], printed), -I * from_root(e1, one, [e4, -e4], printed)

    def off(a, b):
        return max(abs(f.p(a - w3) + e1 / 3 + 1), abs(f.p(b - w3) + e1 / 3 - 1))

    row(13, "a, b", off(*ends(True)), off(*ends(False)))
    a, b = ends(False)
    wm = root2 * (1 - e4 ** 2) * sqrt(2 * p * (1 + e1))
    a = a if abs(f.dp(a - w3) - wm) < 1 else -a
    wp, x = f.dp(b - w3), mpf("0.6") * b
    branch, before = mpc(0), mpc(1)
    for j in range(1, 65):  # log(-sigma(x-b)/sigma(x+b)), 0 at x = 0
        now = -f.sigma(x * j / 64 - b) / f.sigma(x * j / 64 + b)
        branch, before = branch + log(now / before), now

    def time(sign):
        third = branch + 2 * (f.zeta(w3) + sign * f.zeta(b - w3)) * x
        return I * root2 * (-f.zeta(x - w3) - f.zeta(w3) + (1 + e1 / 3) * x + (1 - e4 ** 2) / wp * third)

    start = at_turning_point(one, one, e1, sqrt(8 * p * (1 + e1)), mpf(0))
    t, target = mpf("1.4"), (f.p(x - w3) + e1 / 3).real
    for _ in range(8):
        _, _, u, ud = full((one, one, one, p), start, t)
        t -= (u - target) / ud
    al, be, _, _ = full((one, one, one, p), start, t)
    row(14, "t(x)", abs(time(-1) - t), abs(time(1) - t))

    def parameters(sign_p, sign_l):
        power = sign_p * wm / (2 * wp)
        l = wm / 4 - wm / (1 - e4 ** 2) + f.zeta(a - w3) - power * (f.zeta(a + b) + sign_l * f.zeta(a - b))
        k = sqrt((1 + e1) / 2) * f.sigma(w3) / f.sigma(a)
        turn = exp(l * x - power * branch)
        return (k * turn * f.sigma(x - a) / f.sigma(x - w3), k / turn * f.sigma(x + a) / f.sigma(x + w3))

    row(15, "p", abs(parameters(-1, -1)[0] - al), abs(parameters(1, -1)[0] - al))
    row(16, "l", abs(parameters(1, 1)[0] - al), abs(parameters(1, -1)[0] - al))

    # at (-1, -w_{-1}): the lower half of Table 2 says residue 1; d log beta = du/(2(u-1)), d log delta has it
    def residue(integrand):
        total = mpc(0)
        for j in range(256):
            z = mpf("0.2") * exp(2 * pi * I * j / 256)
            total += integrand(z - 1) * z
        return total / 256

    def delta(z):
        w = -wm * sqrt((z - e1) * (z * z - e4 ** 2) / ((-1 - e1) * (1 - e4 ** 2)))
        return (1 + 2 / (z - 1) * (z * z - e4 ** 2) / (1 - e4 ** 2) * wm / w) / (2 * (z + 1))

    row(17, "Table 2, lower half", abs(residue(lambda z: 1 / (2 * (z - 1))) - 1), abs(residue(delta) - 1))
    line = parameters(1, -1)[1]
    row(18, "eqn:aperform, second line", abs(line - be), abs(line - al.conjugate()))


if __name__ == "__main__":
    instant()
    loops()
    e3_equals_e4()
    aperiodic()
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "data", "errata.json"), "w") as file:
        json.dump({"rows": rows}, file, indent=1)
        file.write("\n")
    sys.exit(failed)

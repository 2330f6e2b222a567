"""The exact motion of the toy top at 80 digits: quadrature of t(theta), Newton inversion, half-angle brackets.

The tilt is u = e1 + (e2-e1) sin^2(theta/2) with theta' = sqrt(2 (e3-u) / D), D = A/p + s (1-u^2), and

    alpha = 2^(-1/2) e^{i (a0 + psiA + tau t/2)} [sqrt(1+e1) cos(theta/2) + i s_plus  sqrt(1+e2) sin(theta/2)]
    beta  = 2^(-1/2) e^{i (b0 + psiB - tau t/2)} [sqrt(1-e1) cos(theta/2) + i s_minus sqrt(1-e2) sin(theta/2)]

so every time, however large, is a whole number of periods plus one Newton solve within half a period.
Deliberately unlike a fast implementation: no elliptic function, no AGM, no trapezoidal rule, no series.
"""
from bisect import bisect_right

from mpmath import mp, mpc, mpf

mp.dps = 80
NODES = 64            # Gauss-Legendre nodes per panel
QUADRATURE = mpf("1e-70")  # a panel is halved until its integral agrees with those of its halves to this
ZERO = mpf("1e-50")   # far below any quantity of these motions, far above the rounding at 80 digits


def gauss_legendre(n):
    rule = []
    for i in range(n // 2):
        x = mp.cos(mp.pi * (4 * i + 3) / (4 * n + 2))
        for _ in range(8):
            a, b = mpf(1), x
            for k in range(2, n + 1):
                a, b = b, ((2 * k - 1) * x * b - (k - 1) * a) / k
            slope = n * (a - x * b) / (1 - x * x)
            x -= b / slope
        weight = 2 / ((1 - x * x) * slope * slope)
        rule += [(x, weight), (-x, weight)]
    return rule


RULE = gauss_legendre(NODES)


class HalfPeriod:
    """t, psiA, psiB over 0 <= theta <= pi (u from e1 to e2), as functions of one variable x.

    With tan(theta/2) = sinh(x), e3-u is (d + D sech^2 x), d = e3-e2, D = e2-e1, and dtheta/sqrt(e3-u) is
    2 dx/sqrt(d+D + d sinh^2 x): no layer at u = e2 however small d is, and for d = 0 the whole asymptotic
    motion is 0 <= x < oo. For d > 0 the mirrored variable, sinh(x) sinh(y) = 1/k with k^2 = d/(d+D), gives
    the same integrand from the other end, so the two halves meet where x = y = `middle`; beyond it
    x stands for 2 middle - y.
    """

    def __init__(self, motion):
        self.m = motion
        self.k = mp.sqrt(motion.e32 / (motion.e32 + motion.e21))
        self.left, self.value = [mpf(0)], [(mpf(0),) * 3]
        self.middle = mp.asinh(1 / mp.sqrt(self.k)) if self.k else mp.inf
        if self.k:
            count = int(mp.ceil(2 * self.middle))
            for i in range(2 * count):
                self.extend(self.middle * (i + 1) / count)
        self.end = self.value[-1]

    def geometry(self, x):
        """sin(theta/2), cos(theta/2), (dtheta/dx) / sqrt(e3-u)."""
        mirrored = x > self.middle
        z = mp.sinh(2 * self.middle - x if mirrored else x)
        scale = 2 / mp.sqrt(self.m.e32 * (1 + z * z) + self.m.e21)
        if mirrored:
            z *= self.k
        far = 1 / mp.sqrt(1 + z * z)
        return (far, z * far, scale) if mirrored else (z * far, far, scale)

    def rates(self, x):
        """dt/dx, dpsiA/dx, dpsiB/dx."""
        sin, cos, scale = self.geometry(x)
        D, _, a, b = self.m.rates(cos)
        dt = scale * mp.sqrt(D / 2)
        return dt, a * dt, b * dt

    def quadrature(self, a, b):
        h, c, total = (b - a) / 2, (a + b) / 2, [mpf(0)] * 3
        for x, w in RULE:
            total = [v + w * r for v, r in zip(total, self.rates(c + h * x))]
        return [h * v for v in total]

    def extend(self, b, whole=None):
        a = self.left[-1]
        whole, c = whole or self.quadrature(a, b), (a + b) / 2
        halves = self.quadrature(a, c), self.quadrature(c, b)
        good = all(abs(l + r - w) < QUADRATURE * (1 + abs(w)) for w, l, r in zip(whole, *halves))
        for x, part in ((c, halves[0]), (b, halves[1])):
            if good:
                self.left.append(x)
                self.value.append(tuple(v + d for v, d in zip(self.value[-1], part)))
            else:
                self.extend(x, part)

    def at(self, x):
        while x > self.left[-1] and not self.k:
            self.extend(self.left[-1] + mpf(1) / 2)
        i = bisect_right(self.left, x) - 1
        return [v + d for v, d in zip(self.value[i], self.quadrature(self.left[i], x))]

    def at_angle(self, sin, cos):
        if sin > cos * mp.sinh(self.middle):
            return self.at(2 * self.middle - mp.asinh(cos / (sin * self.k)))
        return self.at(mp.asinh(sin / cos))

    def at_time(self, t):
        """sin(theta/2), cos(theta/2), psiA, psiB at the time t >= 0 after theta = 0, by Newton's method."""
        while t >= self.value[-1][0] and not self.k:
            self.extend(self.left[-1] + mpf(1) / 2)
        i = min(bisect_right([v[0] for v in self.value], t) - 1, len(self.left) - 2)
        (a, b), (ta, tb) = self.left[i:i + 2], (v[0] for v in self.value[i:i + 2])
        x = a + (b - a) * (t - ta) / (tb - ta)
        while True:
            value = self.at(x)
            dx = (t - value[0]) / self.rates(x)[0]
            if abs(dx) < mpf("1e12") * mp.eps * (1 + x):  # quadratic convergence: the remaining error is far below
                return self.geometry(x)[:2] + tuple(value[1:])
            x = min(max(x + dx, a), b)


def integrals(A, C, s, p, al, be, w):
    """u, u', l = <m,k>, n = <m,r> and the symmetric functions of e1, e2, e3, from their definitions."""
    r = (-2 * (al * be).real, -2 * (al * be).imag, abs(al) ** 2 - abs(be) ** 2)
    spin = sum(x * y for x, y in zip(w, r))
    udot, l, n = w[0] * r[1] - w[1] * r[0], A * w[2] + (C - A) * spin * r[2], C * spin
    H = r[2] + (A * (sum(x * x for x in w) - spin ** 2) + p * s * udot ** 2) / (2 * p)
    kappa = 1 / (2 * A * p)
    return r[2], udot, l, n, (H + kappa * n * n, 2 * kappa * l * n - 1, kappa * l * l - H)


class Motion:
    def __init__(self, body, e=None, signs=None, theta0=None, args=None, state=None):
        self.A, self.C, self.s, self.p = self.body = body
        A, C, s, p = body
        self.fixed = None
        if state:
            al, be, w = state
            norm = mp.sqrt(abs(al) ** 2 + abs(be) ** 2)
            al, be = al / norm, be / norm
            u, udot, l, n, (s1, s2, s3) = integrals(A, C, s, p, al, be, w)
            signs = [-1 if x < -ZERO else 1 for x in (l + n, l - n)]
            if abs(al * be) + abs(w[0]) + abs(w[1]) < ZERO:  # spinning about the vertical: not on the curve
                self.fixed, e = (al, be, w), sorted([u, u, u * (n * n / (2 * A * p) - 1)])
            else:  # the three real roots; a root at +-1 is exact, not merely near it
                e = sorted(mp.re(x) for x in mp.polyroots([1, -s1, s2, -s3], 500, extraprec=600))
                e = [mp.nint(x) if abs(abs(x) - 1) < ZERO else x for x in e]
        self.e = self.e1, self.e2, self.e3 = e
        self.sp, self.sm = signs
        self.e21, self.e32 = e[1] - e[0], e[2] - e[1]
        self.m1, self.m2, self.m3 = 1 - e[0], 1 - e[1], e[2] - 1
        self.l_plus_n = self.sp * mp.sqrt(2 * A * p * (1 + e[0]) * (1 + e[1]) * (1 + e[2]))
        self.l_minus_n = self.sm * mp.sqrt(2 * A * p * self.m1 * self.m2 * self.m3)
        self.l, self.n = (self.l_plus_n + self.l_minus_n) / 2, (self.l_plus_n - self.l_minus_n) / 2
        self.tau = (1 / C - 1 / A) * self.n
        self.h = self.n ** 2 / (2 * C) + self.l ** 2 / (2 * A) - p * e[0] * e[1] * e[2]
        self.periodic, self.constant = self.e32 > 0, self.e21 == 0 or self.fixed is not None
        # A bracket with a vanishing cosine (sine) term is real up to a constant factor: it changes sign
        # where the axis passes the vertical, and that sign goes into rho, not into phi.
        self.wind_a, self.wind_b = e[0] != -1, e[1] != 1
        self.phi_signed = not self.constant and not (self.wind_a and self.wind_b)
        if self.fixed:
            return
        self.half = HalfPeriod(self)
        self.T, self.psi_a, self.psi_b = (2 * v for v in self.half.end)
        if state:
            if self.constant:
                theta0 = mpf(0)
            else:
                D = A / p + s * (1 - u * u)
                half_sin = udot / (self.e21 * mp.sqrt(2 * (self.e3 - u) / D))
                theta0 = mp.atan2(2 * half_sin, ((e[0] + e[1]) - 2 * u) / self.e21)
        self.theta0 = theta0
        turns = int(mp.floor(theta0 / (2 * mp.pi) + mpf(1) / 2))
        rest = theta0 / 2 - mp.pi * turns
        value = self.half.at_angle(abs(mp.sin(rest)), mp.cos(rest))
        sign = -1 if rest < 0 else 1
        self.start = [(turns * 2 * v if turns else 0) + sign * d for v, d in zip(self.half.end, value)]
        self.start += [self.winding(turns, mp.sin(rest), mp.cos(rest))]
        # Phases of alpha and beta; where one of them vanishes at t = 0, the phase is that of its derivative.
        bracket, slope = self.brackets(turns, mp.sin(rest), mp.cos(rest))
        unit = [mp.expj(a) for a in args] if args else [al, be]
        if state:
            m = mpc(-w[1], w[0])
            moving = [(1j * w[2] * al - m * mp.conj(be)) / 2, (1j * w[2] * be + m * mp.conj(al)) / 2]
        self.phase = []
        for i in range(2):
            if abs(bracket[i]) > ZERO:
                z = unit[i] / bracket[i]
            else:
                z = (moving[i] if state else unit[i]) / slope[i] if slope[i] else unit[i]
            self.phase.append(z / abs(z))
        c, c_dot = (self.phase[0] * self.phase[1] * z for z in (
            bracket[0] * bracket[1], bracket[0] * slope[1] + bracket[1] * slope[0]))
        self.phi0 = mp.arg(c if abs(c) > ZERO else c_dot)

    def rates(self, cos):
        """D, theta', psiA', psiB'. No psi' divides by 1-u or 1+u: the winding is in the brackets."""
        A, s, p = self.A, self.s, self.p
        down = self.m2 + self.e21 * cos * cos  # 1-u
        D = A / p + s * down * (2 - down)
        theta_dot = mp.sqrt(2 * (self.e32 + self.e21 * cos * cos) / D)
        a = self.l_plus_n * (A / p + s * down * (self.e3 + 1))
        a /= 2 * A * (self.e3 + 1) * D * (1 + mp.sqrt(A / (2 * p * (self.e3 + 1))) * theta_dot)
        if not self.m2:
            return D, theta_dot, a, mpf(0)
        b = self.sm * mp.sqrt(2 * A * p * self.m1 * self.m2) * (s * (2 - down) * self.m3 - A / p)
        b /= 2 * A * D * (mp.sqrt(self.m3) + mp.sqrt(A / (2 * p)) * theta_dot)
        return D, theta_dot, a, b

    def brackets(self, turns, sin, cos):
        """The two half-angle brackets, with their factor 2^(-1/2), and their derivatives by theta/2."""
        sin, cos = ((-1) ** turns * v / mp.sqrt(2) for v in (sin, cos))
        a, b = mp.sqrt(1 + self.e1), 1j * self.sp * mp.sqrt(1 + self.e2)
        c, d = mp.sqrt(self.m1), 1j * self.sm * mp.sqrt(self.m2)
        return (a * cos + b * sin, c * cos + d * sin), (b * cos - a * sin, d * cos - c * sin)

    def winding(self, turns, sin, cos):
        """Continuous sum of the arguments of the brackets, without that of a bracket that vanishes."""
        a = mp.atan2(mp.sqrt(1 + self.e2) * sin, mp.sqrt(1 + self.e1) * cos) if self.wind_a else 0
        b = mp.atan2(mp.sqrt(self.m2) * sin, mp.sqrt(self.m1) * cos) if self.wind_b else 0
        return self.sp * (a + mp.pi * turns * self.wind_a) + self.sm * (b + mp.pi * turns * self.wind_b)

    def state(self, t):
        """u, u', alpha, beta, omega, phi at the time t."""
        if self.fixed:
            al, be, w = self.fixed
            spin = mp.expj(w[2] * t / 2)
            return abs(al) ** 2 - abs(be) ** 2, mpf(0), al * spin, be * spin, w, mp.arg(al * be)
        time = t + self.start[0]
        turns = int(mp.floor(time / self.T + mpf(1) / 2)) if self.periodic else 0
        rest = time - turns * self.T if turns else time
        sign = -1 if rest < 0 else 1
        sin, cos, psi_a, psi_b = self.half.at_time(abs(rest))
        sin *= sign
        psi_a = turns * self.psi_a + sign * psi_a - self.start[1]
        psi_b = turns * self.psi_b + sign * psi_b - self.start[2]
        bracket, slope = self.brackets(turns, sin, cos)
        za = self.phase[0] * mp.expj(psi_a + self.tau * t / 2)
        zb = self.phase[1] * mp.expj(psi_b - self.tau * t / 2)
        al, be = za * bracket[0], zb * bracket[1]
        _, theta_dot, rate_a, rate_b = self.rates(cos)
        al_dot = 1j * (rate_a + self.tau / 2) * al + za * slope[0] * theta_dot / 2
        be_dot = 1j * (rate_b - self.tau / 2) * be + zb * slope[1] * theta_dot / 2
        # omega from the entries of 2 Phi' Phi^-1, which are regular at the vertical
        spin, m = 2 * (al_dot * mp.conj(al) + be_dot * mp.conj(be)), 2 * (be_dot * al - al_dot * be)
        phi = self.phi0 + psi_a + psi_b + self.winding(turns, sin, cos) - self.start[3]
        return (self.e1 + self.e21 * sin * sin, self.e21 * sin * cos * theta_dot, al, be,
                (m.imag, -m.real, spin.imag), phi)

"""Reference vectors for the exact motion of the toy top whose inputs are exact in f64.

    python generate.py --list           the motions this file defines
    python generate.py NAME ...         write vectors/NAME.json
    python generate.py --all            write all of them (about 5 minutes on one core)
    python generate.py --check          recompute every vector in vectors/ from its definition and compare
                                        all numbers stored in it (about 2 minutes); status 1 if one is off

Needs mpmath only (requirements.txt). The motion itself is in exact_motion.py: 80 digits, quadrature and
Newton inversion. README.md describes the format of the vectors.

How the vectors are checked (measured):
  * Each written vector carries a `crosscheck`: alpha and beta at all its samples against newton_euler.py, which
    integrates the three-dimensional Newton-Euler equations (60 digits, local tolerance 1e-50) both ways over all
    +-3 periods. Worst: 2.2e-49; where the motion amplifies the integrator's error 6.6e-45 (near separatrix) and
    1.8e-46 (aperiodic). l, n and the symmetric functions of e1, e2, e3 agree with their definitions to 7e-80.
  * --check reproduces the 31 vectors with decimal inputs, made by another program, to all 30 digits (1e-29), 1e9
    periods included, but for two with an input known only to the 30 digits in the file: lagrange_limit_e4_1e4 (s;
    6e-29), loop_n_zero (e1, e3; 3e-20 at 1e9 periods, 7e-31 if they are solved for from l = 0.9, n = 0).
    growth_rate and T_SI_seconds are not recomputed.
  * phi, unwound in small steps along a double precision integration, agrees at all samples to what that resolves:
    2e-10; 2e-7 near the separatrix; aperiodic 4e-2 at |t| = 20, where |c| is 1e-6 (1e-8 in c).
"""
import json
import sys
from decimal import Decimal
from pathlib import Path

from mpmath import mp, mpc, mpf

from exact_motion import Motion, integrals
from newton_euler import integrate

VECTORS = Path(__file__).resolve().parent / "vectors"
BY_ROOTS = "e1,e2,e3,s_plus=sign(l+n),s_minus=sign(l-n)"
BY_STATE = "initial alpha,beta,omega (exact decimals)"

# Everything below is a dyadic number, so the f64 written here, its decimal expansion in the vector and
# the f64 parsed back from that are the same number. Bodies are (A, C, s, p).
BODY, STEEP = (1.3125, 0.6875, 0.8125, 1.125), (1.125, 0.625, 0.6875, 1.3125)
THIN, HEAVY = (1.25, 0.75, 0.5, 1.0), (1.25, 0.5, 0.59375, 0.90625)
ELLIPTIC, ROUND = (0.78125, 0.59375, 0.5, 1.25), (1.5625, 1.5625, 1.25, 1.0)
# theta, arg alpha, arg beta at t = 0
ANGLES, EARLY, BACK = (0.875, 0.3125, -1.125), (0.40625, 0.1875, 0.5), (-2.25, 2.75, 1.25)


def roots(note, body, e1, e2, e3, signs, angles):
    return dict(note=note, body=body, e=(e1, e2, e3), signs=signs, theta0=angles[0], args=angles[1:])


def state(note, body, alpha, beta, omega):
    return dict(note=note, body=body, state=(alpha, beta, omega))


GENERIC = -0.34375, 0.625, 1.6875
MOTIONS = {
    "exact_generic_pp": roots("generic, A!=C, l+n>0, l-n>0", BODY, *GENERIC, (1, 1), ANGLES),
    "exact_generic_pm": roots("generic, A!=C, l+n>0, l-n<0", BODY, *GENERIC, (1, -1), ANGLES),
    "exact_generic_mp": roots("generic, A!=C, l+n<0, l-n>0", BODY, *GENERIC, (-1, 1), ANGLES),
    "exact_generic_mm": roots("generic, A!=C, l+n<0, l-n<0, starts with u'<0", BODY, *GENERIC, (-1, -1), BACK),
    "exact_fast_spin": roots("e3=2^13", (1.25, 0.75, 1.0, 1.0), 0.296875, 0.298828125, 2.0 ** 13, (1, -1),
                             (0.1875, 0.25, -0.625)),
    "exact_near_separatrix_straddle": roots("e2=1-2^-21, e3=1+2^-21", THIN, -0.3125, 1 - 2 ** -21,
                                            1 + 2 ** -21, (1, 1), (0.125, 0.25, 0.5)),
    "exact_near_separatrix_e2_1": roots("e2=1, e3=1+2^-20", THIN, -0.3125, 1.0, 1 + 2 ** -20, (1, 1),
                                        (0.125, 0.25, 0.5)),
    "exact_near_vertical_pass": roots("e2=1-2^-27: arg beta and phi turn by about pi in a short time",
                                      STEEP, -0.1875, 1 - 2 ** -27, 1.625, (1, -1), EARLY),
    "exact_near_downward_pass": roots("e1=-1+2^-27: arg alpha and phi turn by about pi in a short time",
                                      STEEP, -1 + 2 ** -27, 0.3125, 1.625, (-1, 1), EARLY),
    "exact_e1_m1": roots("e1=-1 (l=-n): axis passes through the downward vertical", STEEP, -1.0, 0.3125,
                         1.625, (1, -1), EARLY),
    "exact_e2_1": roots("e2=1 (l=n): axis passes through the upward vertical", STEEP, -0.1875, 1.0, 1.625,
                        (-1, 1), EARLY),
    "exact_e3_1": roots("e3=1 (l=n) with e2<1", THIN, 0.6875, 0.90625, 1.0, (1, 1), (0.0, 0.25, 0.5)),
    "exact_planar": roots("e1=-1, e2=1 (l=n=0): planar full rotation through both verticals", BODY, -1.0,
                          1.0, 1.40625, (1, 1), (0.5, 0.3125, 0.125)),
    "exact_tiny_nutation": roots("e2-e1=2^-20", BODY, 0.40625, 0.40625 + 2 ** -20, 2.1875, (1, 1),
                                 (0.3125, 0.125, 0.1875)),
    "exact_regular_precession_pp": roots("e1=e2, l-n>0 (fast precession)", BODY, 0.40625, 0.40625, 2.1875,
                                         (1, 1), (0.0, 0.125, 0.1875)),
    "exact_regular_precession_pm": roots("e1=e2, l-n<0 (slow precession)", BODY, 0.40625, 0.40625, 2.1875,
                                         (1, -1), (0.0, 0.125, 0.1875)),
    "exact_aperiodic": roots("e2=e3=1, A!=C: asymptotic to the upward vertical for t -> +-infinity",
                             (1.125, 0.65625, 0.59375, 0.90625), -0.25, 1.0, 1.0, (-1, 1),
                             (0.3125, 0.3125, 1.125)),
    "exact_lagrange": roots("s=0: exact Lagrange top (A, C = moments about the tip)",
                            (1.3125, 0.90625, 0.0, 1.125), -0.40625, 0.5, 1.8125, (1, -1),
                            (0.8125, 0.125, 0.6875)),
    "exact_small_A": roots("A/(ps)=2^-4: e4 only just above 1", (0.0625, 0.09375, 1.0, 1.0), -0.875, 0.9375,
                           1.5, (1, -1), (0.75, -0.5, 2.0)),
    # e3 = e4 exactly: A = (e4^2 - 1) p s
    "exact_e3_e4_pp": roots("e3=e4=3/2, A!=C, l+n>0, l-n>0", ELLIPTIC, -0.34375, 0.625, 1.5, (1, 1), ANGLES),
    "exact_e3_e4_pm": roots("e3=e4=3/2, A!=C, l+n>0, l-n<0", ELLIPTIC, -0.34375, 0.625, 1.5, (1, -1), ANGLES),
    "exact_e3_e4_mp": roots("e3=e4=3/2, A!=C, l+n<0, l-n>0", ELLIPTIC, -0.34375, 0.625, 1.5, (-1, 1), ANGLES),
    "exact_e3_e4_mm": roots("e3=e4=3/2, A!=C, l+n<0, l-n<0, starts with u'<0", ELLIPTIC, -0.34375, 0.625, 1.5,
                            (-1, -1), BACK),
    "exact_e3_e4_e2_1": roots("e3=e4=3/2, e2=1, A=C", ROUND, -0.1875, 1.0, 1.5, (1, 1), EARLY),
    "exact_e3_e4_e1_m1": roots("e3=e4=3/2, e1=-1, A=C", ROUND, -1.0, 0.3125, 1.5, (1, -1), EARLY),
    "exact_lagrange_aperiodic": roots("s=0, e2=e3=1: the Lagrange top rises to the vertical",
                                      (1.3125, 0.90625, 0.0, 1.125), -0.40625, 1.0, 1.0, (1, 1), (0.8125, 0.125, 0.6875)),
    "exact_lagrange_e2_1": roots("s=0, e2=1", (1.3125, 0.90625, 0.0, 1.125), -0.40625, 1.0, 1.8125, (-1, 1), EARLY),
    "exact_lagrange_e1_m1": roots("s=0, e1=-1, starts with u'<0", (1.3125, 0.90625, 0.0, 1.125), -1.0, 0.375, 1.25,
                                  (1, 1), BACK),
    "exact_state_generic": state("generic state, u'<0; the f64 nearest to a unit quaternion",
                                 HEAVY, (0.48, 0.64), (0.36, -0.48), (0.375, -0.6875, 2.1875)),
    "exact_state_off_norm": state("|alpha|^2+|beta|^2 is off 1 by about 3e-7: means alpha/N, beta/N",
                                  HEAVY, (-0.5, 0.25), (0.75, 0.35355377197265625), (-0.8125, 1.375, 1.125)),
    "exact_state_vertical": state("starts exactly upright (beta=0), horizontal omega: l=n=0, planar", BODY,
                                  (0.6, 0.8), (0.0, 0.0), (0.75, -0.3125, 0.0)),
    "exact_state_vertical_spin": state("starts exactly upright (beta=0), spinning and moving: e2=1, l=n",
                                       BODY, (-0.6, 0.8), (0.0, 0.0), (-0.25, 0.625, 1.8125)),
    "exact_state_downward": state("starts exactly downward (alpha=0), spinning and moving: e1=-1, l=-n",
                                  BODY, (0.0, 0.0), (0.28, -0.96), (0.9375, 0.5, -1.375)),
}
# Sample times in periods (for the aperiodic motion: in units of sqrt(A/p)).
TIMES = 0, 0.15, 0.41, 0.5, 0.85, 1.23, 1.77, 2.3, 2.95, -0.35, -1.2, -2.65
TIMES_APERIODIC = 0, 0.7, 1.9, 3.4, 5.5, 9, 14, 20, -1.1, -4.3, -11, -19
HUGE = [(n, f) for n in (10 ** 3, 10 ** 6, 10 ** 9) for f in (mpf("0.137"), mpf("0.5"), mpf("0.861"))]


def exact(x):
    """The full decimal expansion of an f64."""
    text = format(Decimal(x), "f")
    assert float(text) == x and Decimal(text) == Decimal(x)
    return text


def digits(x):
    if isinstance(x, mpc):
        return [digits(x.real), digits(x.imag)]
    return mp.nstr(mpf(0) if abs(x) < mpf("1e-60") else x, 30)


def build(name):
    """The motion of a definition and the description of it that goes into the vector."""
    d = MOTIONS[name]
    params = dict(zip("ACsp", map(exact, d["body"])))
    body = [mpf(x) for x in d["body"]]
    if "state" in d:
        alpha, beta, omega = d["state"]
        assert abs(sum(x * x for x in alpha + beta) - 1) <= 1e-6
        motion = Motion(body, state=(mpc(*alpha), mpc(*beta), [mpf(x) for x in omega]))
        params["defined_by"] = BY_STATE
        params.update(alpha0=[exact(x) for x in alpha], beta0=[exact(x) for x in beta],
                      omega0=[exact(x) for x in omega])
    else:
        motion = Motion(body, [mpf(x) for x in d["e"]], d["signs"], mpf(d["theta0"]), [mpf(x) for x in d["args"]])
        params["defined_by"] = BY_ROOTS
        params.update(zip(("theta0", "arg_alpha0", "arg_beta0"), map(exact, (d["theta0"],) + d["args"])))
    return motion, params


def sample_times(motion):
    """f64 numbers with few bits, near the wanted multiples of the period."""
    unit = motion.T if motion.periodic else mp.sqrt(motion.A / motion.p)
    grain = mpf(2) ** (mp.floor(mp.log(unit, 2)) - 12)
    near = [float(mp.nint(unit * f / grain) * grain) for f in (TIMES if motion.periodic else TIMES_APERIODIC)]
    huge = [float(mp.nint(unit * (n + f) / grain) * grain) for n, f in HUGE] if motion.periodic else []
    return near, huge


def sample(motion, t, text):
    u, udot, al, be, _, phi = motion.state(t)
    c = 2 * (motion.s or 1) * al * be
    return dict(t=text, u=digits(u), udot=digits(udot), alpha=digits(al), beta=digits(be),
                gamma=digits(-mp.conj(be)), delta=digits(mp.conj(al)), c=digits(c), phi=digits(phi))


def document(motion, head, times, huge):
    """The vector; `times` and `huge` are pairs (number, text), `huge` with a period count as third entry."""
    doc, m = dict(head), motion
    u, udot, al, be, omega, _ = m.state(mpf(0))
    e4 = 1 + m.A / (m.p * m.s) if m.s else mp.inf
    doc.update(s_plus=m.sp, s_minus=m.sm, e1=digits(m.e1), e2=digits(m.e2), e3=digits(m.e3),
               e4=digits(mp.sqrt(e4)) if m.s else "inf", e4_squared=digits(e4) if m.s else "inf")
    for key in ("l", "n", "h", "tau", "l_plus_n", "l_minus_n"):
        doc[key] = digits(getattr(m, key))
    doc["initial"] = dict(alpha=digits(al), beta=digits(be), omega_fixed=[digits(w) for w in omega],
                          u=digits(u), udot=digits(udot))
    if not m.fixed:
        doc["initial"]["theta"] = digits(m.theta0)
    doc["phi_signed"] = m.phi_signed
    doc["phi_convention"] = (
        "signed: c = rho_s*exp(i*phi) with rho_s smooth and changing sign each time the axis passes the "
        "vertical (phi itself smooth); compare c, or phi mod pi" if m.phi_signed else "continuous argument of c")
    doc["c_convention"] = "c = 2*s*alpha*beta" if m.s else "s=0 (exact Lagrange top): c field holds 2*alpha*beta"
    doc["samples"] = [sample(m, t, text) for t, text in times]
    doc["huge_samples"] = [dict(sample(m, t, text), period_count=str(n)) for t, text, n in huge]
    if m.periodic and not m.fixed:
        turn_a, turn_b = m.psi_a + m.tau * m.T / 2, m.psi_b - m.tau * m.T / 2
        doc["period"] = dict(
            T=digits(m.T), delta_arg_alpha=digits(turn_a + mp.pi * m.sp * m.wind_a),
            delta_arg_beta=digits(turn_b + mp.pi * m.sm * m.wind_b),
            delta_phi=digits(m.psi_a + m.psi_b + mp.pi * (m.sp * m.wind_a + m.sm * m.wind_b)),
            alpha_multiplier=digits(-mp.expj(turn_a)), beta_multiplier=digits(-mp.expj(turn_b)),
            definition="alpha(t+T)=alpha_multiplier*alpha(t), beta likewise; T = time e1->e2->e1")
    return doc


def crosscheck(motion, times):
    """Worst difference from the integrated Newton-Euler equations, and from the e's by their definition."""
    _, _, al, be, w, _ = motion.state(mpf(0))
    e, p3 = motion.e, integrals(*motion.body, al, be, w)
    symmetric = (e[0] + e[1] + e[2], e[0] * e[1] + (e[0] + e[1]) * e[2], e[0] * e[1] * e[2])
    roots_off = max(abs(x - y) / (1 + abs(x)) for x, y in zip(
        (*symmetric, motion.l, motion.n), (*p3[4], p3[2], p3[3])))
    closed = {t: motion.state(t)[2:4] for t in times}
    worst = mpf(0)
    with mp.workdps(60):  # shorter numbers for the integration only
        for side in ([t for t in times if t > 0], [t for t in times if t < 0]):
            y = [al.real, al.imag, be.real, be.imag, *w]
            for t, y in integrate(*motion.body, y, side, mpf("1e-50")).items():
                worst = max(worst, abs(closed[t][0] - mpc(*y[:2])), abs(closed[t][1] - mpc(*y[2:4])))
    periods = [mp.nstr(f(times) / motion.T, 3) for f in (min, max)] if motion.periodic else "n/a"
    return dict(engine="Gragg-Bulirsch-Stoer extrapolation on Newton-Euler", max_abs_diff_alpha_beta=mp.nstr(worst, 3),
                from_t=exact(float(min(times))), up_to_t=exact(float(max(times))), periods=periods,
                max_diff_of_e_l_n_from_their_definitions=mp.nstr(roots_off, 3))


def generate(name):
    motion, params = build(name)
    near, huge = sample_times(motion)
    head = dict(name=name, note=MOTIONS[name]["note"], exact_in_f64=True, units="g=1; mass M=p/s", params=params)
    doc = document(motion, head, [(mpf(t), exact(t)) for t in near],
                   [(mpf(t), exact(t), n) for t, (n, _) in zip(huge, HUGE)])
    if "e" in MOTIONS[name]:
        doc.update(zip(("e1", "e2", "e3"), map(exact, MOTIONS[name]["e"])))
    if motion.constant:
        doc["degenerate_note"] = ("u constant: T is the small-nutation period 2*pi/sqrt(2(e3-e)/D(e)); delta_* "
                                  "are genuine phase advances over that T")
    doc["crosscheck"] = crosscheck(motion, [mpf(t) for t in near])
    (VECTORS / (name + ".json")).write_text(json.dumps(doc, indent=1) + "\n")
    print(name, {key: text for key, text in doc["crosscheck"].items() if key.startswith("max")}, flush=True)


def number(text):
    return {"pi": mp.pi, "pi/2": mp.pi / 2}.get(text) or mpf(text)


def motion_of(doc):
    """The motion that a vector in the folder describes, from its definition alone."""
    p = doc["params"]
    body = [number(p[k]) for k in "ACsp"]
    if p.get("defined_by") == BY_ROOTS:
        return Motion(body, [number(doc[k]) for k in ("e1", "e2", "e3")], (doc["s_plus"], doc["s_minus"]),
                      number(p["theta0"]), [number(p[k]) for k in ("arg_alpha0", "arg_beta0")])
    if p.get("defined_by") == BY_STATE:
        start = [p[k] for k in ("alpha0", "beta0", "omega0")]
    else:
        start = [doc["initial"][k] for k in ("alpha", "beta", "omega_fixed")]
    al, be, w = ([number(x) for x in v] for v in start)
    if "spin_SI" in p:  # spin about the axis r only, in units with g = 1
        r = (-2 * (mpc(*al) * mpc(*be)).real, -2 * (mpc(*al) * mpc(*be)).imag,
             sum(x * x for x in al) - sum(x * x for x in be))
        w = [number(p["spin_SI"]) / mp.sqrt(number(p["g"])) * x for x in r]
    return Motion(body, state=(mpc(*al), mpc(*be), w))


def compare(old, new, where=""):
    """(difference, place) of every stored number; complex numbers and vectors are compared by their length."""
    if isinstance(old, dict):
        for key in old:
            if key not in ("name", "note", "note2", "units", "params", "crosscheck", "t") and key in new:
                yield from compare(old[key], new[key], f"{where}.{key}")
    elif isinstance(old, list) and old and isinstance(old[0], dict):
        for i, pair in enumerate(zip(old, new)):
            yield from compare(*pair, f"{where}[{i}]")
    elif isinstance(old, list) and old:
        pairs = [(number(a), number(b)) for a, b in zip(old, new)]
        size = mp.sqrt(sum(a * a for a, _ in pairs))
        yield mp.sqrt(sum((a - b) ** 2 for a, b in pairs)) / max(size, mpf("1e-12")), where
    elif old != new:
        try:
            yield abs(number(old) - number(new)) / max(abs(number(old)), 1), where
        except (TypeError, ValueError):
            yield mp.inf, where


def check():
    worst_of_all = mpf(0)
    for path in sorted(VECTORS.glob("*.json")):
        doc = json.loads(path.read_text())
        motion = motion_of(doc)
        new = document(motion, {}, [(number(s["t"]), s["t"]) for s in doc["samples"]],
                       [(number(s["t"]), s["t"], s["period_count"]) for s in doc.get("huge_samples", [])])
        if motion.constant and abs(motion.state(mpf(0))[0]) == 1:  # axis vertical for ever: no phi
            new.get("period", {}).pop("delta_phi", 0)
            for entry in new["samples"] + new["huge_samples"]:
                del entry["phi"]
        worst, where = max([(mpf(0), "")] + list(compare(doc, new)), key=lambda pair: pair[0])
        print(f"{path.stem:34} {mp.nstr(worst, 3):>10}  {where}", flush=True)
        worst_of_all = max(worst, worst_of_all)
    print("worst difference", mp.nstr(worst_of_all, 3))
    return worst_of_all < mpf("1e-19")  # inputs rounded to 30 digits, amplified over 1e9 periods


def main(arguments):
    if arguments == ["--list"]:
        print("\n".join(f"{name:34} {d['note']}" for name, d in MOTIONS.items()))
    elif arguments == ["--check"]:
        return 0 if check() else 1
    elif arguments == ["--all"] or arguments and all(name in MOTIONS for name in arguments):
        for name in MOTIONS if arguments == ["--all"] else arguments:
            generate(name)
    else:
        print("usage: generate.py --list | --check | --all | NAME ...", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
"""The motion of benches/methods.rs by heyoka, a general Taylor integrator that compiles the equations it is given.

    python3 -m pip install heyoka numpy
    cargo build --release --bin toytop && python3 host/benches/by_heyoka.py target/release/toytop

Prints, for several tolerances, time a period (compiling apart) and greatest error in the last of 10 and of 1000 nutation
periods, each with 16 orientations; --json instead prints what `toytop-lab report --others FILE` shows. The truth is `toytop state` by the ephemeris in f64, some 1e-15 rad.
"""
import json, subprocess, sys, tempfile, time
import numpy as np
import heyoka as hy

A, C, S, P = 1.0, 0.6, 1.0, 1.0  # g = 1
SCENARIO = f"""[top]
mass_moment = {P}
com_height = {S}
transverse_inertia = {A}
axial_inertia = {C}
gravity = 1
[motion]
kind = "branch_points"
e1 = 0.7
e2 = 0.9
e3 = 1.85
sign_l_plus_n = 1
sign_l_minus_n = -1
"""
MOMENTS = 16


def toytop(program, *words):
    return json.loads(subprocess.check_output([program, *words, "--format", "json"]))


def equations():
    """Φ' = ω Φ and m' = p s u' (r' × k) - p g r × k for (α, β, m1, m2, m3); ω and u' from m without a matrix."""
    names = ["a1", "a2", "b1", "b2", "m1", "m2", "m3"]
    a1, a2, b1, b2, m1, m2, m3 = y = hy.make_vars(*names)
    r = [-2.0 * (a1 * b1 - a2 * b2), -2.0 * (a1 * b2 + a2 * b1), a1 * a1 + a2 * a2 - b1 * b1 - b2 * b2]
    q = [r[1], -r[0]]
    axial = (C - A) / C * (m1 * r[0] + m2 * r[1] + m3 * r[2])
    rise = P * S * (m1 * q[0] + m2 * q[1]) / (A + P * S * (q[0] * q[0] + q[1] * q[1]))
    w1, w2, w3 = ((m1 - axial * r[0] - rise * q[0]) / A, (m2 - axial * r[1] - rise * q[1]) / A, (m3 - axial * r[2]) / A)
    d1, d2 = w2 * r[2] - w3 * r[1], w3 * r[0] - w1 * r[2]
    return list(zip(y, [
        0.5 * (-w3 * a2 + w2 * b1 - w1 * b2), 0.5 * (w3 * a1 - w1 * b1 - w2 * b2),
        0.5 * (-w3 * b2 - w2 * a1 + w1 * a2), 0.5 * (w3 * b1 + w1 * a1 + w2 * a2),
        rise * d2 - P * r[1], -rise * d1 + P * r[0], 0.0 * m3,
    ]))


def start(sample):
    (a1, a2), (b1, b2), w = sample["alpha"], sample["beta"], np.array(sample["omega"])
    r = np.array([-2 * (a1 * b1 - a2 * b2), -2 * (a1 * b2 + a2 * b1), a1 * a1 + a2 * a2 - b1 * b1 - b2 * b2])
    q = np.array([r[1], -r[0], 0.0])
    m = A * w + (C - A) * (w @ r) * r + P * S * (w @ q) * q
    return [a1, a2, b1, b2, *m]


def main(program, as_json):
    rows = []
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(SCENARIO)
        file.flush()
        period = toytop(program, "constants", file.name)["period"]
        apart = round(period / MOMENTS * 1024) / 1024
        first = toytop(program, "state", file.name, "--times", "0")["samples"][0]
        truth = {}
        for periods in (10, 1000):
            times = [i * apart for i in range((periods - 1) * MOMENTS + 1, periods * MOMENTS + 1)]
            samples = toytop(program, "state", file.name, "--times", ",".join(map(repr, times)))["samples"]
            truth[periods] = np.array([[*sample["alpha"], *sample["beta"]] for sample in samples])
    for tolerance in (1e-6, 1e-9, 1e-12, 2.3e-16):
        began = time.perf_counter()
        integrator = hy.taylor_adaptive(equations(), start(first), tol=tolerance)
        compiled = time.perf_counter() - began
        for periods, expected in truth.items():
            grid = np.arange(periods * MOMENTS + 1) * apart
            best, states = np.inf, None
            for _ in range(5):
                integrator.time, integrator.state[:] = 0.0, start(first)
                began = time.perf_counter()
                states = integrator.propagate_grid(grid)[-1]
                best = min(best, time.perf_counter() - began)
            off = states[-MOMENTS:, :4] - expected
            error = 2 * np.sqrt((off * off).sum(axis=1)).max()
            if periods == 1000:
                rows.append({"name": "heyoka", "effort": f"tolerance {tolerance:.0e}", "error_rad": error,
                             "us_per_period": 1e6 * best / periods})
            if not as_json:
                print(f"heyoka, tolerance {tolerance:.0e}: {1e6 * best / periods:8.2f} µs a period, error {error:.1e} rad after "
                      f"{periods} periods ({compiled:.1f} s to compile)")
    if as_json:
        print(json.dumps({"rows": rows}))


if __name__ == "__main__":
    main(sys.argv[1], "--json" in sys.argv[2:])

#!/usr/bin/env python3
"""One second of a telephone's sensors on a top: who predicts the next ten seconds?

    python3 -m pip install numpy scipy vqf
    cargo build --release --bin toytop && python3 host/comparisons/fit_comparison.py target/release/toytop

Three methods get the same samples: toytop fit, without a guess; the filter VQF (Laidig and Seel 2023), whose last orientation is
continued at the last rate of the gyroscope, less the bias that it found; and a batch fit by SciPy's least_squares over DOP853, which begins near the truth.
Prints the angle between the predicted and the true orientation, and the time that each method took, as the table of host/comparisons/README.md.
"""
import csv, pathlib, subprocess, sys, tempfile, time
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation
from top import Equations, dot, exact
from vqf import VQF

A, C, S, M, G = 3.0e-5, 2.0e-5, 0.03, 0.05, 9.81
P = M * S
EQUATIONS = Equations(A, C, P, S, G)
RELATIVE = 1e-10
ABSOLUTE = [RELATIVE] * 4 + [RELATIVE * A] * 3  # of the quaternion and of the momentum
FIELD = np.array([20.0, 0.0, -43.0])
GYRO, ACCEL, MAG = 0.002, 0.022, 0.6  # noise
GYRO_BIAS, ACCEL_BIAS = 0.0175, 0.2
AHEAD = [0.0, 1.0, 2.0, 5.0, 10.0]
TILT, SPIN = 20.0, 150.0  # degrees, rad/s
# the telephone's gyroscope is blind along the axis; the other one is not
RANGES = {"34.9 rad/s": np.deg2rad(2000.0), "200 rad/s": 200.0}


SCENARIO = f"""[top]
mass = {M}
com_height = {S}
transverse_inertia = {A}
axial_inertia = {C}
gravity = {G}
[motion]
kind = "release"
tilt_deg = {TILT}
spin = {SPIN}
precession = 2.0
"""
SENSORS = f"""[gyroscope]
noise = {GYRO}
bias = {GYRO_BIAS}
range = {{limit}}
[accelerometer]
noise = {ACCEL}
bias = {ACCEL_BIAS}
[magnetometer]
noise = {MAG}
field = {FIELD.tolist()}
every = 10
"""


def specific_force(state):
    """Specific force g + s u'' of the centre of mass, which is vertical, m/s²."""
    (r, q), (omega, m_rate), ps = EQUATIONS.axis(*state[:4]), EQUATIONS.rates(state), P * S
    r_rate = np.cross(omega, r)
    q_rate = [r_rate[1], -r_rate[0], 0.0]
    inertia = A + ps * dot(q, q)
    rise = dot(state[4:], q) / inertia
    return G + S * (dot(m_rate, q) + dot(state[4:], q_rate) - 2 * ps * rise * dot(q, q_rate)) / inertia


def read(path):
    rows = list(csv.DictReader(open(path)))
    get = lambda names: np.array([[float(row[name] or "nan") for name in names] for row in rows])
    axes = lambda kind: get([f"{kind}_{axis}" for axis in "xyz"])
    return get(["t"])[:, 0], axes("gyro"), axes("accel"), axes("mag")


def orientations(program, path, times):
    return [rotation(quaternion) for quaternion, _ in exact(program, path, times)]


def rotation(quaternion):
    return Rotation.from_quat(np.roll(quaternion, -1))


def by_toytop(program, folder, samples, top, sensors):
    begin = time.perf_counter()
    subprocess.check_output([program, "fit", samples, "--top", top, "--sensors", sensors, "-o", folder / "fitted.toml"])
    took = time.perf_counter() - begin
    return orientations(program, folder / "fitted.toml", [1.0 + t for t in AHEAD]), took


def by_filter(t, gyro, accel, mag):
    begin = time.perf_counter()
    filtered = VQF(t[1] - t[0])
    for k in range(len(t)):
        filtered.update(gyro[k], accel[k], *([] if np.isnan(mag[k, 0]) else [mag[k]]))
    bias, _ = filtered.getBiasEstimate()
    w, x, y, z = filtered.getQuat9D()
    took = time.perf_counter() - begin
    # its fixed frame is east, north, up; here it is north, west, up
    last = Rotation.from_euler("z", -90, degrees=True) * Rotation.from_quat([x, y, z, w])
    return [last * Rotation.from_rotvec((gyro[-1] - bias) * (1.0 + ahead - t[-1])) for ahead in AHEAD], took


def by_batch(t, gyro, accel, mag, guess, limit):
    """Unknowns: rotation vector from the guess, ω in rad/s, biases of gyroscope and accelerometer."""
    start, omega = guess
    seen = ~np.isnan(mag[:, 0])
    inside = np.abs(gyro) < 0.999 * limit

    def states(x, times):
        quaternion = np.roll((Rotation.from_rotvec(x[:3]) * start).as_quat(), 1)
        first = EQUATIONS.state(quaternion, omega + x[3:6])
        return solve_ivp(EQUATIONS.slope, (0.0, times[-1]), first, "DOP853", times, rtol=RELATIVE, atol=ABSOLUTE).y.T

    def residuals(x):
        found = states(x, t)
        back = Rotation.from_quat(np.roll(found[:, :4], -1, axis=1)).inv()
        w = np.array([EQUATIONS.rates(state)[0] for state in found])
        up = np.zeros_like(w)
        up[:, 2] = [specific_force(state) for state in found]
        rates = ((gyro - back.apply(w) - x[6:9]) / GYRO)[inside]
        forces = (accel - back.apply(up) - x[9:12]) / ACCEL
        fields = ((mag - back.apply(np.tile(FIELD, (len(t), 1)))) / MAG)[seen]
        return np.concatenate([rates, forces.ravel(), fields.ravel(), x[6:9] / GYRO_BIAS, x[9:12] / ACCEL_BIAS])

    begin = time.perf_counter()
    found = least_squares(residuals, np.zeros(12), x_scale="jac", method="trf")
    took = time.perf_counter() - begin
    later = states(found.x, np.array([0.0] + [1.0 + ahead for ahead in AHEAD]))
    return [rotation(state[:4]) for state in later[1:]], took


def main(program):
    rows = []
    for name, limit in RANGES.items():
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            top, sensors, samples = folder / "top.toml", folder / "sensors.toml", folder / "samples.csv"
            top.write_text(SCENARIO)
            sensors.write_text(SENSORS.format(limit=limit))
            subprocess.check_call([program, "simulate", top, "--sensors", sensors, "--seed", "7", "-o", samples])
            data = read(samples)
            (quaternion, omega), = exact(program, top, [0.0])
            truth = orientations(program, top, [1.0 + ahead for ahead in AHEAD])
            near = Rotation.from_rotvec([0.01, -0.01, 0.02]) * rotation(quaternion)
            omega = np.array(omega) + [0.1, -0.1, 0.2]
            for method, (found, took) in {
                "`toytop fit`": by_toytop(program, folder, samples, top, sensors),
                "VQF, then the last rate": by_filter(*data),
                "SciPy least squares, DOP853": by_batch(*data, (near, omega), limit),
            }.items():
                errors = [f"{(one * true.inv()).magnitude():.2g}" for one, true in zip(found, truth)]
                rows.append([name, method, *errors, f"{took:.3g}"])
    header = ["range of the gyroscope", "method", *(f"error after {ahead:g} s, rad" for ahead in AHEAD), "time, s"]
    for row in [header, ["---"] * len(header), *rows]:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main(sys.argv[1])

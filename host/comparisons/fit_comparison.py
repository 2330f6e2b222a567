#!/usr/bin/env python3
"""One second of a telephone's sensors on a top: who predicts the next ten seconds?

    python3 -m pip install numpy scipy vqf
    cargo build --release --bin toytop && python3 host/comparisons/fit_comparison.py target/release/toytop

Three methods get the same samples: toytop fit, without a guess; the filter VQF (Laidig and Seel 2023), whose last orientation is
continued at the last rate of the gyroscope, less the bias that it found; and a batch fit by SciPy's least_squares over DOP853, which begins near the truth.
Prints the angle between the predicted and the true orientation, and the time that each method took, as the table of host/comparisons/README.md.
"""
import csv, json, pathlib, subprocess, sys, tempfile, time
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation
from vqf import VQF

A, C, S, M, G = 3.0e-5, 2.0e-5, 0.03, 0.05, 9.81
P = M * S
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


def rate(_, y):
    """Quaternion (x, y, z, w) and ω of the sliding top, by Newton's and Euler's equations in the fixed frame."""
    q, w = y[:4], y[4:]
    x, y_, z, s = q
    r = np.array([2 * (x * z + s * y_), 2 * (y_ * z - s * x), 1 - 2 * (x * x + y_ * y_)])
    r_rate = np.cross(w, r)
    lever = np.array([r[1], -r[0], 0.0])
    spin, across = w @ r, lever @ lever
    inward = np.array([r_rate[1], -r_rate[0], 0.0])
    u2 = (A * (w @ inward) - (C - A) * spin * (r_rate @ lever) - P * G * across) / (A + P * S * across)
    w_rate = (-P * (G + S * u2) * lever - (C - A) * spin * r_rate) / A
    q_rate = 0.5 * np.array([w[0] * s + w[1] * z - w[2] * y_, w[1] * s + w[2] * x - w[0] * z, w[2] * s + w[0] * y_ - w[1] * x, -w @ q[:3]])
    return np.concatenate([q_rate, w_rate])


def support(q, w):
    """Specific force of the centre of mass, along the vertical."""
    return np.array([G + S * heave(a, b) for a, b in zip(q, w)])


def heave(q, w):
    state = np.concatenate([q, w])
    x, y, z, s = q
    r = np.array([2 * (x * z + s * y), 2 * (y * z - s * x), 1 - 2 * (x * x + y * y)])
    w_rate = rate(0.0, state)[4:]
    r_rate = np.cross(w, r)
    return (np.cross(w_rate, r) + np.cross(w, r_rate))[2]


def read(path):
    rows = list(csv.DictReader(open(path)))
    get = lambda names: np.array([[float(row[name] or "nan") for name in names] for row in rows])
    axes = lambda kind: get([f"{kind}_{axis}" for axis in "xyz"])
    return get(["t"])[:, 0], axes("gyro"), axes("accel"), axes("mag")


def truth(program, path, times):
    words = [program, "state", path, "--times", ",".join(map(str, times)), "--format", "json"]
    return json.loads(subprocess.check_output(words))["samples"]


def orientation(sample):
    (w, z), (y, x) = sample["alpha"], sample["beta"]
    return Rotation.from_quat([x, -y, z, w])


def by_toytop(program, folder, samples, top, sensors):
    begin = time.perf_counter()
    subprocess.check_output([program, "fit", samples, "--top", top, "--sensors", sensors, "-o", folder / "fitted.toml"])
    took = time.perf_counter() - begin
    return [orientation(row) for row in truth(program, folder / "fitted.toml", [1.0 + t for t in AHEAD])], took


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

    def motion(x, times):
        q = (Rotation.from_rotvec(x[:3]) * start).as_quat()
        found = solve_ivp(rate, (0.0, times[-1]), np.concatenate([q, omega + x[3:6]]), "DOP853", times, rtol=1e-8, atol=1e-8)
        q = found.y[:4].T / np.linalg.norm(found.y[:4].T, axis=1)[:, None]
        return q, found.y[4:].T

    def residuals(x):
        q, w = motion(x, t)
        back = Rotation.from_quat(q).inv()
        up = np.zeros_like(w)
        up[:, 2] = support(q, w)
        rates = ((gyro - back.apply(w) - x[6:9]) / GYRO)[inside]
        forces = (accel - back.apply(up) - x[9:12]) / ACCEL
        fields = ((mag - back.apply(np.tile(FIELD, (len(t), 1)))) / MAG)[seen]
        return np.concatenate([rates, forces.ravel(), fields.ravel(), x[6:9] / GYRO_BIAS, x[9:12] / ACCEL_BIAS])

    begin = time.perf_counter()
    found = least_squares(residuals, np.zeros(12), x_scale="jac", method="trf")
    took = time.perf_counter() - begin
    q, _ = motion(found.x, np.array([0.0] + [1.0 + ahead for ahead in AHEAD]))
    return [Rotation.from_quat(x) for x in q[1:]], took


def angle(found, exact):
    return np.linalg.norm((found * exact.inv()).as_rotvec())


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
            exact = truth(program, top, [0.0] + [1.0 + ahead for ahead in AHEAD])
            true = [orientation(row) for row in exact[1:]]
            near = Rotation.from_rotvec([0.01, -0.01, 0.02]) * orientation(exact[0])
            omega = np.array(exact[0]["omega"]) + [0.1, -0.1, 0.2]
            for method, (found, took) in {
                "`toytop fit`": by_toytop(program, folder, samples, top, sensors),
                "VQF, then the last rate": by_filter(*data),
                "SciPy least squares, DOP853": by_batch(*data, (near, omega), limit),
            }.items():
                errors = [f"{angle(one, exact):.2g}" for one, exact in zip(found, true)]
                rows.append([name, method, *errors, f"{took:.3g}"])
    header = ["range of the gyroscope", "method", *(f"error after {ahead:g} s, rad" for ahead in AHEAD), "time, s"]
    for row in [header, ["---"] * len(header), *rows]:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main(sys.argv[1])

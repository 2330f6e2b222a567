"""The top of a scenario for an integrator: equations, start, and the file that `toytop score` reads.

The state is a unit quaternion w, x, y, z from body to fixed coordinates and the momentum m of the paper:

    m = A ω + (C - A) <ω, r> r + p s u' q,   m' = p s u' (r' x k) - p g q,   q = r x k,   u' = <ω, q>
"""
import json, subprocess, tomllib


class Top:
    def __init__(self, program, scenario):
        with open(scenario, "rb") as file:
            keys = tomllib.load(file)["top"]
        self.a, self.c, self.g = keys["transverse_inertia"], keys["axial_inertia"], keys.get("gravity", 9.80665)
        self.p = keys["mass_moment"] if "mass_moment" in keys else keys["mass"] * keys["com_height"]
        self.s = 0.0 if keys.get("support") == "fixed" else keys["com_height"]
        answer = subprocess.check_output([program, "state", scenario, "--times", "0", "--format", "json"])
        sample = json.loads(answer)["samples"][0]
        alpha, beta, omega = sample["alpha"], sample["beta"], sample["omega"]
        w, x, y, z = alpha[0], beta[1], -beta[0], alpha[1]
        r, q = self.axis(w, x, y, z)
        axial, rise = (self.c - self.a) * dot(omega, r), self.p * self.s * dot(omega, q)
        self.start = [w, x, y, z] + [self.a * o + axial * i + rise * j for o, i, j in zip(omega, r, q)]

    def axis(self, w, x, y, z):
        """r and q = r x k."""
        r = [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z]
        return r, [r[1], -r[0], 0.0]

    def rates(self, state):
        """ω in the fixed frame and m', by sums and products only, so that they also take symbols."""
        (r, q), m, ps = self.axis(*state[:4]), state[4:], self.p * self.s
        axial, rise = (self.c - self.a) / self.c * dot(m, r), dot(m, q) / (self.a + ps * dot(q, q))
        omega = [(i - axial * j - ps * rise * k) / self.a for i, j, k in zip(m, r, q)]
        across = [omega[1] * r[2] - omega[2] * r[1], omega[2] * r[0] - omega[0] * r[2]]
        return omega, [ps * rise * across[1] - self.p * self.g * q[0], -ps * rise * across[0] - self.p * self.g * q[1], 0.0 * m[2]]

    def equations(self, _, state):
        """Time derivative of the seven numbers."""
        (w, x, y, z), ((a, b, c), moment) = state[:4], self.rates(state)
        turn = [-a * x - b * y - c * z, a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x]
        return [0.5 * rate for rate in turn] + moment

    def write(self, path, times, states, **stated):
        """Rows of time, quaternion and angular velocity, below lines of what is known about the run."""
        with open(path, "w") as file:
            file.writelines(f"# {key} = {value}\n" for key, value in stated.items())
            file.write("t,w,x,y,z,omega_x,omega_y,omega_z\n")
            for t, state in zip(times, states):
                state = [float(number) for number in state]
                file.write(",".join(map(repr, [float(t), *state[:4], *self.rates(state)[0]])) + "\n")


def dot(x, y):
    return sum(i * j for i, j in zip(x, y))

"""Newton's and Euler's equations of a top for integrators, without a formula of toytop, and the files that `toytop score` reads.

The state is a unit quaternion w, x, y, z from body to fixed coordinates and the momentum m of the paper:

    m = A ω + (C - A) <ω, r> r + p s u' q,   m' = p s u' (r' x k) - p g q,   q = r x k,   u' = <ω, q>
"""
import json, subprocess, tomllib


class Equations:
    def __init__(self, a, c, p, s, g):
        """Moments of inertia A and C, mass moment p, distance s from a sliding tip to the centre of mass (0 without one), gravity g."""
        self.a, self.c, self.p, self.s, self.g = a, c, p, s, g

    def axis(self, w, x, y, z):
        """r and q = r x k."""
        r = [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z]
        return r, [r[1], -r[0], 0.0]

    def state(self, quaternion, omega):
        """State of an orientation and an angular velocity in the fixed frame."""
        r, q = self.axis(*quaternion)
        axial, rise = (self.c - self.a) * dot(omega, r), self.p * self.s * dot(omega, q)
        return [*quaternion, *(self.a * o + axial * i + rise * j for o, i, j in zip(omega, r, q))]

    def rates(self, state):
        """ω in the fixed frame and m', by sums and products only, so that they also take symbols."""
        (r, q), m, ps = self.axis(*state[:4]), state[4:], self.p * self.s
        axial, rise = (self.c - self.a) / self.c * dot(m, r), dot(m, q) / (self.a + ps * dot(q, q))
        omega = [(i - axial * j - ps * rise * k) / self.a for i, j, k in zip(m, r, q)]
        across = [omega[1] * r[2] - omega[2] * r[1], omega[2] * r[0] - omega[0] * r[2]]
        return omega, [ps * rise * across[1] - self.p * self.g * q[0], -ps * rise * across[0] - self.p * self.g * q[1], 0.0 * m[2]]

    def slope(self, _, state):
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


def exact(program, scenario, times):
    """Quaternion and angular velocity at each time, as toytop computes them."""
    words = [program, "state", scenario, "--times", ",".join(map(str, times)), "--format", "json"]
    for sample in json.loads(subprocess.check_output(words))["samples"]:
        (w, z), (minus_y, x) = sample["alpha"], sample["beta"]
        yield [w, x, -minus_y, z], sample["omega"]


def read(program, scenario):
    """Equations of a scenario's top, and its state at t = 0."""
    with open(scenario, "rb") as file:
        keys = tomllib.load(file)["top"]
    support, height = keys.get("support"), keys.get("com_height", 0.0)
    p = 0.0 if support == "free" else keys["mass_moment"] if "mass_moment" in keys else keys["mass"] * height
    s = height if support in (None, "sliding") else 0.0
    equations = Equations(keys["transverse_inertia"], keys["axial_inertia"], p, s, keys.get("gravity", 9.80665))
    return equations, equations.state(*next(exact(program, scenario, [0])))


def dot(x, y):
    return sum(i * j for i, j in zip(x, y))

"""A Lie-group integrator without a library: the commutator-free method of fourth order by Celledoni, Marthinsen and Owren, which
turns the quaternion by exponentials only. Four step sizes: python3 lie_group.py toytop SCENARIO SECONDS FOLDER"""
import math, sys
from top import dot, read


def turned(omega, quaternion):
    """exp(ω) applied to a quaternion, ω in the fixed frame."""
    half = 0.5 * math.sqrt(dot(omega, omega))
    scale = 0.5 * (math.sin(half) / half if half > 0.0 else 1.0)
    (a, b, c), d, (w, x, y, z) = [scale * o for o in omega], math.cos(half), quaternion
    return [d * w - a * x - b * y - c * z, d * x + a * w + b * z - c * y, d * y + b * w + c * x - a * z, d * z + c * w + a * y - b * x]


def mixed(h, *terms):
    """Sum of factors times vectors, times h."""
    return [h * sum(factor * vector[i] for factor, vector in terms) for i in range(3)]


def step(equations, h, state):
    """State a step of h seconds later."""
    q, m = state[:4], state[4:]
    moved = lambda change: [i + j for i, j in zip(m, change)]
    w1, f1 = equations.rates(state)
    second = turned(mixed(h, (0.5, w1)), q)
    w2, f2 = equations.rates(second + moved(mixed(h, (0.5, f1))))
    w3, f3 = equations.rates(turned(mixed(h, (0.5, w2)), q) + moved(mixed(h, (0.5, f2))))
    w4, f4 = equations.rates(turned(mixed(h, (1.0, w3), (-0.5, w1)), second) + moved(mixed(h, (1.0, f3))))
    first = turned(mixed(h / 12, (3, w1), (2, w2), (2, w3), (-1, w4)), q)
    last = turned(mixed(h / 12, (-1, w1), (2, w2), (2, w3), (3, w4)), first)
    return last + moved(mixed(h / 6, (1, f1), (2, f2), (2, f3), (1, f4)))


def main(program, scenario, seconds, folder):
    (equations, start), seconds = read(program, scenario), float(seconds)
    for steps in (1000, 2000, 4000, 8000):
        h, states = seconds / steps, [start]
        for _ in range(steps):
            states.append(step(equations, h, states[-1]))
        stride = steps // 1000
        equations.write(f"{folder}/lie_group_{steps}.csv", [h * i for i in range(0, steps + 1, stride)], states[::stride],
                        method="Lie group", step=h, evaluations=4 * steps)


if __name__ == "__main__":
    main(*sys.argv[1:])

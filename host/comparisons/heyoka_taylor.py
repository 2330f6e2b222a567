"""heyoka's Taylor integrator, three tolerances: python3 heyoka_taylor.py toytop SCENARIO SECONDS FOLDER"""
import sys
import heyoka
import numpy as np
from top import read

program, scenario, seconds, folder = sys.argv[1:]
(equations, start), seconds = read(program, scenario), float(seconds)
grid = np.linspace(0.0, seconds, 1001)
symbols = heyoka.make_vars("w", "x", "y", "z", "m1", "m2", "m3")
system = list(zip(symbols, equations.slope(None, list(symbols))))
for tolerance in (1e-6, 1e-9, 1e-15):
    integrator = heyoka.taylor_adaptive(system, start, tol=tolerance)
    _, _, _, steps, _, states = integrator.propagate_grid(grid)
    equations.write(f"{folder}/heyoka_{tolerance:.0e}.csv", grid, states, method="heyoka", step=seconds / steps, evaluations=steps * integrator.order)

"""SciPy's DOP853, three tolerances: python3 scipy_dop853.py toytop SCENARIO SECONDS FOLDER"""
import sys
import numpy as np
from scipy.integrate import solve_ivp
from top import read

program, scenario, seconds, folder = sys.argv[1:]
(equations, start), seconds = read(program, scenario), float(seconds)
grid = np.linspace(0.0, seconds, 1001)
for tolerance in (1e-6, 1e-9, 1e-12):
    run = solve_ivp(equations.slope, (0.0, seconds), start, "DOP853", rtol=tolerance, atol=tolerance * 1e-6, dense_output=True)
    steps = len(run.t) - 1
    equations.write(f"{folder}/dop853_{tolerance:.0e}.csv", grid, run.sol(grid).T,
                    method="SciPy DOP853", step=seconds / steps, evaluations=run.nfev)

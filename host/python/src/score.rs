//! The output of an integrator is compared with the exact motion.

use crate::arguments::{NumericArg, failed};
use crate::interrupt;
use crate::motion::MotionCore;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use pythonize::pythonize;
use toytop::Orientation;
use toytop_host::Failure;
use toytop_host::integrators::order as convergence;
use toytop_host::integrators::scorer::Scorer;
use toytop_host::integrators::trajectory::{Trajectory, TrajectoryRow, normalised};

/// Errors of an integrator's output, from the state of motion.at(t[0]), against the exact motion, by the keys of JSON.
#[pyfunction]
pub(crate) fn score<'py>(
    py: Python<'py>,
    motion: &MotionCore,
    t: NumericArg,
    quaternion: PyReadonlyArray2<'_, f64>,
    omega: Option<PyReadonlyArray2<'_, f64>>,
    in_body: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let numbers = |rows: PyReadonlyArray2<'_, f64>| rows.as_array().iter().copied().collect::<Vec<_>>();
    let (quaternions, rates) = (numbers(quaternion), omega.map(numbers));
    let count = t.numbers.len();
    let row = move |i: usize| {
        let given = Orientation::from_quaternion(quaternions.as_chunks().0[i]);
        let (orientation, norm_error) =
            normalised(given).map_err(|reason| Failure::input(format!("quaternion: row {i}: {reason}")))?;
        let in_fixed = |rate: [f64; 3]| if in_body { orientation.adjoint(rate) } else { rate };
        let omega = rates.as_ref().map(|rates| in_fixed(rates.as_chunks().0[i]));
        Ok(TrajectoryRow { t: t.numbers[i], orientation, norm_error, omega, tip: None })
    };
    let motion = motion.motion;
    let score = interrupt::interruptible(py, move || {
        let rows = (0..count).map(row).collect::<Result<_, Failure>>()?;
        let trajectory =
            Trajectory { name: "result".into(), method: None, step: None, evaluations: None, rows };
        let scorer = Scorer::new(&motion, "motion.at(t[0])");
        scorer.map_err(|failure| failure.at("motion"))?.score(&trajectory)
    })?;
    let score = score.map_err(failed)?;
    let fields = pythonize(py, &score)?.cast_into::<PyDict>()?;
    fields.set_item("warning", score.warning)?;
    Ok(fields)
}

/// Order of convergence, fitted to rows of a step size and its error.
#[pyfunction]
pub(crate) fn order(runs: Vec<[f64; 2]>) -> Option<f64> {
    convergence::fitted(&runs)
}

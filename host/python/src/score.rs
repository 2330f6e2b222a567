//! Functions of the Python module `score`: errors of an integrator.

use crate::arguments::{NumericArg, failed};
use crate::interrupt;
use crate::motion::MotionCore;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use toytop::Orientation;
use toytop_host::Failure;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::score::errors::ExactReference;
use toytop_host::score::order as convergence;
use toytop_host::score::trajectory::{Pose, Trajectory, normalised};

/// Fields of the Python class `Score`.
#[derive(IntoPyObject)]
pub(crate) struct ScoreFields {
    max_error: f64,
    rms_error: f64,
    final_error: f64,
    max_u_error: f64,
    nutation_error: Option<f64>,
    precession_error: Option<f64>,
    spin_error: Option<f64>,
    residual: Option<f64>,
    drift_h: Option<f64>,
    drift_l: Option<f64>,
    drift_n: Option<f64>,
    norm_error: f64,
    truth_bound: f64,
    warning: Option<String>,
}

/// Errors of an integrator's output, from the state of motion.at(t[0]), against the exact motion.
#[pyfunction]
pub(crate) fn score(
    py: Python<'_>,
    motion: &MotionCore,
    t: NumericArg,
    quaternion: PyReadonlyArray2<'_, f64>,
    omega: Option<PyReadonlyArray2<'_, f64>>,
    in_body: bool,
) -> PyResult<ScoreFields> {
    let numbers = |rows: PyReadonlyArray2<'_, f64>| rows.as_array().iter().copied().collect::<Vec<_>>();
    let (quaternions, rates) = (numbers(quaternion), omega.map(numbers));
    let count = t.numbers.len();
    let row = move |i: usize| {
        let given = Orientation::from_quaternion(quaternions.as_chunks().0[i]);
        let (orientation, norm_error) =
            normalised(given).map_err(|reason| Failure::Input(format!("quaternion: row {i}: {reason}")))?;
        let in_fixed = |rate: [f64; 3]| if in_body { orientation.adjoint(rate) } else { rate };
        let omega = rates.as_ref().map(|rates| in_fixed(rates.as_chunks().0[i]));
        Ok(Pose { t: t.numbers[i], orientation, norm_error, omega, tip: None })
    };
    let MotionCore { motion, launch, top, .. } = motion;
    let scenario = Scenario {
        name: "motion".into(),
        motion: *motion,
        top: top.parameters,
        launch: *launch,
        units: Units::Si,
    };
    let score = interrupt::interruptible(py, move || {
        let rows = (0..count).map(row).collect::<Result<_, Failure>>()?;
        let trajectory =
            Trajectory { name: "result".into(), method: None, step: None, evaluations: None, rows };
        ExactReference::new(&scenario, "motion.at(t[0])")?.score(&trajectory)
    })?;
    let score = score.map_err(failed)?;
    Ok(ScoreFields {
        max_error: score.max_error,
        rms_error: score.rms_error,
        final_error: score.final_error,
        max_u_error: score.max_u_error,
        nutation_error: score.phases.nutation,
        precession_error: score.phases.precession,
        spin_error: score.phases.spin,
        residual: score.phases.residual,
        drift_h: score.drift.map(|drift| drift.h),
        drift_l: score.drift.map(|drift| drift.l),
        drift_n: score.drift.map(|drift| drift.n),
        norm_error: score.norm_error,
        truth_bound: score.truth_bound,
        warning: score.warning,
    })
}

/// Order of convergence, fitted to rows of a step size and its error.
#[pyfunction]
pub(crate) fn order(runs: Vec<[f64; 2]>) -> Option<f64> {
    convergence::fitted(&runs)
}

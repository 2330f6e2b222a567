//! Functions of the Python module `score`: errors of an integrator.

use crate::arguments::{Given, failed, value_error};
use crate::interrupt;
use crate::launch::rates;
use crate::motion::PyMotion;
use pyo3::prelude::*;
use toytop::Orientation;
use toytop_host::Failure;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::score::judge::Judge;
use toytop_host::score::order as convergence;
use toytop_host::score::trajectory::{Row, Trajectory, normalised};

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
    doubt: Option<String>,
}

/// Fields of the errors of an integrator's output, from the state of motion.at(0), against the exact motion.
#[pyfunction]
pub(crate) fn score(
    py: Python<'_>,
    motion: &PyMotion,
    t: &Bound<'_, PyAny>,
    quaternion: &Bound<'_, PyAny>,
    omega: Option<&Bound<'_, PyAny>>,
    omega_body: Option<&Bound<'_, PyAny>>,
) -> PyResult<ScoreFields> {
    let times = Given::read("t", t)?.numbers;
    let orientations = Given::read("quaternion", quaternion)?.rows("quaternion")?.to_vec();
    let (name, rates) = match rates(omega, omega_body)? {
        Some((name, omega)) => (name, Some(Given::read(name, omega)?.rows::<3>(name)?.to_vec())),
        None => ("omega", None),
    };
    let count = times.len();
    for (name, length) in [("quaternion", orientations.len()), (name, rates.as_ref().map_or(count, Vec::len))]
    {
        if length != count {
            return Err(value_error(name, format!("must have {count} rows, as t; has {length}")));
        }
    }
    let goes_on = times.is_sorted_by(|a, b| a < b) || times.is_sorted_by(|a, b| a > b);
    if count == 0 || !goes_on {
        return Err(value_error("t", "must be at least one time, and go on in one direction"));
    }
    let row = move |i: usize| {
        let (orientation, norm_error) = normalised(Orientation::from_quaternion(orientations[i]))
            .map_err(|reason| Failure::Input(format!("quaternion: row {i}: {reason}")))?;
        let in_fixed = |rate: [f64; 3]| if name == "omega" { rate } else { orientation.adjoint(rate) };
        let omega = rates.as_ref().map(|rates| in_fixed(rates[i]));
        Ok(Row { t: times[i], orientation, norm_error, omega, tip: None, com: None })
    };
    let scenario = Scenario { name: "motion".into(), motion: motion.motion, given: None, units: Units::Si };
    let score = interrupt::alone(py, move || {
        let rows = (0..count).map(row).collect::<Result<_, Failure>>()?;
        let trajectory =
            Trajectory { name: "result".into(), method: None, step: None, evaluations: None, rows };
        Judge::new(&scenario, "motion.at(times[0])")?.score(&trajectory)
    })?;
    let score = score.map_err(failed)?;
    let drift = score.drift.integrals.map(|[l, n, h]| [Some(l), Some(n), Some(h)]).unwrap_or_default();
    let [drift_l, drift_n, drift_h] = drift;
    Ok(ScoreFields {
        max_error: score.max_error,
        rms_error: score.rms_error,
        final_error: score.final_error,
        max_u_error: score.max_u_error,
        nutation_error: score.phases.nutation,
        precession_error: score.phases.precession,
        spin_error: score.phases.spin,
        residual: score.phases.residual,
        drift_h,
        drift_l,
        drift_n,
        norm_error: score.norm_error,
        truth_bound: score.truth_bound,
        doubt: score.doubt,
    })
}

/// Order of convergence, fitted to the errors of several step sizes; None where fewer than two of them tell it.
#[pyfunction]
pub(crate) fn order(steps: &Bound<'_, PyAny>, errors: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    let (steps, errors) = (Given::read("steps", steps)?.numbers, Given::read("errors", errors)?.numbers);
    if steps.len() != errors.len() {
        return Err(value_error("errors", format!("must be {} numbers, as steps", steps.len())));
    }
    let runs: Vec<_> = steps.into_iter().zip(errors).map(|(step, error)| [step, error]).collect();
    Ok(convergence::fitted(&runs))
}

//! `score`: errors of an integrator.

use crate::arrays::{Given, quaternions};
use crate::error::{failed, value_error};
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

/// Errors of an integrator's output against the exact motion.
#[pyclass(module = "toytop", frozen, get_all)]
pub(crate) struct Score {
    /// Greatest error of the orientation, 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer sign, rad.
    max_error: f64,
    /// Root of the mean square error of the orientation, rad.
    rms_error: f64,
    /// Error of the orientation in the last row, rad.
    final_error: f64,
    /// Greatest error of u, the cosine of the tilt.
    max_u_error: f64,
    /// Phase error of the nutation over the last nutation period, rad, above 0 where the result is ahead; None where the axis does not
    /// nutate, or for an aperiodic motion.
    nutation_error: Option<f64>,
    /// Phase error of the precession over the last nutation period, rad; None where the axis is vertical.
    precession_error: Option<f64>,
    /// Phase error of the spin over the last nutation period, rad.
    spin_error: Option<f64>,
    /// Root of the mean square of the error that no phase error explains, rad.
    residual: Option<f64>,
    /// Greatest change of h in units of the greater of |h| and p g; None where no angular velocity is known.
    drift_h: Option<f64>,
    /// Greatest change of l in units of the greatest of |l|, |n| and sqrt(2 A p g); None where no angular velocity is known.
    drift_l: Option<f64>,
    /// Greatest change of n in the unit of drift_l; None where no angular velocity is known.
    drift_n: Option<f64>,
    /// Greatest distance of the quaternions from unit norm.
    norm_error: f64,
    /// Upper bound on the error of the exact motion itself, rad.
    truth_bound: f64,
    /// Likely reason why the first row is far from the motion, if it is; otherwise None.
    doubt: Option<String>,
}

/// Errors of the output of an integrator, from the state of motion.at(0), against the exact motion.
///
/// Args:
///     t: times, s, which go on in one direction.
///     quaternion: an array of shape (len(t), 4) with w, x, y, z from body to fixed coordinates, or a scipy Rotation.
///     omega: angular velocities in the fixed frame, rad/s, of shape (len(t), 3).
///     omega_body: angular velocities in the body frame instead. Without either, drifts are found from differences.
///
/// Raises:
///     ValueError: an array is of the wrong shape, holds no rotation, or t does not go on; the message names it.
#[pyfunction]
#[pyo3(signature = (motion, t, quaternion, *, omega=None, omega_body=None))]
pub(crate) fn score(
    py: Python<'_>,
    motion: &PyMotion,
    t: &Bound<'_, PyAny>,
    quaternion: &Bound<'_, PyAny>,
    omega: Option<&Bound<'_, PyAny>>,
    omega_body: Option<&Bound<'_, PyAny>>,
) -> PyResult<Score> {
    let times = Given::read("t", t)?.numbers;
    let orientations = quaternions("quaternion", quaternion)?;
    let (name, rates) = match rates(omega, omega_body)? {
        Some((name, omega)) => (name, Some(Given::read(name, omega)?.rows::<3>(name)?)),
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
    let scenario = Scenario { name: "motion".into(), motion: motion.0.motion, given: None, units: Units::Si };
    let score = interrupt::alone(py, move || {
        let rows = (0..count).map(row).collect::<Result<_, Failure>>()?;
        let trajectory =
            Trajectory { name: "result".into(), method: None, step: None, evaluations: None, rows };
        Judge::new(&scenario, "motion.at(times[0])")?.score(&trajectory)
    })?;
    let score = score.map_err(failed)?;
    let drift = score.drift.integrals.map(|[l, n, h]| [Some(l), Some(n), Some(h)]).unwrap_or_default();
    let [drift_l, drift_n, drift_h] = drift;
    Ok(Score {
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

#[pymethods]
impl Score {
    fn __repr__(&self) -> String {
        let Self { max_error, rms_error, final_error, .. } = self;
        format!(
            "<Score: greatest error {max_error:.1e} rad, rms {rms_error:.1e} rad, last {final_error:.1e} rad>"
        )
    }
}

//! `score`: errors of an integrator.

use crate::arrays::{Given, quaternions};
use crate::error::{failed, value_error};
use crate::motion::PyMotion;
use pyo3::prelude::*;
use toytop::Orientation;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::score::judge::{self, Judge};
use toytop_host::score::order as convergence;
use toytop_host::score::trajectory::{Row, Trajectory};

/// Errors of an integrator's output against the exact motion.
#[pyclass(module = "toytop", frozen)]
pub(crate) struct Score(judge::Score);

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
    let (name, rates) = match (omega, omega_body) {
        (Some(_), Some(_)) => return Err(value_error("omega", "must be left out if omega_body is given")),
        (Some(omega), None) => ("omega", Some(Given::read("omega", omega)?.rows::<3>("omega")?)),
        (None, Some(omega)) => {
            ("omega_body", Some(Given::read("omega_body", omega)?.rows::<3>("omega_body")?))
        }
        (None, None) => ("omega", None),
    };
    for (name, length) in
        [("quaternion", orientations.len()), (name, rates.as_ref().map_or(times.len(), Vec::len))]
    {
        if length != times.len() {
            return Err(value_error(name, &format!("must have {} rows, as t; has {length}", times.len())));
        }
    }
    let rows: Vec<Row> = (0..times.len())
        .map(|i| {
            let raw = Orientation::from_quaternion(orientations[i]);
            let norm = raw.norm_squared().sqrt();
            if !(0.1..10.0).contains(&norm) {
                return Err(value_error(
                    "quaternion",
                    &format!("must be of unit norm; row {i} has {norm:.1e}"),
                ));
            }
            let orientation = raw.normalised();
            let in_fixed = |rate: [f64; 3]| if name == "omega" { rate } else { orientation.adjoint(rate) };
            let omega = rates.as_ref().map(|rates| in_fixed(rates[i]));
            Ok(Row { t: times[i], orientation, norm_error: (norm - 1.0).abs(), omega })
        })
        .collect::<PyResult<_>>()?;
    let goes_on =
        times.windows(2).all(|pair| pair[0] < pair[1]) || times.windows(2).all(|pair| pair[0] > pair[1]);
    if rows.is_empty() || !goes_on {
        return Err(value_error("t", "must be at least one time, and go on in one direction"));
    }
    let scenario = Scenario { name: "motion".into(), motion: motion.motion, state: None, units: Units::Si };
    let trajectory = Trajectory { name: "result".into(), method: None, step: None, evaluations: None, rows };
    let score = py.detach(|| Judge::new(&scenario)?.score(&trajectory));
    Ok(Score(score.map_err(|failure| failed(&failure))?))
}

/// Order of convergence, fitted to the errors of several step sizes; None where fewer than two of them tell it.
#[pyfunction]
pub(crate) fn order(steps: &Bound<'_, PyAny>, errors: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
    let (steps, errors) = (Given::read("steps", steps)?.numbers, Given::read("errors", errors)?.numbers);
    if steps.len() != errors.len() {
        return Err(value_error("errors", &format!("must be {} numbers, as steps", steps.len())));
    }
    let runs: Vec<_> = steps.into_iter().zip(errors).map(|(step, error)| [step, error]).collect();
    Ok(convergence::fitted(&runs))
}

#[pymethods]
impl Score {
    /// Greatest error of the orientation, 2 sqrt(|d alpha|^2 + |d beta|^2) with the nearer sign, rad.
    #[getter]
    fn max_error(&self) -> f64 {
        self.0.max_error
    }

    /// Root of the mean square error of the orientation, rad.
    #[getter]
    fn rms_error(&self) -> f64 {
        self.0.rms_error
    }

    /// Error of the orientation in the last row, rad.
    #[getter]
    fn final_error(&self) -> f64 {
        self.0.final_error
    }

    /// Greatest error of u, the cosine of the tilt.
    #[getter]
    fn max_u_error(&self) -> f64 {
        self.0.max_u_error
    }

    /// Phase error of the nutation over the last nutation period, rad, above 0 where the result is ahead; None where the axis does not
    /// nutate, or for an aperiodic motion.
    #[getter]
    fn nutation_error(&self) -> Option<f64> {
        self.0.phases.nutation
    }

    /// Phase error of the precession over the last nutation period, rad; None where the axis is vertical.
    #[getter]
    fn precession_error(&self) -> Option<f64> {
        self.0.phases.precession
    }

    /// Phase error of the spin over the last nutation period, rad.
    #[getter]
    fn spin_error(&self) -> Option<f64> {
        self.0.phases.spin
    }

    /// Root of the mean square of the error that no phase error explains, rad.
    #[getter]
    fn residual(&self) -> Option<f64> {
        self.0.phases.residual
    }

    /// Greatest change of h in units of the greater of |h| and p g; None where no angular velocity is known.
    #[getter]
    fn drift_h(&self) -> Option<f64> {
        self.0.drift.integrals.map(|[_, _, h]| h)
    }

    /// Greatest change of l in units of the greatest of |l|, |n| and sqrt(2 A p g); None where no angular velocity is known.
    #[getter]
    fn drift_l(&self) -> Option<f64> {
        self.0.drift.integrals.map(|[l, _, _]| l)
    }

    /// Greatest change of n in the unit of drift_l; None where no angular velocity is known.
    #[getter]
    fn drift_n(&self) -> Option<f64> {
        self.0.drift.integrals.map(|[_, n, _]| n)
    }

    /// Greatest distance of the quaternions from unit norm.
    #[getter]
    fn norm_error(&self) -> f64 {
        self.0.norm_error
    }

    /// Upper bound on the error of the exact motion itself, rad.
    #[getter]
    fn truth_bound(&self) -> f64 {
        self.0.truth_bound
    }

    /// Likely reason why the first row is far from the motion, if it is; otherwise None.
    #[getter]
    fn doubt(&self) -> Option<String> {
        self.0.doubt.map(|doubt| doubt.question("motion.at(times[0])"))
    }

    fn __repr__(&self) -> String {
        let judge::Score { max_error, rms_error, final_error, .. } = self.0;
        format!(
            "<Score: greatest error {max_error:.1e} rad, rms {rms_error:.1e} rad, last {final_error:.1e} rad>"
        )
    }
}

//! Errors of a trajectory.

use super::phases::{self, PhaseErrors};
use super::trajectory::{Trajectory, TrajectoryRow};
use crate::Failure;
use crate::motion::Scalar;
use crate::motion::errors::{Drifts, distance, greater_or_infinite};
use crate::motion::evaluator::MotionEvaluator;
use crate::motion::times::require_within;
use serde::Serialize;
use std::f64::consts::PI;
use toytop::Orientation;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Exact motion that trajectories are compared with.
pub struct Scorer {
    evaluator: MotionEvaluator,
    /// Command that prints the state from which a run has to start.
    start_command: String,
}

/// Errors of one trajectory. Their names are the keys of JSON.
#[derive(Serialize)]
pub struct Score {
    /// Greatest error of the orientation, 2 √(|Δα|² + |Δβ|²) with the nearer sign, rad.
    pub max_error_rad: f64,
    /// Root of the mean square of the orientation errors, rad.
    pub rms_error_rad: f64,
    /// Error of the orientation in the last row, rad.
    pub final_error_rad: f64,
    /// Greatest error of u.
    pub max_u_error: f64,
    /// Greatest error of the tip, m, if the file has it.
    #[serde(rename = "max_position_error")]
    pub max_tip_error: Option<f64>,
    /// Phase errors over the last nutation period.
    #[serde(flatten)]
    pub phases: PhaseErrors,
    /// Greatest difference of h between the file and the motion, in units of its natural scale, if the file has the angular velocity.
    pub drift_h: Option<f64>,
    /// Greatest difference of l in the same way.
    pub drift_l: Option<f64>,
    /// Greatest difference of n in the same way.
    pub drift_n: Option<f64>,
    /// Greatest distance of the file's orientations from unit norm.
    pub max_norm_error: f64,
    /// Upper bound on the error of the exact motion itself, rad.
    pub truth_bound_rad: f64,
    /// Likely reason why the first row is far from the motion, most often a convention.
    #[serde(skip)]
    pub warning: Option<String>,
}

/// Error of the first row above which a warning is given, rad or relative.
const SUSPECT_DISTANCE: f64 = 0.01;

impl Scorer {
    /// Exact motion, by its table in `f64`; `start_command` is the command that prints the state from which a run has to start.
    ///
    /// # Errors
    /// [`Failure::method`]: no table is large enough.
    pub fn new(motion: &MotionWithPeriod, start_command: &str) -> Result<Self, Failure> {
        let evaluator = MotionEvaluator::new(motion, Scalar::F64)?;
        Ok(Self { evaluator, start_command: start_command.to_owned() })
    }

    /// Errors of a trajectory.
    ///
    /// # Errors
    /// [`Failure::input`]: a time at which the motion cannot be evaluated.
    pub fn score(&self, Trajectory { name, rows, .. }: &Trajectory) -> Result<Score, Failure> {
        let furthest = greatest(rows.iter().map(|row| row.t.abs()));
        require_within([furthest], self.evaluator.furthest_time(), " s")
            .map_err(|failure| failure.at("t").at(name))?;
        let errors: Vec<_> = rows.iter().map(|row| self.errors(row)).collect();
        let mean_square = errors.iter().map(|[error, _]| error * error).sum::<f64>() / rows.len() as f64;
        let drifts = self.drifts(rows);
        Ok(Score {
            max_error_rad: greatest(errors.iter().map(|[error, _]| *error)),
            rms_error_rad: mean_square.sqrt(),
            final_error_rad: errors.last().map_or(0.0, |[error, _]| *error),
            max_u_error: greatest(errors.iter().map(|[_, u_error]| *u_error)),
            max_tip_error: rows.iter().filter_map(|row| self.tip_error(row)).reduce(greater_or_infinite),
            phases: phases::phase_errors(&self.evaluator, rows),
            drift_h: drifts.map(|drifts| drifts.h),
            drift_l: drifts.map(|drifts| drifts.l),
            drift_n: drifts.map(|drifts| drifts.n),
            max_norm_error: greatest(rows.iter().map(|row| row.norm_error)),
            truth_bound_rad: self.evaluator.error_bound.after(furthest * self.evaluator.ticks_per_time),
            warning: rows.first().and_then(|row| self.warning(row)),
        })
    }

    /// Errors of the orientation of a row, rad, and of its u.
    fn errors(&self, row: &TrajectoryRow) -> [f64; 2] {
        let exact = self.evaluator.orientation(row.t);
        [orientation_error(&exact, &row.orientation), (row.orientation.u() - exact.u()).abs()]
    }

    fn tip_error(&self, row: &TrajectoryRow) -> Option<f64> {
        let [x, y] = row.tip?;
        let exact = self.evaluator.tip(row.t);
        Some((x - exact.re).hypot(y - exact.im))
    }

    /// Greatest drifts.
    fn drifts(&self, rows: &[TrajectoryRow]) -> Option<Drifts> {
        rows.iter().try_fold(Drifts::default(), |most, row| {
            Some(most.greater(Drifts::new(&self.evaluator.motion, &row.orientation, row.omega?)))
        })
    }

    /// Reason why the first row is far from the motion; `None` if it is near.
    fn warning(&self, first: &TrajectoryRow) -> Option<String> {
        let exact = self.evaluator.at(first.t);
        let [error, _] = self.errors(first);
        let inverse = orientation_error(&exact.orientation, &first.orientation.inverse());
        let speed =
            distance(exact.rates.omega, [0.0; 3]).max(2.0 * PI / self.evaluator.motion.characteristic_time());
        let rate_error = first.omega.map_or(0.0, |omega| distance(omega, exact.rates.omega)) / speed;
        let tip_error = self.tip_error(first).unwrap_or(0.0) / self.evaluator.motion.top().tip_scale();
        let far = format!("the first row is {error:.1e} rad from the motion;");
        let reason = if error >= SUSPECT_DISTANCE && inverse < SUSPECT_DISTANCE {
            let transposed = "are the columns from fixed to body coordinates?";
            return Some(format!("{far} and its inverse {inverse:.1e} rad: {transposed}"));
        } else if error >= SUSPECT_DISTANCE {
            far
        } else if rate_error >= SUSPECT_DISTANCE {
            format!(
                "the angular velocity of the first row is off by {rate_error:.1e} of its size: is it in the frame of its columns, and"
            )
        } else if tip_error >= SUSPECT_DISTANCE {
            format!("the position of the first row is off by {tip_error:.1e} of the length of the top;")
        } else {
            return None;
        };
        Some(format!("{reason} does the run start from the state of this motion? ({})", self.start_command))
    }
}

fn greatest(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, greater_or_infinite)
}

/// Error of the orientation with the nearer of the two signs, rad.
fn orientation_error(exact: &Orientation<f64>, given: &Orientation<f64>) -> f64 {
    let negative = Orientation { alpha: -given.alpha, beta: -given.beta };
    exact.distance(given).min(exact.distance(&negative))
}

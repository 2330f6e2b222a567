//! Errors of a trajectory.

use super::drift::{self, Drift};
use super::phases::{Fit, PhaseErrors};
use super::trajectory::{Row, Trajectory};
use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, furthest_time, smallest, ticks_per_time};
use toytop::{Motion, Orientation};

/// Exact motion that trajectories are compared with.
pub struct Judge<'a> {
    motion: &'a Motion,
    table: Box<dyn AnyScalar>,
}

/// Errors of one trajectory.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// Greatest error of the orientation, 2 √(|Δα|² + |Δβ|²) with the nearer sign, rad.
    pub max_error: f64,
    /// Root of the mean square of the orientation errors, rad.
    pub rms_error: f64,
    /// Error of the orientation in the last row, rad.
    pub final_error: f64,
    /// Greatest error of u.
    pub max_u_error: f64,
    /// Phase errors over the last nutation period.
    pub phases: PhaseErrors,
    /// Drift of l, n and h.
    pub drift: Drift,
    /// Greatest distance of the file's orientations from unit norm.
    pub norm_error: f64,
    /// Upper bound on the error of the exact motion itself, rad.
    pub truth_bound: f64,
    /// Distance of the first row from the motion, if it is far.
    pub doubt: Option<Doubt>,
}

/// First row that is far from the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubt {
    /// Error of the orientation in the first row, rad.
    error: f64,
    /// Error of the inverse of this orientation, rad.
    inverse: f64,
}

impl Doubt {
    /// Distance from which a first row is far, rad.
    const FAR: f64 = 0.01;

    /// Likely reason, as a question; `start` is the command that prints the state from which a run has to start.
    #[must_use]
    pub fn question(&self, start: &str) -> String {
        let Self { error, inverse } = self;
        let question = if *inverse < Self::FAR {
            format!("and its inverse {inverse:.1e} rad: are the columns from fixed to body coordinates?")
        } else {
            format!("does the run start from the state of this motion? ({start})")
        };
        format!("the first row is {error:.1e} rad from the motion; {question}")
    }
}

impl<'a> Judge<'a> {
    /// Exact motion of a scenario, by its ephemeris in `f64`.
    ///
    /// # Errors
    /// [`Failure::Method`]: no ephemeris is large enough.
    pub fn new(scenario: &'a Scenario) -> Result<Self, Failure> {
        let motion = &scenario.motion;
        let table = smallest(Scalar::F64, motion).map_err(|failure| failure.of(&scenario.name))?;
        Ok(Self { motion, table })
    }

    /// Errors of a trajectory.
    ///
    /// # Errors
    /// [`Failure::Input`]: a time at which the ephemeris cannot be evaluated.
    pub fn score(&self, trajectory: &Trajectory) -> Result<Score, Failure> {
        let rows = &trajectory.rows;
        let furthest = rows.iter().map(|row| row.t.abs()).fold(0.0, f64::max);
        let reach = furthest_time(self.motion);
        if furthest > reach {
            let reason = format!("t: {furthest:e} must be within ±{reach:.1e} s");
            return Err(Failure::Input(format!("{}: {reason}", trajectory.name)));
        }
        let (mut max_error, mut max_u_error, mut squares, mut final_error) = (0.0_f64, 0.0_f64, 0.0, 0.0);
        for row in rows {
            let exact = self.table.at(row.t).sample.orientation();
            final_error = distance(&exact, &row.orientation);
            max_error = max_error.max(final_error);
            squares += final_error * final_error;
            max_u_error = max_u_error.max((row.orientation.u() - exact.u()).abs());
        }
        let fit = Fit::new(self.motion, &*self.table);
        Ok(Score {
            max_error,
            rms_error: (squares / rows.len() as f64).sqrt(),
            final_error,
            max_u_error,
            phases: fit.map(|fit| fit.last(rows)).unwrap_or_default(),
            drift: drift::along(rows, self.motion, &*self.table),
            norm_error: rows.iter().map(|row| row.norm_error).fold(0.0, f64::max),
            truth_bound: self.table.error_bound().after(furthest * ticks_per_time(self.motion)),
            doubt: rows.first().and_then(|row| self.doubt(row)),
        })
    }

    /// First row if it is far from the motion, most often because of another convention; `None` if it is near.
    fn doubt(&self, first: &Row) -> Option<Doubt> {
        let exact = self.table.at(first.t).sample.orientation();
        let [error, inverse] =
            [first.orientation, first.orientation.inverse()].map(|found| distance(&exact, &found));
        (error >= Doubt::FAR).then_some(Doubt { error, inverse })
    }
}

/// Error of the orientation with the nearer of the two signs, rad.
fn distance(exact: &Orientation<f64>, found: &Orientation<f64>) -> f64 {
    let negative = Orientation { alpha: -found.alpha, beta: -found.beta };
    exact.distance(found).min(exact.distance(&negative))
}

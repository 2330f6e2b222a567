//! Aperiodic motion, which has no table, by its closed form.

use crate::timed_motion::TimedMotion;
use toytop::{AttitudeState, Complex, ErrorBound};
use toytop_closed_forms::Aperiodic;

/// Closed form of an aperiodic motion, with the clock of a table.
pub struct AperiodicMotion {
    /// Closed form.
    pub form: Aperiodic,
    /// Ticks in a unit of time.
    pub ticks_per_time: f64,
    tip_scale: f64,
}

impl AperiodicMotion {
    /// Closed form of a motion; `None` if the motion is not aperiodic.
    pub fn new(motion: &TimedMotion) -> Option<Self> {
        let form = Aperiodic::new(motion)?;
        Some(Self { form, ticks_per_time: motion.ticks_per_time(), tip_scale: motion.top().tip_scale() })
    }

    /// Attitude at t, and position of the tip, m.
    pub fn at(&self, t: f64) -> (AttitudeState<f64>, Complex<f64>) {
        let state = self.form.at(t);
        (state, state.orientation.tip_over_s().scaled(self.tip_scale))
    }

    /// Upper bound on the orientation error, rad: the bound of the closed form, which holds up to 1e15 of the shortest times of the motion, and
    /// its growth beyond.
    pub fn error_bound(&self) -> ErrorBound {
        ErrorBound { constant: self.form.error_bound(), per_tick: 2e-30 }
    }
}

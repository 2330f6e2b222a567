//! Closed form of an aperiodic motion, which has no table.

use crate::motion_with_period::MotionWithPeriod;
use toytop::{AttitudeState, Complex, ErrorBound};
use toytop_closed_forms::Aperiodic;

/// Closed form of an aperiodic motion, with the clock of a table.
pub struct AperiodicMotion {
    /// Closed form.
    pub form: Aperiodic,
    /// Ticks in a unit of time.
    pub ticks_per_time: f64,
    /// Time of the lowest point.
    pub lowest: f64,
    /// Time on either side of it until the axis is upright to a rounding.
    pub upright: f64,
    tip_scale: f64,
    /// Mean rates of the tip angle before and after t = 0, while the axis is upright, turns per unit time.
    tip_rates: [f64; 2],
}

/// Variable v of an axis that is upright to a rounding.
const UPRIGHT: f64 = 40.0;

impl AperiodicMotion {
    /// Closed form of a motion; `None` if the motion is not aperiodic.
    pub fn new(motion: &MotionWithPeriod) -> Option<Self> {
        let form = Aperiodic::new(motion)?;
        let mut upright = motion.characteristic_time();
        while form.v(upright) < UPRIGHT || form.v(-upright) > -UPRIGHT {
            upright *= 2.0;
        }
        let lowest = root(-upright, upright, |t| form.v(t));
        let upright = upright + lowest.abs();
        let angle = |t| form.tip_angle(t).to_turns();
        let tip_rates = [-upright, upright].map(|far| (angle(2.0 * far) - angle(far)) / far);
        let (ticks_per_time, tip_scale) = (motion.ticks_per_time(), motion.top().tip_scale());
        Some(Self { form, ticks_per_time, lowest, upright, tip_scale, tip_rates })
    }

    /// Attitude at t, and position of the tip, m.
    pub fn at(&self, t: f64) -> (AttitudeState<f64>, Complex<f64>) {
        let state = self.form.at(t);
        (state, state.orientation.tip_over_s().scaled(self.tip_scale))
    }

    /// Tip angle at t to a few turns, turns.
    pub fn rough_tip_angle(&self, t: f64) -> f64 {
        let [before, after] = self.tip_rates;
        t * if t < 0.0 { before } else { after }
    }

    /// Upper bound on the orientation error, rad: constant up to 1e15 times the shortest time scale of the motion, and 2e-30 rad a tick
    /// beyond.
    pub fn error_bound(&self) -> ErrorBound {
        ErrorBound { constant: self.form.error_bound(), per_tick: 2e-30 }
    }
}

/// Root of an increasing function between two places.
pub fn root(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return middle;
        }
        if value(middle) < 0.0 { low = middle } else { high = middle }
    }
}

//! Aperiodic motion as an ephemeris: its closed form takes the place of a table.

use super::events::{Condition, EventQuery, MotionEvent};
use super::source::MotionSource;
use crate::motion::column::SampleColumn;
use crate::motion::sample::{MotionSample, unwrapped};
use std::f64::consts::TAU;
use toytop::ErrorBound;
use toytop_model::aperiodic::AperiodicMotion;
use toytop_model::timed_motion::TimedMotion;

/// Closed form, with what a search for events needs.
pub struct ClosedFormSource {
    pub(super) motion: AperiodicMotion,
    /// Time of the lowest point.
    lowest: f64,
    /// Time on either side of it until the axis is upright to a rounding.
    upright: f64,
    /// Mean rates of the tip angle before and after t = 0, while the axis is upright, turns per unit time.
    tip_rates: [f64; 2],
}

/// Variable v of an axis that is upright to a rounding.
const UPRIGHT: f64 = 40.0;
/// Intervals of the search on either side of the lowest point. Each finds at most one event.
const INTERVALS: i32 = 8192;

impl ClosedFormSource {
    /// Closed form of a motion; `None` if it is not aperiodic.
    pub fn new(motion: &TimedMotion) -> Option<Self> {
        let mut upright = motion.characteristic_time();
        let motion = AperiodicMotion::new(motion)?;
        let form = &motion.form;
        while form.v(upright) < UPRIGHT || form.v(-upright) > -UPRIGHT {
            upright *= 2.0;
        }
        let lowest = root(-upright, upright, |t| form.v(t));
        let upright = upright + lowest.abs();
        let angle = |t| form.tip_angle(t).to_turns();
        let tip_rates = [-upright, upright].map(|far| (angle(2.0 * far) - angle(far)) / far);
        Some(Self { motion, lowest, upright, tip_rates })
    }

    /// Bound on the error of ω, of Ω and of u', rad per unit time. It is checked by tests and not proved. The angular speed is greatest at the lowest
    /// point.
    pub fn rate_error_bound(&self) -> ErrorBound {
        const ERROR: f64 = 5e-14;
        let [x, y, z] = self.motion.form.at(self.lowest).omega_body();
        let speed = x.hypot(y).hypot(z);
        let constant = (1.0 + speed) * ERROR;
        ErrorBound { constant, per_tick: constant * speed / self.motion.ticks_per_time }
    }

    /// Tip angle, continued in time, rad.
    fn tip_angle(&self, t: f64) -> f64 {
        let [before, after] = self.tip_rates;
        unwrapped(self.motion.form.tip_angle(t), t * if t < 0.0 { before } else { after })
    }
}

/// Root of an increasing function between two places.
fn root(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return middle;
        }
        if value(middle) < 0.0 { low = middle } else { high = middle }
    }
}

impl MotionSource for ClosedFormSource {
    fn sample(&self, t: f64, _: Option<i64>, _: Option<SampleColumn>) -> MotionSample {
        let (state, tip) = self.motion.at(t);
        let error = self.motion.error_bound().after(t * self.motion.ticks_per_time);
        let sample = MotionSample::from_state(t, &state, tip, Some(self.tip_angle(t)));
        MotionSample { error_bound: Some(error), ..sample }
    }

    /// Events while the axis is not upright to a rounding: roots of a function of time minus a whole number, in 2 [`INTERVALS`] parts.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
        let value = |t: f64| match condition {
            Condition::Turning => self.motion.form.v(t).clamp(-0.5, 0.5),
            Condition::Crossing(level) if level.u() < 1.0 => {
                0.25 * (self.motion.form.at(t).orientation.u() - level.u())
            }
            Condition::Crossing(_) => 0.5,
            Condition::TipAngle(angle) => (self.tip_angle(t) - angle.to_radians()) / TAU,
        };
        let mut events = Vec::new();
        let [mut time, mut before] = [f64::NAN; 2];
        for i in -INTERVALS..=INTERVALS {
            let next = self.lowest + self.upright * f64::from(i) / f64::from(INTERVALS);
            let after = value(next);
            let whole = before.max(after).floor();
            if before.min(after) < whole {
                let sense = (after - before).signum();
                let t = root(time, next, |t| sense * (value(t) - whole));
                // at the lowest point u is least
                let upward = sense > 0.0 && condition != Condition::Turning;
                if query.includes(t, upward) {
                    events.push(MotionEvent::new(condition, upward, self.sample(t, None, None)));
                }
            }
            (time, before) = (next, after);
        }
        events.truncate(query.count);
        events
    }
}

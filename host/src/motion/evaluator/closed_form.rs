//! Closed form of an aperiodic motion as an evaluator.

use super::evaluate::Evaluate;
use super::events::{Condition, EventQuery, MotionEvent};
use crate::motion::column::SampleColumn;
use crate::motion::sample::{MotionSample, unwrapped};
use std::f64::consts::TAU;
use toytop::ErrorBound;
use toytop_model::aperiodic::{AperiodicMotion, root};

/// Bound on the error of ω, of Ω and of u', rad per unit time. It is checked by tests and not proved. The angular speed is greatest at the
/// lowest point.
pub fn rate_error_bound(form: &AperiodicMotion) -> ErrorBound {
    const ERROR: f64 = 5e-14;
    let [x, y, z] = form.form.at(form.lowest).omega_body();
    let speed = x.hypot(y).hypot(z);
    let constant = (1.0 + speed) * ERROR;
    ErrorBound { constant, per_tick: constant * speed / form.ticks_per_time }
}

/// Tip angle, continued in time, rad.
fn tip_angle(form: &AperiodicMotion, t: f64) -> f64 {
    unwrapped(form.form.tip_angle(t), form.rough_tip_angle(t))
}

impl Evaluate for AperiodicMotion {
    fn sample(&self, t: f64, _: Option<i64>, _: Option<SampleColumn>) -> MotionSample {
        let (state, tip) = self.at(t);
        let error_bound = Some(self.error_bound().after(t * self.ticks_per_time));
        MotionSample { error_bound, ..MotionSample::from_state(t, &state, tip, Some(tip_angle(self, t))) }
    }

    /// An event is a time at which `value` passes a whole number. Times are searched only until the axis is upright to a rounding.
    fn events(&self, condition: Condition, query: &EventQuery) -> Vec<MotionEvent> {
        /// Intervals of the search on either side of the lowest point. Each finds at most one event.
        const INTERVALS: i32 = 8192;
        let value = |t: f64| match condition {
            Condition::Turning => self.form.v(t).clamp(-0.5, 0.5),
            Condition::Crossing(level) if level.u() < 1.0 => {
                0.25 * (self.form.at(t).orientation.u() - level.u())
            }
            Condition::Crossing(_) => 0.5,
            Condition::TipAngle(angle) => (tip_angle(self, t) - angle.to_radians()) / TAU,
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

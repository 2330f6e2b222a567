//! Aperiodic motion by its closed form, which has no table.

use super::events::Condition;
use super::{DynEphemeris, EventFilter, FoundEvent, TableData, unwrapped};
use crate::motion::sample::Sample;
use std::f64::consts::TAU;
use toytop::{ErrorBound, Motion};
use toytop_closed_forms::Aperiodic;
use toytop_model::constants::{MotionConstants, natural_time};

/// Closed form of an aperiodic motion.
pub struct AperiodicMotion {
    form: Aperiodic,
    ticks_per_time: f64,
    /// Time of the lowest point, and the time on either side of it until the axis is upright to a rounding.
    lowest: f64,
    upright: f64,
}

/// Variable v of an axis that is upright to a rounding.
const UPRIGHT: f64 = 40.0;
/// Number of intervals on either side of the lowest point, at most one event in each.
const INTERVALS: i32 = 8192;

impl AperiodicMotion {
    /// Closed form of a motion; `None` if it is not aperiodic.
    pub fn new(motion: &Motion) -> Option<Self> {
        let form = Aperiodic::new(motion)?;
        let mut upright = natural_time(motion);
        while form.v(upright) < UPRIGHT || form.v(-upright) > -UPRIGHT {
            upright *= 2.0;
        }
        let lowest = root(-upright, upright, |t| form.v(t));
        let ticks_per_time = MotionConstants::new(*motion).ticks_per_time();
        Some(Self { form, ticks_per_time, lowest, upright: upright + lowest.abs() })
    }

    /// Tip angle, continued in time, rad.
    fn angle(&self, t: f64) -> f64 {
        let angle = |t| self.form.tip_angle(t).to_turns();
        // the angle grows at a constant rate while the axis is upright
        let far = self.upright.copysign(t);
        let rate = (angle(2.0 * far) - angle(far)) / far;
        unwrapped(self.form.tip_angle(t), rate * t)
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

impl DynEphemeris for AperiodicMotion {
    fn size(&self) -> [usize; 2] {
        [0; 2]
    }

    fn ticks_per_time(&self) -> f64 {
        self.ticks_per_time
    }

    /// Bound of the closed form, which holds up to 1e15 of the shortest times of the motion, and its growth beyond.
    fn error_bound(&self) -> ErrorBound {
        ErrorBound { constant: self.form.error_bound(), per_tick: 2e-30 }
    }

    /// Error that the tests of the closed form allow. The angular speed is greatest at the lowest point.
    fn rate_error_bound(&self) -> ErrorBound {
        const ERROR: f64 = 5e-14;
        let [x, y, z] = self.form.at(self.lowest).omega_body();
        let speed = x.hypot(y).hypot(z);
        let constant = (1.0 + speed) * ERROR;
        ErrorBound { constant, per_tick: constant * speed / self.ticks_per_time }
    }

    fn at(&self, t: f64) -> Sample {
        Sample {
            error_bound: Some(self.error_bound().after(t * self.ticks_per_time)),
            ..Sample::from_state(t, &self.form.at(t), self.form.tip(t), Some(self.angle(t)))
        }
    }

    fn at_tick(&self, n: i64) -> Sample {
        self.at(n as f64 / self.ticks_per_time)
    }

    /// Events while the axis is not upright to a rounding: places at which the integer part of a function of time changes.
    fn events(&self, condition: Condition, filter: &EventFilter) -> Vec<FoundEvent> {
        let value = |t: f64| match condition {
            Condition::Turning => self.form.v(t).clamp(-0.5, 0.5),
            Condition::Crossing(level) if level.u() < 1.0 => {
                0.25 * (self.form.at(t).orientation.u() - level.u())
            }
            Condition::Crossing(_) => 0.5,
            Condition::TipAngle(angle) => (self.angle(t) - angle.to_radians()) / TAU,
        };
        let mut found = Vec::new();
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
                if filter.accepts(t, upward) {
                    found.push(FoundEvent::new(condition, t, upward, self.at(t)));
                }
            }
            (time, before) = (next, after);
        }
        found.truncate(filter.count);
        found
    }

    fn data(&self) -> Option<TableData> {
        None
    }
}

//! Events: instants at which a motion turns, reaches a tilt, a circle or a tip angle, or lifts off.
//!
//! u is a function of the nutation phase alone, and so is everything that depends on u: the tilt, the distance of the
//! tip from the centre, the normal force. Such an event has one phase while u rises and its mirror image while u falls.
//! A bisection of the table finds the phase once, and a division converts phases to times. The tip angle is the sum of
//! a periodic part and of a mean that is linear in time. Its bisection is in time, between instants at which it can
//! change direction.
//!
//! All work is bounded: at most 64 evaluations for a phase, and some hundred for a tip angle.

mod recurring;

mod level;

mod crossing;

mod tip_angle;

pub use crossing::Crossings;
pub use level::Level;
pub use tip_angle::TipAngles;

use crate::ephemeris::{EphemerisScalar, EphemerisView, Sample};
use crate::phase::whole_number;
use crate::scalar::{Extended, Float};

/// Event of a motion: its instant in ticks, and the sense of the change.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Event {
    /// Last tick at or before the event.
    pub tick: i64,
    /// Fraction of the following tick that passes before the event, in [0, 1).
    pub share: f64,
    /// Whether u or the tip angle increases at the event; at a turning point, whether u = e₂.
    pub upward: bool,
}

impl Event {
    /// Event after a number of ticks; `None` outside the range of `i64`.
    fn at(ticks: Extended, upward: bool) -> Option<Self> {
        const RANGE: f64 = (1_u64 << 63) as f64;
        let in_range = Float::abs(ticks.to_f64()) < RANGE;
        let ([leading, rest], share) = ticks.floor_and_rest();
        let tick = whole_number(leading).wrapping_add(whole_number(rest)) as i64;
        // a share that rounds to 1 becomes the largest number below
        let share = share.to_f64();
        let share = if share < 1.0 { share } else { 1.0 - 0.5 * f64::EPSILON };
        in_range.then_some(Self { tick, share, upward })
    }

    /// Number of ticks from tick 0.
    fn ticks(&self) -> Extended {
        Extended::from(self.tick) + self.share.into()
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Time of an event in the motion's unit of time, from t = 0: the nearest `f64`. Far from t = 0 the tick and share of the
    /// event resolve more.
    #[must_use]
    pub fn time_of(&self, event: &Event) -> f64 {
        let [hi, lo] = self.clock.ticks_per_time;
        (event.ticks() / Extended::sum(hi, lo)).to_f64()
    }

    /// Sample of the motion at the instant of an event.
    #[must_use]
    pub fn at_event(&self, event: &Event) -> Sample<'_, R> {
        let (whole, share) = event.ticks().floor_and_rest();
        Sample::new(self, self.clock.between(whole, share), self.clock.tip.between(whole, share))
    }
}

/// Least number above `low` for which a condition holds. The condition holds at `high`, and if it holds for a number,
/// it holds for every larger one. Cost: at most 64 evaluations of the condition.
fn first_that(mut low: u64, mut high: u64, holds: impl Fn(u64) -> bool) -> u64 {
    for _ in 0..u64::BITS {
        let middle = low + (high - low) / 2;
        if middle == low {
            break;
        }
        if holds(middle) { high = middle } else { low = middle }
    }
    high
}

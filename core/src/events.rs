//! Events: instants at which a motion turns, reaches a tilt, a circle or a tip angle, or lifts off.
//!
//! u has a value at one nutation phase while it rises, found by bisection, and at minus that phase while it falls. A tip angle is found by
//! bisection in time.

mod level;

mod iterator;

pub use iterator::Events;
pub use level::Level;

use crate::phase::Phase;
use crate::scalar::{Extended, Float};
use crate::table::{EphemerisScalar, EphemerisView, Sample};

/// Instant in ticks, and the sense of the change.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Event {
    /// Last tick at or before the event.
    pub tick: i64,
    /// Fraction of the following tick that passes before the event, in [0, 1).
    pub fraction: f64,
    /// Whether u or the tip angle increases at the event; at a turning point, whether u = e₂.
    pub upward: bool,
}

impl Event {
    /// Event after a number of ticks; `None` outside the range of `i64`.
    fn at(ticks: Extended, upward: bool) -> Option<Self> {
        /// Number beyond the range of `i64` whose floor fits 128 bits.
        const COUNTABLE: f64 = (1_u128 << 100) as f64;
        if ticks.to_f64().abs() > COUNTABLE {
            return None;
        }
        let (tick, fraction) = ticks.floor_and_fraction();
        let tick = i64::try_from(tick).ok()?;
        // not rounded to 1
        let fraction = fraction.to_f64();
        let fraction = if fraction < 1.0 { fraction } else { 1.0 - 0.5 * f64::EPSILON };
        Some(Self { tick, fraction, upward })
    }

    fn ticks(&self) -> Extended {
        Extended::from(self.tick) + self.fraction.into()
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Time of an event of this table, or of one with the same ticks, in s: the nearest `f64`.
    #[must_use]
    pub fn time_of(&self, event: &Event) -> f64 {
        (event.ticks() / self.clock.tick_rate()).to_f64()
    }

    /// Sample of the motion at the instant of an event of this table, or of one with the same ticks.
    #[must_use]
    pub fn at_event(&self, event: &Event) -> Sample<'_, R> {
        self.at_ticks(event.ticks())
    }
}

/// Leading 64 bits of the last nutation phase while u rises.
const LAST_RISING: u64 = u64::MAX >> 1;

/// Sample at the 64 leading bits of a nutation phase, with slow phases 0.
fn at_phase<R: EphemerisScalar>(ephemeris: &EphemerisView<R>, nutation: u64) -> Sample<'_, R> {
    Sample { ephemeris, phases: [nutation, 0, 0], mean_tip: Phase::ZERO }
}

/// Nutation phase from which on a condition holds while u rises. Cost: 63 evaluations.
fn bisect(holds: impl Fn(u64) -> bool) -> Phase {
    let (mut low, mut high) = (0, LAST_RISING);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if holds(middle) { high = middle } else { low = middle }
    }
    Phase::from_leading_bits(high)
}

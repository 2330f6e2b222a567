//! Event: an instant in ticks.

use crate::scalar::{Extended, Float};
use crate::table::{Sample, Table, TableScalar};

/// Instant in ticks, and the sense of the change.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Event {
    /// Last tick at or before the event.
    pub tick: i64,
    /// Fraction of the following tick that passes before the event, in [0, 1).
    pub fraction: f64,
    /// Whether u rises just before the event, as before u = e₂; for an event of the tip angle, whether the angle does.
    pub upward: bool,
}

impl Event {
    /// Event after a number of ticks; `None` outside the range of `i64`.
    pub(super) fn from_ticks(ticks: Extended, upward: bool) -> Option<Self> {
        /// Limit of the conversion to `i128`; more is outside `i64` anyway.
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

impl<R: TableScalar> Table<R> {
    /// Time of an event of this table, or of one with the same ticks, in s: the nearest `f64`.
    #[must_use]
    pub fn time_of(&self, event: &Event) -> f64 {
        (event.ticks() / self.clock.tick_rate()).to_f64()
    }

    /// Sample of the motion at the instant of an event of this table, or of one with the same ticks.
    #[must_use]
    pub fn at_event(&self, event: &Event) -> Sample<'_, R> {
        self.at_instant(event.ticks().into())
    }
}

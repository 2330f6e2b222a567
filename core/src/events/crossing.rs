//! Turning points, and the crossings of a level.

use crate::ephemeris::{EphemerisScalar, EphemerisView};
use crate::events::recurring::Recurring;
use crate::events::{Event, Level};
use crate::phase::Phase;

/// Iterator over the instants at which u turns, or crosses a level, in the order of time. Each step takes one addition in
/// extended precision. The iterator ends where there is no further event within the ticks of `i64`.
#[derive(Clone, Copy, Debug)]
pub struct Crossings {
    /// Instants of the upward and of the downward events.
    instants: Recurring<2>,
}

impl Crossings {
    /// Only the events with [`Event::upward`] = `upward`.
    #[must_use]
    pub fn only(mut self, upward: bool) -> Self {
        let dropped = usize::from(upward);
        self.instants.drop(dropped);
        self
    }
}

impl Iterator for Crossings {
    type Item = Event;

    fn next(&mut self) -> Option<Event> {
        let (index, ticks) = self.instants.pop()?;
        Event::at(ticks, index == 0)
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Turning points of u at tick `from` or later: a motion that starts at one has it at tick 0. There are none where u is
    /// constant to 2^-49.
    ///
    /// The time is exact but for the rounding of the nutation's rate and start, which the error bound of the orientation
    /// contains.
    #[must_use]
    pub fn turning_points(&self, from: i64) -> Crossings {
        // an aperiodic motion turns at its lowest point only
        let upper = self.clock.horizon.is_none().then_some(Phase::HALF);
        Crossings { instants: Recurring::new(self, [upper, Some(Phase::ZERO)], from) }
    }

    /// Instants at tick `from` or later at which u crosses a level. There are none where the motion does not reach it;
    /// for a level within the error bound of e₁ or e₂ the result depends on rounding.
    ///
    /// Error of the time: the error of u, bounded by the error bound of the orientation, over |u'| at the crossing.
    ///
    /// Cost: some 64 evaluations of the orientation, once.
    #[must_use]
    pub fn crossings(&self, level: Level, from: i64) -> Crossings {
        let rising = level.phase(self);
        Crossings { instants: Recurring::new(self, [rising, rising.map(|phase| -phase)], from) }
    }
}

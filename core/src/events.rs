//! Events: instants at which a motion turns, or reaches a tilt, a circle or a tip angle.
//!
//! u has a value at one nutation phase while it rises, found by bisection, and at minus that phase while it falls. A tip angle is found by
//! bisection in time.

mod event;

mod rising_half;

mod level;

mod recurring_instants;

mod tip_angle_search;

use crate::phase::Phase;
use crate::table::{Table, TableScalar};
use recurring_instants::RecurringInstants;
use tip_angle_search::TipAngleSearch;

pub use event::Event;
pub use level::Level;

/// Events of one kind in order, up to the last tick of `i64`.
#[derive(Clone, Copy, Debug)]
pub struct Events<'a, R: TableScalar>(Kind<'a, R>);

#[derive(Clone, Copy, Debug)]
enum Kind<'a, R: TableScalar> {
    /// Events at nutation phases; only those at the first one are upward.
    Phases(RecurringInstants),
    /// Events at a tip angle.
    TipAngle(TipAngleSearch<'a, R>),
}

impl<R: TableScalar> Iterator for Events<'_, R> {
    type Item = Event;

    fn next(&mut self) -> Option<Event> {
        match &mut self.0 {
            Kind::Phases(instants) => {
                let (index, ticks) = instants.pop()?;
                Event::from_ticks(ticks, index == 0)
            }
            Kind::TipAngle(search) => search.next(),
        }
    }
}

impl<R: TableScalar> Table<R> {
    /// Turning points of u at tick `from` or later. There are none where the tilt is constant to 2^-49 rad.
    #[must_use]
    pub fn turning_points(&self, from: i64) -> Events<'_, R> {
        self.events_at([Some(Phase::HALF), Some(Phase::ZERO)], from)
    }

    /// Instants at tick `from` or later at which u crosses a level. A level closer to e₁ or e₂ than the error bound may be missed, or
    /// found though u does not reach it.
    ///
    /// Error of the time: the orientation's error bound over the tilt's rate |u'|/√(1 - u²), and 2^-54 ticks. Cost: 65 orientations, once.
    #[must_use]
    pub fn crossings(&self, level: Level, from: i64) -> Events<'_, R> {
        let rising = level.phase(self);
        self.events_at([rising, rising.map(|phase| -phase)], from)
    }

    /// Instants at tick `from` or later at which [`Sample::tip_angle`](crate::Sample::tip_angle) is `angle`, whole turns aside.
    ///
    /// Error of the time: the orientation's error bound over 2|αβφ'| (in 16 bits twice as much), and 2^-54 ticks. Cost: some 100 tip angles.
    #[must_use]
    pub fn tip_angles(&self, angle: Phase, from: i64) -> Events<'_, R> {
        Events(Kind::TipAngle(TipAngleSearch::new(self, angle, from)))
    }

    /// Events at these nutation phases; only those at the first one are upward.
    fn events_at(&self, phases: [Option<Phase>; 2], from: i64) -> Events<'_, R> {
        let [first, second] = phases;
        Events(Kind::Phases(RecurringInstants::new(self, [first, second, None, None], from)))
    }
}

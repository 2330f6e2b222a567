//! Cursor: evaluation of consecutive ticks by adding increments to the phases.

use crate::phase::PhaseFraction;
use crate::table::data::clock::Clock;
use crate::table::data::storage::EphemerisView;
use crate::table::read::sample::Sample;
use crate::table::scalar::EphemerisScalar;

/// Phases of consecutive ticks, advanced by three additions a tick. A cursor belongs to the table that made it; a
/// [`Sampler`](crate::Sampler) keeps both together where tables are exchanged.
#[derive(Clone, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Cursor {
    /// Phases of the previous tick.
    phases: [PhaseFraction; 3],
    /// Number of the last tick, `base + count`. A count of 32 bits, with a rare branch for its carry, needs fewer registers of a small
    /// chip than one of 64 bits.
    count: u32,
    base: i64,
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Cursor whose first sample is that of tick `first`.
    #[must_use]
    pub fn cursor(&self, first: i64) -> Cursor {
        Cursor::new(&self.clock, first)
    }

    /// Samples at the ticks first, first + 1, ..., without end.
    pub fn samples(&self, first: i64) -> impl Iterator<Item = Sample<'_, R>> + Clone {
        let mut cursor = self.cursor(first);
        core::iter::repeat_with(move || cursor.next(self))
    }
}

impl Cursor {
    pub(crate) fn new<W>(clock: &Clock<W>, first: i64) -> Self {
        let mut phases = clock.at(first);
        for (phase, step) in phases.iter_mut().zip(clock.steps()) {
            *phase = phase.minus(step);
        }
        Self { phases, count: 0, base: first.wrapping_sub(1) }
    }

    /// Sample of the next tick. The sequence has no end and cannot fail.
    ///
    /// * `ephemeris`: the ephemeris that made the cursor
    #[inline(always)]
    pub fn next<'a, R: EphemerisScalar>(&mut self, ephemeris: &'a EphemerisView<R>) -> Sample<'a, R> {
        for (phase, step) in self.phases.iter_mut().zip(ephemeris.clock.steps()) {
            *phase = phase.plus(step);
        }
        let (count, carry) = self.count.overflowing_add(1);
        self.count = count;
        if carry {
            self.carry();
        }
        Sample::new(ephemeris, self.phases, ephemeris.clock.tip.at(self.tick()))
    }

    /// Tick of the last sample; before the first sample, the tick before it. It wraps after 2^63 - 1.
    #[inline(always)]
    #[must_use]
    pub fn tick(&self) -> i64 {
        self.base.wrapping_add(self.count.into())
    }

    #[cold]
    #[inline(never)]
    fn carry(&mut self) {
        self.base = self.base.wrapping_add(1 << 32);
    }
}

/// Tick of the last sample.
#[cfg(feature = "defmt")]
impl defmt::Format for Cursor {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "cursor at tick {=i64}", self.tick());
    }
}

//! Cursor: evaluation of consecutive ticks by adding increments to the phases.

use crate::ephemeris::clock::Clock;
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::sample::Sample;
use crate::ephemeris::storage::EphemerisView;
use crate::phase::PhaseFraction;

/// Phases of consecutive ticks, advanced by three additions a tick. An interrupt routine keeps the cursor and passes
/// the table to every call.
///
/// A cursor belongs to the ephemeris that made it, and to its clock; with another table it gives meaningless samples.
/// Where tables are exchanged between two ticks, a [`Sampler`](crate::Sampler) keeps table and cursor together.
#[derive(Clone, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Cursor {
    /// Phases of the previous tick. The sum is used and stored at once, so no copy of older phases is needed.
    phases: [PhaseFraction; 3],
    /// Lower part of the tick number: the last tick is `base + count`. A carry out of `count` requires a call of
    /// [`Cursor::carry`].
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
    pub fn samples(&self, first: i64) -> Samples<'_, R> {
        Samples::new(self, first)
    }
}

impl Cursor {
    pub(crate) fn new<W>(clock: &Clock<W>, first: i64) -> Self {
        let mut phases = clock.at(first);
        for (phase, step) in phases.iter_mut().zip(clock.steps()) {
            *phase = phase.minus(step);
        }
        let previous = first.wrapping_sub(1);
        match clock.horizon {
            None => Self { phases, count: 0, base: previous },
            Some(_) => Self { phases, count: u32::MAX, base: previous.wrapping_sub(u32::MAX.into()) },
        }
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
            self.carry(&ephemeris.clock);
        }
        Sample::new(ephemeris, self.phases, ephemeris.clock.tip.at(self.tick()))
    }

    /// Tick of the last sample; before the first sample, the tick before it. After tick 2^63 - 1 the number wraps to -2^63, and
    /// the motion continues.
    #[inline(always)]
    #[must_use]
    pub fn tick(&self) -> i64 {
        self.base.wrapping_add(self.count.into())
    }

    /// Carry of the tick number: after 2^32 ticks, or for an aperiodic motion, whose nutation phase does not wrap,
    /// after every tick.
    #[cold]
    #[inline(never)]
    fn carry<W>(&mut self, clock: &Clock<W>) {
        self.base = self.base.wrapping_add(1 << 32);
        if clock.horizon.is_some() {
            let tick = self.tick();
            self.phases = clock.at(tick);
            (self.count, self.base) = (u32::MAX, tick.wrapping_sub(u32::MAX.into()));
        }
    }
}

/// Iterator over the samples of consecutive ticks; it has no end.
#[derive(Clone, Debug)]
pub struct Samples<'a, R: EphemerisScalar> {
    ephemeris: &'a EphemerisView<R>,
    cursor: Cursor,
}

impl<'a, R: EphemerisScalar> Samples<'a, R> {
    pub(crate) fn new(ephemeris: &'a EphemerisView<R>, first: i64) -> Self {
        Self { ephemeris, cursor: ephemeris.cursor(first) }
    }
}

impl<'a, R: EphemerisScalar> Iterator for Samples<'a, R> {
    type Item = Sample<'a, R>;

    #[inline]
    fn next(&mut self) -> Option<Sample<'a, R>> {
        Some(self.cursor.next(self.ephemeris))
    }
}

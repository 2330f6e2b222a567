//! From one tick to the next.

use super::Ephemeris;
use crate::cycle::Cycle;
use crate::tick::moment::Moment;
use crate::tick::tabular::Tabular;

/// Goes through consecutive ticks: three additions each, then what is asked of the moment. What an interrupt holds.
#[derive(Clone, Copy, Debug)]
#[repr(C)] // the flag lies where the smallest chip's loads reach
pub struct Cursor<'a, R: Tabular, const SEGMENTS: usize, const TERMS: usize> {
    pub(super) ephemeris: &'a Ephemeris<R, SEGMENTS, TERMS>,
    /// Whether the nutation phase does not wrap, so that sums will not do.
    pub(super) counts: bool,
    /// Those of the tick before the current one, so that a tick has no old ones to keep.
    pub(super) phases: [Cycle; 3],
    /// If so, the tick before the current one.
    pub(super) tick: i64,
}

impl<'a, R: Tabular, const SEGMENTS: usize, const TERMS: usize> Cursor<'a, R, SEGMENTS, TERMS> {
    /// The moment of the current tick; the cursor moves on to the next. Never ends, never fails: not an iterator.
    #[inline(always)]
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> Moment<'a, R, SEGMENTS, TERMS> {
        for (phase, step) in self.phases.iter_mut().zip(&self.ephemeris.clock.step) {
            *phase = phase.plus(*step);
        }
        if self.counts {
            self.count();
        }
        self.ephemeris.moment(self.phases)
    }

    #[cold]
    #[inline(never)]
    fn count(&mut self) {
        self.tick = self.tick.wrapping_add(1);
        self.phases = self.ephemeris.clock.at(self.tick);
    }
}

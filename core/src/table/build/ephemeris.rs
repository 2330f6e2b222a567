//! Set-up of an ephemeris: from a motion to the whole table.

use super::bound::error_bounds;
use super::cut::Cut;
use super::set_up::{SetUp, SetUpError};
use crate::motion::Motion;
use crate::table::data::cell::{Cell, SEGMENTS_AT_LEVEL_0};
use crate::table::data::{Clock, Ephemeris, EphemerisMemory, EphemerisView, ReadyEphemeris, Tick};
use crate::table::evaluation::EphemerisScalar;

impl SetUp {
    /// Writes the cells, the clock and the error bounds.
    #[inline(never)]
    fn finish<R: EphemerisScalar>(
        &self,
        table: &mut EphemerisView<R>,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        pause: &mut dyn FnMut(),
    ) {
        let Cut { cells, segments, error, speeds, .. } = &self.cut;
        table.cells = *cells;
        table.segments.get_mut(*segments..).unwrap_or_default().fill(R::ZERO_SEGMENT);
        table.clock = Clock::new(motion, tick, epoch, self.rates.turns, self.start.phases);
        pause();
        table.start_tip_angle(motion, self.start.phases, epoch, pause);
        pause();
        [table.error_bound, table.rate_error_bound] =
            error_bounds(&R::ERRORS, motion, tick.length(), &self.rates, speeds, *error);
        pause();
    }
}

impl<R: EphemerisScalar> EphemerisMemory<EphemerisView<R>> {
    /// Sets up the table of a motion.
    ///
    /// * `epoch`: tick of the launch on a running counter
    /// * `pause`: called at least every 50 000 cycles of a Cortex-M4F (200 000 of a Cortex-M0+)
    ///
    /// # Errors
    /// [`SetUpError`]; the memory then contains no table.
    pub fn set_up(
        &mut self,
        set_up: &mut SetUp,
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        pause: &mut dyn FnMut(),
    ) -> Result<ReadyEphemeris<'_, R>, SetUpError> {
        let Self { is_set_up, table } = self;
        *is_set_up = false;
        let capacity = table.capacity();
        set_up.tabulate::<R>(motion, &mut table.segments, capacity, pause)?;
        pause();
        set_up.finish(table, motion, tick, epoch, pause);
        *is_set_up = true;
        Ok(ReadyEphemeris(self))
    }
}

impl<R: EphemerisScalar, const SEGMENTS: usize> Ephemeris<R, SEGMENTS> {
    /// Ephemeris of a motion that is launched at tick 0. It needs 14 KiB of stack on a Cortex-M4F in `f32`; [`EphemerisMemory::set_up`] needs 5 KiB.
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, SetUpError> {
        Self::with_truncation(motion, tick, R::TRUNCATION)
    }

    /// Ephemeris with a given truncation error, rad, finite and positive: a smaller table for a larger error.
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn with_truncation(motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, SetUpError> {
        let mut memory = EphemerisMemory::<Self>::new();
        memory.set_up(&mut SetUp::with_truncation(truncation), motion, tick, 0, &mut || {})?;
        Ok(memory.table)
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Number of segments that is enough for a truncation error, rad; `None` if 4096, the largest number, are not, or the motion has no table.
    #[must_use]
    pub fn segments_needed(motion: &Motion, truncation: f64) -> Option<u32> {
        let mut set_up = SetUp::with_truncation(truncation);
        set_up.tabulate::<R>(motion, &mut [], Cell::MOST_SEGMENTS, &mut || {}).ok()?;
        Some(set_up.cut.segments.max(SEGMENTS_AT_LEVEL_0) as u32)
    }
}

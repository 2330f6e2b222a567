//! Set-up: from a motion to its table.

use super::half_period::TabulatedHalfPeriod;
use super::path::PathScratch;
use super::set_up_error::SetUpError;
use super::tabulation::Division;
use crate::body::ParameterError;
use crate::motion::Motion;
use crate::table::data::cell::{MAX_SEGMENTS, MIN_SEGMENTS};
use crate::table::data::{Clock, SizedTable, Table, TableMemory};
use crate::table::evaluation::TableScalar;
use crate::table::time::Tick;

/// Settings of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TableSettings {
    /// Length of a tick.
    pub tick: Tick,
    /// Tick of the launch on a running counter.
    pub epoch: i64,
    /// Truncation error > 0, rad: a smaller table for a larger error. `None` for [`TableScalar::TRUNCATION`].
    pub truncation: Option<f64>,
}

impl TableSettings {
    /// Settings for a launch at tick 0 and the truncation error of the scalar.
    #[must_use]
    pub const fn new(tick: Tick) -> Self {
        Self { tick, epoch: 0, truncation: None }
    }
}

impl From<Tick> for TableSettings {
    fn from(tick: Tick) -> Self {
        Self::new(tick)
    }
}

/// Workspace of a set-up, 3.4 KB.
///
/// A program with a small stack keeps it in a static: see "In firmware" on [the first page](crate).
#[derive(Debug)]
pub struct Workspace {
    half_period: TabulatedHalfPeriod,
    scratch: PathScratch,
}

impl Default for Workspace {
    fn default() -> Self {
        Self::new()
    }
}

impl Workspace {
    /// Workspace before a set-up. A static of it takes no flash.
    #[must_use]
    pub const fn new() -> Self {
        Self { half_period: TabulatedHalfPeriod::ZERO, scratch: PathScratch::ZERO }
    }
}

impl<R: TableScalar> TableMemory<Table<R>> {
    /// Sets up the table of a motion, with these settings, or with those of [`TableSettings::new`] for a tick.
    ///
    /// * `pause`: called at least every 50 000 cycles of a Cortex-M4F (80 000 in `f64` compiled for size), and every 200 000 of a Cortex-M0+
    ///
    /// # Errors
    /// [`SetUpError`]; the memory then contains no table.
    pub fn set_up(
        &mut self,
        workspace: &mut Workspace,
        motion: &Motion,
        settings: impl Into<TableSettings>,
        pause: &mut dyn FnMut(),
    ) -> Result<&Table<R>, SetUpError> {
        let Self { is_set_up, table } = self;
        *is_set_up = false;
        table.compute(workspace, motion, &settings.into(), pause)?;
        *is_set_up = true;
        Ok(table)
    }
}

impl<R: TableScalar> Table<R> {
    #[inline(always)] // its frame would be on the stack during a set-up
    fn compute(
        &mut self,
        workspace: &mut Workspace,
        motion: &Motion,
        settings: &TableSettings,
        pause: &mut dyn FnMut(),
    ) -> Result<(), SetUpError> {
        let truncation = settings.truncation.unwrap_or(R::TRUNCATION);
        let capacity = self.segments.len();
        let Workspace { half_period, scratch } = workspace;
        half_period.compute::<R>(motion, truncation, scratch, &mut self.segments, capacity, pause)?;
        self.write_header(half_period, motion, settings, pause).map_err(SetUpError::Parameter)
    }

    /// Writes the cells, the clock and the error bounds.
    #[inline(never)]
    fn write_header(
        &mut self,
        half_period: &TabulatedHalfPeriod,
        motion: &Motion,
        settings: &TableSettings,
        pause: &mut dyn FnMut(),
    ) -> Result<(), ParameterError> {
        pause();
        let TabulatedHalfPeriod {
            division: Division { cells, segment_count, .. },
            mean_rates,
            launch_phases,
            ..
        } = half_period;
        self.cells = *cells;
        self.segments.get_mut(*segment_count..).unwrap_or_default().fill(R::ZERO_SEGMENT);
        self.clock = Clock::new(motion, settings.tick, settings.epoch, mean_rates.rates, *launch_phases)?;
        pause();
        self.set_tip_angle_at_launch(motion, *launch_phases, pause);
        pause();
        [self.error_bound, self.rate_error_bound] =
            half_period.error_bounds(R::TERMS, &R::ERRORS, motion, settings.tick.length());
        Ok(())
    }
}

impl<R: TableScalar, const SEGMENTS: usize> SizedTable<R, SEGMENTS> {
    /// Table of a motion, with these settings, or with those of [`TableSettings::new`] for a tick. In `f32` this takes 11.6 KB of a Cortex-M4F's
    /// stack; [`TableMemory::set_up`] takes 3.8 KB.
    ///
    /// # Errors
    /// [`SetUpError`]
    pub fn new(motion: &Motion, settings: impl Into<TableSettings>) -> Result<Self, SetUpError> {
        let mut memory = TableMemory::<Self>::new();
        memory.set_up(&mut Workspace::new(), motion, settings.into(), &mut || {})?;
        Ok(memory.table)
    }
}

impl<R: TableScalar, S: ?Sized> Table<R, S> {
    /// Number of segments for a truncation error, rad. It takes the time of a set-up, and its stack with the `Workspace` on it.
    ///
    /// # Errors
    /// [`SetUpError`]; the table is too small if 4096 segments are too few.
    pub fn segments_needed(motion: &Motion, truncation: f64) -> Result<u32, SetUpError> {
        let Workspace { half_period, scratch } = &mut Workspace::new();
        let segments = &mut [R::ZERO_SEGMENT];
        half_period.compute::<R>(motion, truncation, scratch, segments, MAX_SEGMENTS, &mut || {})?;
        Ok(half_period.division.segment_count.max(MIN_SEGMENTS) as u32)
    }
}

//! Cursor: consecutive ticks by adding increments to the phases.

use crate::phase::WrappedPhase;
use crate::table::data::Table;
use crate::table::evaluation::TableScalar;
use crate::table::read::sample::Sample;
use crate::table::time::{Instant, Phases};
use core::marker::PhantomData;

/// Phases of consecutive ticks of one table, by three additions each.
///
/// A cursor does not borrow its table, so that an interrupt can own both and exchange them at a relaunch, without lock and copy: see
/// `examples/relaunch.rs`. Pass its table to [`Cursor::next`]: a table of another scalar does not compile, and another table of the same scalar
/// panics in builds with debug assertions.
///
/// ```compile_fail,E0308
/// # use toytop::Table;
/// fn tick(single: &Table<f32>, double: &Table<f64>) {
///     single.cursor(0).next(double);
/// }
/// ```
#[derive(Clone, Debug)]
#[repr(C)] // the same for every scalar: the C interface reads the tick without knowing it
pub struct Cursor<R> {
    /// Phases of the last tick.
    phases: Phases<WrappedPhase>,
    /// The last tick is `high + low`. A tick adds to the 32 bits of `low`; `high` changes every 2^32 ticks. With one
    /// `i64` a tick of q31 takes 24 cycles more on a Cortex-M4F.
    low: u32,
    high: i64,
    scalar: PhantomData<fn() -> R>,
}

impl<R: TableScalar> Cursor<R> {
    /// Sample of the next tick. After tick 2^63 - 1 comes -2^63.
    ///
    /// Pass the table that made the cursor: with another table of the same scalar the orientation is wrong, which only a debug assertion notices.
    #[inline(always)]
    pub fn next<'a>(&mut self, table: &'a Table<R>) -> Sample<'a, R> {
        debug_assert!(self.belongs_to(table), "a cursor belongs to the table that made it");
        self.phases.update(table.clock.wrapped_increments(), WrappedPhase::plus);
        let (low, carry) = self.low.overflowing_add(1);
        self.low = low;
        if carry {
            self.carry();
        }
        let phases = self.phases.map(WrappedPhase::leading_bits);
        Sample::new(table, phases, Instant::at_tick(self.tick()))
    }

    /// Whether the phases are those of this table at the tick of the cursor, also after the tick number has wrapped.
    fn belongs_to(&self, table: &Table<R>) -> bool {
        self.phases.map(WrappedPhase::lower)
            == table.clock.phases_at_tick(self.tick()).map(WrappedPhase::lower)
    }

    /// Tick of the last sample, or the one before the first sample. It wraps after 2^63 - 1.
    #[inline(always)]
    #[must_use]
    pub fn tick(&self) -> i64 {
        self.high.wrapping_add(self.low.into())
    }

    #[cold]
    fn carry(&mut self) {
        self.high = self.high.wrapping_add(1 << 32);
    }
}

impl<R: TableScalar> Table<R> {
    /// Cursor whose first sample is at tick `first`.
    #[must_use]
    pub fn cursor(&self, first: i64) -> Cursor<R> {
        let phases =
            self.clock.phases_at_tick(first).zip_map(self.clock.wrapped_increments(), WrappedPhase::minus);
        Cursor { phases, low: 0, high: first.wrapping_sub(1), scalar: PhantomData }
    }
}

/// Tick of the last sample.
#[cfg(feature = "defmt")]
impl<R: TableScalar> defmt::Format for Cursor<R> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "cursor at tick {=i64}", self.tick());
    }
}

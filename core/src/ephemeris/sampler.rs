//! Sampler: a table with its cursor, for a routine that samples every tick while tables are exchanged.

use crate::ephemeris::cursor::Cursor;
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::sample::Sample;
use crate::ephemeris::storage::EphemerisView;

/// Samples at consecutive ticks from a table that can be exchanged between two ticks. It owns the table and the cursor
/// together, so that a cursor is never used with another table than its own.
///
/// It is meant for an interrupt routine whose table is replaced during operation. The sampler holds the table by an
/// exclusive reference and returns the old one, which can then be set up again. With two tables, and two
/// single-producer single-consumer queues of references to them, the exchange needs no lock, no copy of a table and no
/// `unsafe`, also on a chip that has no compare-and-swap. The firmware example `relaunch` does so. Count the ticks of
/// all tables by one counter, with [`EphemerisView::delay`].
///
/// ```
/// # use toytop::{EphemerisF32, Motion, Release, Sampler, State, Tick, Top, TopParameters};
/// # let top = Top::sliding(&TopParameters {
/// #     transverse_inertia: 3.0e-5,
/// #     axial_inertia: 2.0e-5,
/// #     com_height: 0.03,
/// #     mass: 0.05,
/// #     ..TopParameters::default()
/// # })?;
/// # let tick = Tick::hertz(1000)?;
/// # let launched = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
/// # let mut first = EphemerisF32::new(&Motion::launch(&top, &launched)?, tick)?;
/// # let struck = first.at_tick(3).attitude_state().state()?.with_impulse(&top, [0.0, 1e-3, 0.0], [0.03, 0.0, 0.03])?;
/// # let mut second = EphemerisF32::new(&Motion::launch(&top, &struck)?, tick)?;
/// # second.delay(3.0);
/// let mut sampler = Sampler::new(&mut first, 0);
/// for _ in 0..4 {
///     let _orientation = sampler.next().orientation(); // ticks 0 to 3
/// }
/// let old = sampler.exchange(&mut second); // cannot fail
/// let _orientation = sampler.next().orientation(); // tick 4
/// assert!(sampler.tick() == 4 && old.capacity() == 25);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Sampler<'a, R: EphemerisScalar> {
    table: &'a mut EphemerisView<R>,
    cursor: Cursor,
}

impl<'a, R: EphemerisScalar> Sampler<'a, R> {
    /// Sampler whose first sample is that of tick `first`.
    #[must_use]
    pub fn new(table: &'a mut EphemerisView<R>, first: i64) -> Self {
        let cursor = table.cursor(first);
        Self { table, cursor }
    }

    /// Sample of the next tick. The sequence has no end and cannot fail.
    #[expect(clippy::should_implement_trait, reason = "an iterator cannot lend from itself")]
    #[inline(always)]
    pub fn next(&mut self) -> Sample<'_, R> {
        self.cursor.next(self.table)
    }

    /// Tick of the last sample; before the first sample, the tick before it.
    #[must_use]
    pub fn tick(&self) -> i64 {
        self.cursor.tick()
    }

    /// Table of the next sample.
    #[must_use]
    pub fn table(&self) -> &EphemerisView<R> {
        self.table
    }

    /// Exchanges the table and returns the previous one. The tick number continues: the next sample has the same tick as
    /// without the exchange, but comes from the new table.
    pub fn exchange(&mut self, table: &'a mut EphemerisView<R>) -> &'a mut EphemerisView<R> {
        self.cursor = table.cursor(self.tick().wrapping_add(1));
        core::mem::replace(&mut self.table, table)
    }
}

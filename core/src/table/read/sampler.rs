//! Sampler: a table with its cursor, for a routine that samples every tick while tables are exchanged.

use crate::table::data::storage::{EphemerisView, ReadyEphemeris};
use crate::table::read::cursor::Cursor;
use crate::table::read::sample::Sample;
use crate::table::scalar::EphemerisScalar;

/// Samples at consecutive ticks from a table that can be exchanged between two ticks, for an interrupt routine.
///
/// It owns the table with its cursor, and returns the old table, whose memory can be set up again. The exchange needs no lock and no copy:
/// see the firmware example `relaunch`. All tables count the ticks of one counter.
///
/// ```
/// # use toytop::{EphemerisF32, EphemerisMemory, Motion, Release, Sampler, SetUp, State, Tick, Top, TopParameters};
/// # let top = Top::sliding(&TopParameters {
/// #     transverse_inertia: 3.0e-5,
/// #     axial_inertia: 2.0e-5,
/// #     com_height: 0.03,
/// #     mass: 0.05,
/// #     ..TopParameters::default()
/// # })?;
/// # let tick = Tick::hertz(1000)?;
/// # let launched = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
/// # let mut set_up = SetUp::new();
/// # let [mut first, mut second] = [(); 2].map(|()| EphemerisMemory::<EphemerisF32>::new());
/// # let first = first.set_up(&mut set_up, &Motion::launch(&top, &launched)?, tick, 0, &mut || {})?;
/// # let struck = first.at_tick(3).attitude_state().state()?.with_impulse(&top, [0.0, 1e-3, 0.0], [0.03, 0.0, 0.03])?;
/// # let second = second.set_up(&mut set_up, &Motion::launch(&top, &struck)?, tick, 3, &mut || {})?;
/// let mut sampler = Sampler::new(first, 0);
/// for _ in 0..4 {
///     let _orientation = sampler.next().orientation(); // ticks 0 to 3
/// }
/// let old = sampler.exchange(second); // cannot fail
/// let _orientation = sampler.next().orientation(); // tick 4
/// assert!(sampler.tick() == 4 && old.capacity() == 25);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Sampler<'a, R: EphemerisScalar> {
    table: ReadyEphemeris<'a, R>,
    cursor: Cursor,
}

impl<'a, R: EphemerisScalar> Sampler<'a, R> {
    /// Sampler whose first sample is that of tick `first`.
    #[must_use]
    pub fn new(table: ReadyEphemeris<'a, R>, first: i64) -> Self {
        let cursor = table.cursor(first);
        Self { table, cursor }
    }

    /// Sample of the next tick. The sequence has no end and cannot fail.
    #[expect(clippy::should_implement_trait, reason = "an iterator cannot lend from itself")]
    #[inline(always)]
    pub fn next(&mut self) -> Sample<'_, R> {
        self.cursor.next(&self.table)
    }

    /// Tick of the last sample; before the first sample, the tick before it.
    #[must_use]
    pub fn tick(&self) -> i64 {
        self.cursor.tick()
    }

    /// Table of the next sample.
    #[must_use]
    pub fn table(&self) -> &EphemerisView<R> {
        &self.table
    }

    /// Exchanges the table and returns the previous one. The tick number continues.
    pub fn exchange(&mut self, table: ReadyEphemeris<'a, R>) -> ReadyEphemeris<'a, R> {
        self.cursor = table.cursor(self.tick().wrapping_add(1));
        core::mem::replace(&mut self.table, table)
    }
}

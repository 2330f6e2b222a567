//! Cursor: consecutive ticks by adding increments to the phases.

use core::borrow::Borrow;
use core::ops::Deref;

use crate::phase::{Phase, WrappedPhase};
use crate::su2::Orientation;
use crate::table::data::Clock;
use crate::table::data::EphemerisView;
use crate::table::evaluation::EphemerisScalar;
use crate::table::read::sample::{Sample, map_parts};

/// Reader of consecutive ticks of a table, by three additions each.
///
/// The table is a `&EphemerisView`, or a [`ReadyEphemeris`](crate::ReadyEphemeris), whose memory an exchange frees. An exchange needs no lock and
/// no copy.
///
/// ```
/// # use toytop::{Cursor, EphemerisF32, EphemerisMemory, Motion, Release, SetUp, State, Tick, Top, TopParameters};
/// # let top = Top::sliding(&TopParameters {
/// #     transverse_inertia: 3.0e-5,
/// #     axial_inertia: 2.0e-5,
/// #     com_height: 0.03,
/// #     mass: 0.05,
/// #     ..TopParameters::default()
/// # })?;
/// # let tick = Tick::hertz(1000)?;
/// # let state = State::from_release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() })?;
/// # let motion = Motion::launch(&top, &state)?;
/// let mut set_up = SetUp::new();
/// let [mut first, mut second] = [(); 2].map(|()| EphemerisMemory::<EphemerisF32>::new());
/// let first = first.set_up(&mut set_up, &motion, tick, 0, &mut || { /* feed the watchdog */ })?;
/// # let struck = first.at_tick(3).attitude_state().state()?.with_impulse(&top, [0.0, 1e-3, 0.0], [0.03, 0.0, 0.03])?;
/// # let struck = Motion::launch(&top, &struck)?;
/// let second = second.set_up(&mut set_up, &struck, tick, 3, &mut || {})?; // launched at tick 3
/// let mut cursor = Cursor::new(first, 0);
/// for _ in 0..4 {
///     let _orientation = cursor.next().orientation(); // ticks 0 to 3
/// }
/// let old = cursor.exchange(second); // cannot fail
/// let _orientation = cursor.next().orientation(); // tick 4
/// assert!(cursor.tick() == 4 && old.capacity() == 25);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[repr(C)]
pub struct Cursor<T> {
    phases: CursorPhases,
    table: T,
}

impl<R: EphemerisScalar, S: ?Sized + 'static, T> Cursor<T>
where
    T: Deref<Target = EphemerisView<R, S>>,
    EphemerisView<R, S>: Borrow<EphemerisView<R>>,
{
    /// Cursor whose first sample is that of tick `first`.
    #[must_use]
    pub fn new(table: T, first: i64) -> Self {
        Self { phases: CursorPhases::new(&table.clock, first), table }
    }

    /// Table of the next sample.
    #[must_use]
    pub fn table(&self) -> &EphemerisView<R> {
        self.table.deref().borrow()
    }

    /// Sample of the next tick. It borrows the cursor. The sequence has no end and cannot fail.
    #[expect(clippy::should_implement_trait, reason = "an iterator cannot lend from itself")]
    #[inline(always)]
    pub fn next(&mut self) -> Sample<'_, R> {
        self.phases.next(self.table.deref().borrow())
    }

    /// Tick of the last sample, or the one before the first sample. It wraps after 2^63 - 1.
    #[inline(always)]
    #[must_use]
    pub fn tick(&self) -> i64 {
        self.phases.tick()
    }

    /// Exchanges the table and returns the previous one. The tick number continues.
    pub fn exchange(&mut self, table: T) -> T {
        self.phases = CursorPhases::new(&table.clock, self.tick().wrapping_add(1));
        core::mem::replace(&mut self.table, table)
    }
}

impl<R: EphemerisScalar, S: ?Sized + 'static> EphemerisView<R, S>
where
    Self: Borrow<EphemerisView<R>>,
{
    /// Cursor whose first sample is that of tick `first`. A capacity in the type saves some cycles a tick.
    #[must_use]
    pub fn cursor(&self, first: i64) -> Cursor<&Self> {
        Cursor::new(self, first)
    }
}

/// Phases of consecutive ticks of a table that is kept elsewhere.
#[derive(Clone, Debug)]
#[repr(C)]
pub struct CursorPhases {
    /// Phases of the last tick.
    phases: [WrappedPhase; 3],
    /// Number of the last tick, `high + low`. A rare carry needs fewer registers than a number of 64 bits.
    low: u32,
    high: i64,
}

impl CursorPhases {
    /// Phases before tick `first`.
    pub fn new<W>(clock: &Clock<W>, first: i64) -> Self {
        let mut phases = clock.at(first);
        for (phase, step) in phases.iter_mut().zip(clock.steps()) {
            *phase = phase.minus(step);
        }
        Self { phases, low: 0, high: first.wrapping_sub(1) }
    }

    /// Sample of the next tick of the table that made the phases.
    #[inline(always)]
    pub fn next<'a, R: EphemerisScalar>(&mut self, table: &'a EphemerisView<R>) -> Sample<'a, R> {
        for (phase, step) in self.phases.iter_mut().zip(table.clock.steps()) {
            *phase = phase.plus(step);
        }
        let (low, carry) = self.low.overflowing_add(1);
        self.low = low;
        if carry {
            self.carry();
        }
        Sample::new(table, self.phases, table.clock.mean_tip(self.tick()))
    }

    /// Tick of the last sample.
    #[inline(always)]
    pub fn tick(&self) -> i64 {
        self.high.wrapping_add(self.low.into())
    }

    #[cold]
    #[inline(never)]
    fn carry(&mut self) {
        self.high = self.high.wrapping_add(1 << 32);
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Fills `out` with the orientations at the ticks first, first + 1, .... The bits are those of [`EphemerisView::at_tick`]; faster on a PC.
    pub fn fill(&self, first: i64, out: &mut [Orientation<R>]) {
        /// Number of ticks whose orientations are computed independently.
        const BLOCK: usize = 16;
        // as 128-bit numbers, which need no assembly from words
        let step = self.clock.steps().map(WrappedPhase::to_phase);
        let mut now = self.clock.at(first).map(WrappedPhase::to_phase);
        let mut phases = [[0; 3]; BLOCK];
        for block in out.chunks_mut(BLOCK) {
            for phases in phases.iter_mut().take(block.len()) {
                *phases = now.map(Phase::leading_bits);
                now.iter_mut().zip(step).for_each(|(now, step)| *now += step);
            }
            for (orientation, phases) in block.iter_mut().zip(phases) {
                *orientation = map_parts(&self.unrounded_orientation(phases), R::from_number);
            }
        }
    }
}

/// Tick of the last sample.
#[cfg(feature = "defmt")]
impl<T> defmt::Format for Cursor<T> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "cursor at tick {=i64}", self.phases.tick());
    }
}

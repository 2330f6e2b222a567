//! The orientation at any tick: a table of short polynomials and three integer phases.
//!
//! A tick is: nutation phase (an integer) → cell, segment and place in it → four Horner sums → two rotations by the slow phases
//! (integers too). No root, no division, no library function, no loop whose length depends on data: any tick
//! costs the same, and the 2^40th is as exact as the first.

mod baked;
mod clock;
mod cursor;

pub use baked::{Bakeable, Baked, BakedError};
use clock::Clock;
pub use cursor::Cursor;

use super::moment::Moment;
use super::table::{ErrorBound, NoFit, Table, Tick};
use super::tabular::Tabular;
use crate::cycle::Cycle;
use crate::launch::{Motion, Rates};
use crate::real::{DoubleDouble, Float, Ring};
use crate::su2::Phi;
use crate::turns::Turns;

/// One motion, ready for any tick: a table and a clock. Immutable once set up, so any number of readers may share it
/// (`&Ephemeris` is all that a [`Cursor`] holds) without locks.
///
/// `SEGMENTS` polynomials of `TERMS` coefficients at most cover half a nutation period, short ones where the motion hurries; size
/// 4 · SEGMENTS · TERMS scalars (in `f32` as many integers of 32 bits) and some 200 bytes. [`EphemerisF32`] and [`EphemerisF64`] are
/// sizes for most motions.
///
/// ```
/// use toytop::{EphemerisF32, Heaviness, Motion, Release, State, Tick, Top};
/// let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81)?;
/// let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
/// let motion = Motion::launch(&top, &State::release(&release)?)?;
/// let ephemeris = EphemerisF32::new(&motion, Tick::hertz(1000)?)?;
/// let mut cursor = ephemeris.cursor(0);
/// let now = cursor.next(); // tick 0; cannot fail
/// let in_a_century = ephemeris.at_tick(3_155_760_000_000);
/// assert!(now.phi().u() > 0.93 && in_a_century.phi().u() > 0.8);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // what a tick adds lies first, where the smallest chip's loads reach
pub struct Ephemeris<R: Tabular, const SEGMENTS: usize, const TERMS: usize> {
    pub(super) clock: Clock<R::Wide>,
    pub(super) table: Table<R::Coefficient, SEGMENTS, TERMS>,
    bound: ErrorBound,
}

/// Good for every motion with (e₃ - e₂)/(e₂ - e₁) >= 0.1 and A/(ps) >= 0.25, at the rounding of `f32`: a table of 2 KiB.
pub type EphemerisF32 = Ephemeris<f32, 25, 5>;

/// Good for the same motions at the rounding of `f64`: 17 KiB. Where A/(ps) >= 1, `Ephemeris<f64, 32, 11>` (11 KiB) is.
pub type EphemerisF64 = Ephemeris<f64, 48, 11>;

/// So many ticks at a time: their phases first, so that what follows need not wait for one another.
const BLOCK: usize = 16;

impl<R: Tabular, const SEGMENTS: usize, const TERMS: usize> Ephemeris<R, SEGMENTS, TERMS> {
    /// Sets up the table and the clock of a motion. Cost: a series of 16 terms for each segment, of which
    /// there are `SEGMENTS` or fewer (one that is halved is tried again), and a quadrature in double-double
    /// ([`Motion::averages`]); before a refusal up to 4096 more, to say how many would do.
    ///
    /// # Errors
    /// [`NoFit`]: the polynomials would miss the motion by more than four roundings of the scalar; it says how many
    /// segments would do.
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, NoFit> {
        Self::within(motion, tick, 4.0 * R::ROUNDING)
    }

    /// As [`Ephemeris::new`], with the truncation allowed, rad: a smaller table for a larger error.
    ///
    /// # Errors
    /// [`NoFit`], as there.
    pub fn within(motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, NoFit> {
        let mut ephemeris = Self::EMPTY;
        ephemeris.set_up(motion, tick, truncation)?;
        Ok(ephemeris)
    }

    /// A table of nothing, for a `static` that [`Ephemeris::set_up`] fills in place: all zeros, its error bound too, so that it
    /// takes no flash.
    pub const EMPTY: Self = Self {
        table: Table::of(R::NOTHING),
        clock: Clock {
            first: [0; 3],
            step: [Cycle::ZERO; 3],
            exact_step: [DoubleDouble::ZERO; 3],
            ticks_per_time: DoubleDouble::ZERO,
            horizon: None,
            tip_scale: R::Wide::ZERO,
            rates: [R::Wide::ZERO; 3],
        },
        bound: ErrorBound { constant: 0.0, per_tick: 0.0 },
    };

    /// Sets up in place: what a chip does, whose stack should not hold a table.
    ///
    /// # Errors
    /// [`NoFit`], as [`Ephemeris::new`]; the table is then not to be used, and its error bound is infinite.
    pub fn set_up(&mut self, motion: &Motion, tick: Tick, truncation: f64) -> Result<(), NoFit> {
        self.bound = ErrorBound { constant: f64::INFINITY, per_tick: 0.0 };
        let rates = Rates::of(motion, R::ROUNDING);
        let tabulated = self.table.fill::<R>(motion, &rates, truncation)?;
        let cells = 1 << Table::<R::Coefficient, SEGMENTS, TERMS>::CELL_BITS;
        self.clock = Clock::new(motion, tick, &rates, &tabulated, cells);
        self.bound = ErrorBound::of::<R>(&rates, &tabulated, cells, self.clock.exact_step.map(Float::to_f64));
        Ok(())
    }

    /// How far the orientation can be from the truth: stated, not guessed.
    #[must_use]
    pub fn error_bound(&self) -> ErrorBound {
        self.bound
    }

    /// The moment t units of time after t = 0, t taken as exact. A t that is not finite is t = 0.
    ///
    /// Equal to [`Ephemeris::at_tick`] to the bit where t is a whole number of ticks (and the tick rate is a whole or half
    /// number). Only where one tick would be longer than all of an aperiodic motion's rise are moments within it not told apart.
    #[must_use]
    pub fn at(&self, t: f64) -> Moment<'_, R, SEGMENTS, TERMS> {
        let ticks = if t.is_finite() { self.clock.ticks_per_time * t.into() } else { DoubleDouble::ZERO };
        let (whole, share) = ticks.floor_and_rest();
        self.moment(self.clock.between(whole, share))
    }

    /// The moment of tick n, past or future.
    #[inline(always)]
    #[must_use]
    pub fn at_tick(&self, n: i64) -> Moment<'_, R, SEGMENTS, TERMS> {
        self.moment(self.clock.at(n))
    }

    #[inline(always)]
    fn moment(&self, phases: [Cycle; 3]) -> Moment<'_, R, SEGMENTS, TERMS> {
        Moment { ephemeris: self, phases: phases.map(Cycle::leading) }
    }

    /// A way through consecutive ticks, by additions only.
    #[must_use]
    pub fn cursor(&self, first: i64) -> Cursor<'_, R, SEGMENTS, TERMS> {
        let mut before = self.clock.at(first);
        for (phase, step) in before.iter_mut().zip(self.clock.step) {
            *phase = phase.minus(step);
        }
        let tick = first.wrapping_sub(1);
        Cursor { ephemeris: self, phases: before, counts: self.clock.horizon.is_some(), tick }
    }

    /// The next turning point of u after tick n - 1, so that its tick is n or later; `None` where u does not turn again, or
    /// turns more than once a tick. Not for every tick: it divides.
    #[must_use]
    pub fn next_turning_point(&self, n: i64) -> Option<TurningPoint> {
        let [exact_step, ..] = self.clock.exact_step;
        if !(exact_step > DoubleDouble::ZERO && exact_step < DoubleDouble::from(0.5)) {
            return None;
        }
        let before = n.saturating_sub(1);
        let ([step, ..], [nutation, ..]) = (self.clock.step, self.clock.at(before));
        if let Some([first, last]) = self.clock.horizon {
            // an aperiodic motion has one turning point, its lowest: the end of the falling half
            let falling = before < first || (before <= last && nutation.to_signed_turns() < Turns::ZERO);
            let from = before.max(first);
            let [nutation, ..] = self.clock.at(from);
            let ticks = ticks_to(-nutation.to_signed_turns(), step);
            return falling.then_some(TurningPoint { tick: from.saturating_add(ticks), upper: false });
        }
        let (halves, rest) = nutation.to_turns().halves();
        let ticks = ticks_to(Turns::HALF - rest, step);
        Some(TurningPoint { tick: before.saturating_add(ticks), upper: halves == 0 })
    }

    /// Φ at the ticks first, first + 1, ...: the same bits as tick by tick, in less time on a processor that does several things
    /// at once; with its wider vectors (`-C target-cpu=x86-64-v3`) in little more than half of that in `f32`.
    pub fn fill(&self, first: i64, out: &mut [Phi<R>]) {
        if self.clock.horizon.is_some() {
            for (phi, past) in out.iter_mut().zip(0..) {
                *phi = self.at_tick(first.wrapping_add(past)).phi();
            }
            return;
        }
        // as wide numbers: words would have to be put together for every tick
        let step = self.clock.step.map(Cycle::to_turns);
        let mut now = self.clock.at(first).map(Cycle::to_turns);
        let mut phases = [[0; 3]; BLOCK];
        for block in out.chunks_mut(BLOCK) {
            for phases in phases.iter_mut().take(block.len()) {
                *phases = now.map(Turns::fraction);
                for (now, step) in now.iter_mut().zip(step) {
                    *now += step;
                }
            }
            for (phi, &phases) in block.iter_mut().zip(&phases) {
                *phi = Moment { ephemeris: self, phases }.phi();
            }
        }
    }
}

/// Where u turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TurningPoint {
    /// The first tick at or after it.
    pub tick: i64,
    /// At u = e₂; otherwise at u = e₁.
    pub upper: bool,
}

/// How many steps until a phase ahead is reached or passed; both positive.
fn ticks_to(ahead: Turns, step: Cycle) -> i64 {
    let (ahead, step) = (ahead.to_bits(), step.to_turns().to_bits().max(1));
    i64::try_from((ahead + step - 1) / step).unwrap_or(i64::MAX)
}

//! The orientation at any tick: a table of short polynomials and three integer phases.
//!
//! A tick is: nutation phase (an integer) → segment and place in it → four Horner sums → two rotations by the slow phases
//! (integers too). No root, no division, no library function, no loop whose length depends on data: any tick
//! costs the same, and the 2^40th is as exact as the first.

use super::moment::{Moment, Phases};
use super::table::{ErrorBound, NoFit, Table, Tick};
use crate::launch::{Motion, Rates, Tabulated, tabulate};
use crate::real::{DoubleDouble, Float, Real, Ring, Scalar};
use crate::su2::Phi;
use crate::turns::Turns;

/// One motion, ready for any tick: a table and a clock. Immutable once set up, so any number of readers may share it
/// (`&Ephemeris` is all that a [`Cursor`] holds) without locks.
///
/// `SEGMENTS`, a power of two, polynomials of `TERMS` coefficients cover half a nutation period; size
/// 4 · SEGMENTS · TERMS scalars and some 150 bytes. [`EphemerisF32`] and [`EphemerisF64`] are sizes for most motions.
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
pub struct Ephemeris<R, const SEGMENTS: usize, const TERMS: usize> {
    pub(super) table: Table<R, SEGMENTS, TERMS>,
    pub(super) clock: Clock<R>,
    bound: ErrorBound,
}

/// Good for every motion with (e₃ - e₂)/(e₂ - e₁) >= 0.1 and A/(ps) >= 0.25, at the rounding of `f32`: 1792 bytes.
pub type EphemerisF32 = Ephemeris<f32, 16, 7>;

/// Good for the same motions at the rounding of `f64`.
pub type EphemerisF64 = Ephemeris<f64, 64, 11>;

/// The phases at tick 0, what a tick adds to them, and the scales of what is derived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Clock<R> {
    pub(super) start: Phases,
    pub(super) step: Phases,
    /// Ticks in a unit of time.
    pub(super) ticks_per_time: DoubleDouble,
    /// Beyond so many ticks an aperiodic motion is at its end; `None` for one that returns.
    pub(super) horizon: Option<i64>,
    /// 2 s.
    pub(super) tip_scale: R,
    /// dx/dt on a segment, and the mean rates of A and B in rad, per unit time.
    pub(super) rates: [R; 3],
}

impl<R: Real, const SEGMENTS: usize, const TERMS: usize> Ephemeris<R, SEGMENTS, TERMS> {
    /// Sets up the table and the clock of a motion. Cost: `SEGMENTS` series of 16 terms, and a quadrature in double-double.
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

    /// A table of nothing, for a `static` that [`Ephemeris::set_up`] fills in place.
    pub const EMPTY: Self = Self {
        table: Table::EMPTY,
        clock: Clock {
            start: [Turns::ZERO; 3],
            step: [Turns::ZERO; 3],
            ticks_per_time: DoubleDouble::ZERO,
            horizon: None,
            tip_scale: R::ZERO,
            rates: [R::ZERO; 3],
        },
        bound: ErrorBound { constant: 0.0, per_tick: 0.0 },
    };

    /// Sets up in place: what a chip does, whose stack should not hold a table.
    ///
    /// # Errors
    /// [`NoFit`], as [`Ephemeris::new`]; the table is then not to be used.
    pub fn set_up(&mut self, motion: &Motion, tick: Tick, truncation: f64) -> Result<(), NoFit> {
        let rates = Rates::of(motion, R::ROUNDING);
        let tabulated = tabulate(motion, &rates, SEGMENTS, TERMS, |segment, polynomials| {
            self.table.put(segment, polynomials);
        });
        NoFit::check(motion, &rates, &tabulated, [SEGMENTS, TERMS], truncation)?;
        self.clock = Clock::new(motion, tick, &rates, &tabulated, SEGMENTS);
        self.bound = ErrorBound::of::<R>(&rates, &tabulated, &self.clock.step);
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
    /// number).
    #[must_use]
    pub fn at(&self, t: f64) -> Moment<'_, R, SEGMENTS, TERMS> {
        let ticks = if t.is_finite() { self.clock.ticks_per_time * t.into() } else { DoubleDouble::ZERO };
        let (whole, share) = ticks.floor_and_share();
        let Moment { phases, .. } = self.at_tick(whole);
        let mut phases = phases;
        for (phase, step) in phases.iter_mut().zip(self.clock.step) {
            *phase += step.part(share);
        }
        Moment { ephemeris: self, phases }
    }
}

impl<R: Scalar, const SEGMENTS: usize, const TERMS: usize> Ephemeris<R, SEGMENTS, TERMS> {
    /// The moment of tick n, past or future.
    #[inline]
    #[must_use]
    pub fn at_tick(&self, n: i64) -> Moment<'_, R, SEGMENTS, TERMS> {
        let [nutation, alpha, beta] = self.clock.step;
        let [start, a, b] = self.clock.start;
        let counted = match self.clock.horizon {
            None => n,
            Some(horizon) => n.clamp(-horizon, horizon),
        };
        let phases = [start + nutation.times(counted), a + alpha.times(n), b + beta.times(n)];
        Moment { ephemeris: self, phases }
    }

    /// A way through consecutive ticks, by additions only.
    #[must_use]
    pub fn cursor(&self, first: i64) -> Cursor<'_, R, SEGMENTS, TERMS> {
        Cursor { moment: self.at_tick(first) }
    }

    /// The next turning point of u after tick n - 1, so that its tick is n or later; `None` where u does not turn again, or
    /// turns more than once a tick. Not for every tick: it divides.
    #[must_use]
    pub fn next_turning_point(&self, n: i64) -> Option<TurningPoint> {
        let [step, ..] = self.clock.step;
        let nutation = self.at_tick(n - 1).phases[0];
        let (halves, rest) = nutation.halves();
        let to_go = match self.clock.horizon {
            None => Turns::HALF - rest,
            // an aperiodic motion has one turning point, its lowest
            Some(_) if nutation < Turns::ZERO => -nutation,
            Some(_) => return None,
        };
        if step <= Turns::ZERO || step >= Turns::HALF {
            return None;
        }
        let ticks = (to_go.to_bits() + step.to_bits() - 1) / step.to_bits();
        let upper = self.clock.horizon.is_none() && halves & 1 == 0;
        Some(TurningPoint { tick: (n - 1).saturating_add(i64::try_from(ticks).ok()?), upper })
    }

    /// Φ at the ticks first, first + 1, ...
    pub fn fill(&self, first: i64, out: &mut [Phi<R>]) {
        let mut cursor = self.cursor(first);
        for phi in out {
            *phi = cursor.next().phi();
        }
    }

    /// The phase on the table: in [-1/2, 1/2) turn as 64 bits, negative on the falling half.
    #[inline]
    pub(super) fn nutation_bits(&self, phase: Turns) -> u64 {
        match self.clock.horizon {
            None => phase.fraction(),
            Some(_) => phase.clamped().fraction(),
        }
    }
}

impl<R: Real> Clock<R> {
    fn new(motion: &Motion, tick: Tick, rates: &Rates, tabulated: &Tabulated, segments: usize) -> Self {
        let length = tick.length();
        let step = rates.turns.map(|turns| Turns::of(turns * length));
        // a million half periods: no count of ticks up to there wraps
        let horizon = DoubleDouble::from(1e6) / (rates.turns[0] * length);
        let [frequency, alpha, beta] = rates.turns.map(Float::to_f64);
        let turn = 2.0 * core::f64::consts::PI;
        // half a period is `segments` segments of length 2 in x
        let x_rate = 4.0 * segments as f64 * frequency;
        Self {
            start: tabulated.start,
            step,
            ticks_per_time: tick.rate(),
            horizon: (!rates.returns).then(|| horizon.to_f64() as i64),
            tip_scale: R::from_f64(2.0 * motion.top().tip_scale()),
            rates: [x_rate, turn * alpha, turn * beta].map(R::from_f64),
        }
    }
}

/// Where u turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TurningPoint {
    /// The first tick at or after it.
    pub tick: i64,
    /// At u = e₂; otherwise at u = e₁.
    pub upper: bool,
}

/// Goes through consecutive ticks: three additions each, then what is asked of the moment. What an interrupt holds.
#[derive(Clone, Copy, Debug)]
pub struct Cursor<'a, R, const SEGMENTS: usize, const TERMS: usize> {
    moment: Moment<'a, R, SEGMENTS, TERMS>,
}

impl<'a, R: Scalar, const SEGMENTS: usize, const TERMS: usize> Cursor<'a, R, SEGMENTS, TERMS> {
    /// The moment of the current tick; the cursor moves on to the next. Never ends, never fails: not an iterator.
    #[inline]
    #[allow(clippy::should_implement_trait)]
    pub fn next(&mut self) -> Moment<'a, R, SEGMENTS, TERMS> {
        let now = self.moment;
        for (phase, step) in self.moment.phases.iter_mut().zip(now.ephemeris.clock.step) {
            *phase += step;
        }
        now
    }
}

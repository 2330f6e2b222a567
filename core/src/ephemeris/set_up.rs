//! Set-up of an ephemeris: from a motion to the table and the clock.

use core::task::Poll;

use crate::ephemeris::cell::Cell;
use crate::ephemeris::clock::Clock;
use crate::ephemeris::error_bound::{ErrorBound, phase_errors};
use crate::ephemeris::evaluation::{EphemerisScalar, EvaluationErrors};
use crate::ephemeris::larger_error::LargerError;
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::polynomial::{Polynomial, Store};
use crate::ephemeris::rate_error::{MotionRates, rate_error};
use crate::ephemeris::segment_estimate::{Estimation, SegmentEstimate};
use crate::ephemeris::steady::constant;
use crate::ephemeris::storage::{EphemerisStorage, EphemerisView};
use crate::ephemeris::table::{TableTooSmall, put};
use crate::ephemeris::tabulate::Tabulation;
use crate::ephemeris::tabulated::{ROUNDINGS_ALLOWED, Requirements, Tabulated};
use crate::ephemeris::tick::Tick;
use crate::ephemeris::tip_angle::WindingProgress;
use crate::motion::Motion;
use crate::scalar::Float;

/// Set-up of an ephemeris in slices of bounded work, for a program that has other work in between, such as feeding a watchdog,
/// serving a bus, or stepping other motions. Its memory, at most 6 KiB, is needed until the ephemeris is ready.
///
/// ```
/// use toytop::{EphemerisF32, Motion, Release, SetUp, State, Tick, Top, TopParameters};
/// # let top = Top::sliding(&TopParameters {
/// #     transverse_inertia: 3.0e-5,
/// #     axial_inertia: 2.0e-5,
/// #     com_height: 0.03,
/// #     mass: 0.05,
/// #     ..TopParameters::default()
/// # })?;
/// # let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
/// let motion = Motion::launch(&top, &State::release(&release)?)?;
/// let mut ephemeris = EphemerisF32::EMPTY;
/// let mut set_up = SetUp::new(&motion, Tick::hertz(1000)?);
/// while set_up.poll(&mut ephemeris)?.is_pending() {
///     // feed the watchdog
/// }
/// assert_eq!(ephemeris, EphemerisF32::new(&motion, Tick::hertz(1000)?)?);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SetUp {
    motion: Motion,
    tick: Tick,
    /// Truncation error allowed, rad; `None` for that of [`EphemerisStorage::new`].
    truncation: Option<f64>,
    rates: MeanRates,
    tabulation: Tabulation,
    /// Estimates of the segments that a table with the allowed error needs, and one with the smaller error of the first
    /// attempt.
    estimation: Estimation,
    /// Result of the tabulation.
    tabulated: Tabulated,
    winding: WindingProgress,
    stage: Stage,
}

/// Stage of a set-up.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    /// Mean rates.
    Rates,
    /// Table with a smaller error than the allowed one.
    Fine,
    /// Table with the allowed error, where the capacity is too small for the smaller one.
    Coarse,
    /// Beginning of the table.
    Begin,
    /// Estimate of the segments that the table needs.
    Estimate,
    /// Clock of the completed table.
    Clock,
    /// Argument of αβ up to the segment of the start, for the tip angle.
    Winding,
    /// Mean tip angle.
    TipAngle,
    /// Error bounds.
    Bounds,
    /// Nothing, because the result is known.
    Ended(Result<(), TableTooSmall>),
}

/// Requirements on the first attempt at a table: a quarter of the allowed error, but not less than a tenth of the error of a tick, `tick`,
/// because the table would be larger and the orientation hardly more accurate.
fn fine(requirements: &Requirements, tick: f64) -> Requirements {
    let allowed = requirements.allowed;
    requirements.within((allowed / LargerError::FACTOR).max(0.1 * tick).min(allowed))
}

impl SetUp {
    /// Set-up with the truncation error of [`Ephemeris::new`](crate::Ephemeris::new), four roundings of the scalar.
    #[must_use]
    pub fn new(motion: &Motion, tick: Tick) -> Self {
        Self {
            motion: *motion,
            tick,
            truncation: None,
            rates: MeanRates::ZERO,
            tabulation: Tabulation::EMPTY,
            estimation: Estimation::BEGINNING,
            tabulated: Tabulated::EMPTY,
            winding: WindingProgress::NONE,
            stage: Stage::Rates,
        }
    }

    /// Set-up with a given truncation error, rad: a smaller table for a larger error.
    #[must_use]
    pub fn within(motion: &Motion, tick: Tick, truncation: f64) -> Self {
        Self { truncation: Some(truncation), ..Self::new(motion, tick) }
    }

    /// Begins the set-up for another motion in the same memory, with the truncation error of [`new`](Self::new), for a program that keeps
    /// it in a static because the stack is small.
    pub fn restart(&mut self, motion: &Motion, tick: Tick) {
        (self.motion, self.tick, self.truncation) = (*motion, tick, None);
        (self.estimation, self.stage) = (Estimation::BEGINNING, Stage::Rates);
    }

    /// Motion of the ephemeris.
    #[must_use]
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Performs the next slice of the work; the ephemeris must be the same at each call. Until the result is
    /// [`Poll::Ready`] the ephemeris must not be used, and its error bounds are infinite. Calls after that return the same
    /// result and change nothing.
    ///
    /// # Errors
    /// [`TableTooSmall`]: the truncation error would exceed the allowed one; the ephemeris must then not be used.
    #[inline(never)]
    pub fn poll<R: EphemerisScalar>(
        &mut self,
        ephemeris: &mut EphemerisView<R>,
    ) -> Poll<Result<(), TableTooSmall>> {
        match self.stage {
            Stage::Ended(result) => return Poll::Ready(result),
            Stage::Rates => {
                let infinite = ErrorBound::INFINITE;
                (ephemeris.error_bound, ephemeris.rate_error_bound) = (infinite, infinite);
                if !self.motion.is_steady() {
                    self.tabulation.find_law::<R::Rates>(&self.motion);
                }
                self.find_rates(R::ROUNDING, &mut store(ephemeris));
            }
            Stage::Begin => {
                let requirements = fine(&self.requirements(ephemeris), R::ERRORS.tick);
                self.tabulation.begin(&self.motion, &self.rates, requirements);
                self.stage = Stage::Estimate;
            }
            Stage::Estimate => return self.estimate(self.requirements(ephemeris), R::ERRORS.tick),
            Stage::Clock => {
                self.start_clock(ephemeris);
                self.winding = WindingProgress::NONE;
                self.stage = Stage::Winding;
            }
            Stage::Winding => {
                let [nutation, ..] = self.tabulated.start;
                if ephemeris.wind(nutation, &mut self.winding) {
                    self.stage = Stage::TipAngle;
                }
            }
            Stage::TipAngle => {
                ephemeris.start_tip_angle(&self.motion, self.tabulated.start, &self.winding);
                self.stage = Stage::Bounds;
            }
            Stage::Bounds => {
                self.state_bounds(ephemeris);
                self.stage = Stage::Ended(Ok(()));
                return Poll::Ready(Ok(()));
            }
            Stage::Fine | Stage::Coarse => {
                if self.tabulate(&mut store(ephemeris)).is_err() {
                    return self.attempt_again(self.requirements(ephemeris));
                }
            }
        }
        Poll::Pending
    }

    fn requirements<R: EphemerisScalar>(&self, ephemeris: &EphemerisView<R>) -> Requirements {
        let allowed = self.truncation.unwrap_or(ROUNDINGS_ALLOWED * R::ROUNDING);
        Requirements::new(R::TERMS, allowed, R::ROUNDING, ephemeris.segments.len())
    }

    /// Finds the mean rates, and tabulates a steady motion.
    #[inline(never)] // one copy for all scalars, and so are the next; and the stack frames of set-up must not add up
    fn find_rates(&mut self, rounding: f64, store: &mut Store<'_>) {
        self.rates = MeanRates::of(&self.motion, self.tabulation.law(), rounding);
        self.stage = if self.motion.is_steady() {
            self.tabulated = constant(&self.motion, store);
            Stage::Clock
        } else {
            Stage::Begin
        };
    }

    /// Does the next piece of the tabulation.
    ///
    /// # Errors
    /// The table would have too many segments.
    #[inline(never)]
    fn tabulate(&mut self, store: &mut Store<'_>) -> Result<(), ()> {
        if self.tabulation.advance(store)? {
            self.tabulated = self.tabulation.result(&self.motion);
            self.stage = Stage::Clock;
        }
        Ok(())
    }

    /// Estimates the segments that the table needs, and chooses the attempt that may fit, or none.
    #[inline(never)]
    fn estimate(&mut self, requirements: Requirements, tick: f64) -> Poll<Result<(), TableTooSmall>> {
        let fits = |estimate: &SegmentEstimate| estimate.least_segments(0) <= requirements.most;
        let [coarse, fine] = [requirements, fine(&requirements, tick)];
        if !self.tabulation.estimate(&self.rates, &[coarse, fine], &mut self.estimation) {
            return Poll::Pending;
        }
        let [of_coarse, of_fine] = self.estimation.estimates();
        if fine.allowed < coarse.allowed && fits(of_fine) {
            self.tabulation.again(fine, *of_fine);
            self.stage = Stage::Fine;
        } else if fits(of_coarse) {
            self.tabulation.again(coarse, *of_coarse);
            self.stage = Stage::Coarse;
        } else {
            return self.refuse(&requirements);
        }
        Poll::Pending
    }

    /// Begins the second attempt after the first, if it may fit.
    #[inline(never)]
    fn attempt_again(&mut self, requirements: Requirements) -> Poll<Result<(), TableTooSmall>> {
        let [of_coarse, _] = self.estimation.estimates();
        if self.stage != Stage::Fine || !self.tabulation.may_fit_with_larger_error(of_coarse) {
            return self.refuse(&requirements);
        }
        self.tabulation.again(requirements, *of_coarse);
        self.stage = Stage::Coarse;
        Poll::Pending
    }

    fn refuse(&mut self, requirements: &Requirements) -> Poll<Result<(), TableTooSmall>> {
        let refusal = TableTooSmall { truncation: requirements.allowed, segments: requirements.most as u32 };
        self.stage = Stage::Ended(Err(refusal));
        Poll::Ready(Err(refusal))
    }

    #[inline(never)]
    fn start_clock<R: EphemerisScalar>(&self, ephemeris: &mut EphemerisView<R>) {
        let Self { motion, tick, rates, tabulated, .. } = self;
        ephemeris.cells = tabulated.cells.map(Cell::to_bits);
        ephemeris.segments.get_mut(tabulated.segments..).unwrap_or_default().fill(R::ZERO_SEGMENT);
        ephemeris.clock = Clock::new(motion, *tick, rates, tabulated);
    }

    #[inline(never)] // the stack frames of set-up must not add up
    fn state_bounds<R: EphemerisScalar>(&self, ephemeris: &mut EphemerisView<R>) {
        let [_, mean, axial] = ephemeris.clock.rates.map(Float::to_f64);
        let of_motion = self.motion_rates(ephemeris.half_periods_per_time(), [mean, axial]);
        let increments = ephemeris.clock.increment_errors();
        [ephemeris.error_bound, ephemeris.rate_error_bound] = self.bounds(&R::ERRORS, increments, &of_motion);
    }
}

impl SetUp {
    /// Error bounds of the orientation and of the angular velocity, from the errors of the increments per tick, turns.
    #[inline(never)] // one copy for all scalars
    fn bounds(
        &self,
        errors: &EvaluationErrors,
        increments: [f64; 3],
        of_motion: &MotionRates,
    ) -> [ErrorBound; 2] {
        let Self { tick, rates, tabulated, .. } = self;
        let per_tick = phase_errors(rates, tick.length().to_f64(), increments);
        let bound = ErrorBound::of(errors, rates, tabulated, per_tick);
        [bound, rate_error(errors, bound.constant, per_tick, of_motion, tabulated)]
    }

    #[inline(never)]
    fn motion_rates(&self, half_periods: f64, [mean, axial]: [f64; 2]) -> MotionRates {
        let Self { motion, .. } = self;
        MotionRates {
            half_periods,
            mean,
            axial,
            rotor: Float::abs(motion.top().rotor_momentum()) / motion.top().transverse_inertia(),
            transverse: motion.greatest_transverse_rate(),
            sine: motion.branch_points().greatest_sine(),
        }
    }
}

/// Receiver of the polynomials of an ephemeris.
fn store<R: EphemerisScalar>(
    ephemeris: &mut EphemerisView<R>,
) -> impl FnMut(usize, usize, &Polynomial) -> [f32; 2] {
    |segment, which, parts| put::<R>(&mut ephemeris.segments, segment, which, parts)
}

impl<R: EphemerisScalar, const SEGMENTS: usize> EphemerisStorage<R, [R::Segment; SEGMENTS]> {
    /// Ephemeris of a motion. Cost: a series of 16 terms for each span, which has one to eight segments, and two
    /// polynomials for each segment, of which there are at most `SEGMENTS`; a span or segment that is halved is computed again.
    ///
    /// # Errors
    /// [`TableTooSmall`]: the truncation error would exceed four roundings of the scalar.
    pub fn new(motion: &Motion, tick: Tick) -> Result<Self, TableTooSmall> {
        Self::within(motion, tick, ROUNDINGS_ALLOWED * R::ROUNDING)
    }

    /// Ephemeris with a given truncation error, in rad: a smaller table for a larger error.
    ///
    /// # Errors
    /// [`TableTooSmall`], as for [`new`](crate::Ephemeris::new).
    pub fn within(motion: &Motion, tick: Tick, truncation: f64) -> Result<Self, TableTooSmall> {
        let mut ephemeris = Self::EMPTY;
        ephemeris.set_up(motion, tick, truncation)?;
        Ok(ephemeris)
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Sets up this ephemeris in its own memory, for a chip whose stack is too small for a table. [`SetUp`] does the
    /// same in slices.
    ///
    /// # Errors
    /// [`TableTooSmall`]; the table must then not be used, and its error bound is infinite.
    #[inline(never)]
    pub fn set_up(&mut self, motion: &Motion, tick: Tick, truncation: f64) -> Result<(), TableTooSmall> {
        let mut set_up = SetUp::within(motion, tick, truncation);
        loop {
            if let Poll::Ready(result) = set_up.poll(self) {
                return result;
            }
        }
    }

    /// Number of segments that is enough for a motion with a given truncation error, rad; `None` if 4096 segments, the
    /// largest number, are not enough. Cost: up to 4096 series, far more than a set-up, so it is meant for a PC.
    #[must_use]
    pub fn segments_needed(motion: &Motion, truncation: f64) -> Option<u32> {
        if motion.is_steady() {
            return Some(1);
        }
        let mut tabulation = Tabulation::EMPTY;
        tabulation.find_law::<R::Rates>(motion);
        let rates = MeanRates::of(motion, tabulation.law(), R::ROUNDING);
        let requirements = Requirements::new(R::TERMS, truncation, R::ROUNDING, Cell::MOST_SEGMENTS);
        tabulation.begin(motion, &rates, requirements);
        loop {
            match tabulation.advance(&mut |_, _, parts| put::<R>(&mut [], 0, 0, parts)) {
                Ok(false) => {}
                Ok(true) => return Some(tabulation.result(motion).segments as u32),
                Err(()) => return None,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_attempt_is_not_much_more_exact_than_a_tick() {
        fn quotient<R: EphemerisScalar>() -> f64 {
            let requirements = Requirements::new(R::TERMS, ROUNDINGS_ALLOWED * R::ROUNDING, R::ROUNDING, 64);
            fine(&requirements, R::ERRORS.tick).allowed / requirements.allowed
        }
        assert_eq!([quotient::<f64>(), quotient::<f32>()], [0.25; 2]);
        #[cfg(feature = "fixed")]
        {
            assert_eq!(quotient::<fixed::types::I2F30>(), 1.0);
            let short = quotient::<fixed::types::I2F14>();
            assert!(short > 0.4 && short < 0.5, "{short}");
        }
    }
}

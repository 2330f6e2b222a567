//! Change of the clock of an ephemeris: another tick length, or another instant as tick 0, with the same table.
//!
//! The table is a function of phases, and only the clock depends on the ticks. Therefore a change costs some divisions instead
//! of a set-up. The error bound remains an upper bound; `core/docs/error_bound.md` states its growth.

use crate::ephemeris::cell::{Cell, PAIRS};
use crate::ephemeris::clock::{
    Clock, TipClock, first_phases, interval_of_half_turns, whole_between, whole_ticks,
};
use crate::ephemeris::error_bound::{ErrorBound, TRUNCATION};
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::rate_error::{MotionRates, PhaseErrors};
use crate::ephemeris::storage::EphemerisView;
use crate::ephemeris::tick::Tick;
use crate::law::series::larger_or_nan;
use crate::phase::PhaseFraction;
use crate::scalar::{Extended, Float, Ring};

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Changes the length of a tick. Tick 0 remains the instant t = 0; [`EphemerisView::at`] gives the same motion as
    /// before. A cursor from before the change must be replaced.
    ///
    /// The error per unit of time is that of the previous ticks plus the rounding of the new increments, so that changes
    /// back and forth accumulate no more than roundings. Cost: thirty operations in extended precision, and a sum over the
    /// table for the error bound.
    pub fn set_tick(&mut self, tick: Tick) {
        let clock = &self.clock;
        let [hi, lo] = clock.ticks_per_time;
        // number of previous ticks in a new one
        let ratio = Extended::sum(hi, lo) * tick.length();
        let exact_step = clock.exact_steps().map(|step| step * ratio);
        let start = clock.unstopped(0, Extended::ZERO).map(PhaseFraction::to_phase);
        self.clock = Clock {
            first: first_phases(start, exact_step),
            step: exact_step.map(|step| PhaseFraction::of(step.to_phase()).words()),
            exact_step: exact_step.map(Extended::parts),
            ticks_per_time: tick.rate().parts(),
            horizon: clock.nutation_interval().map(|ends| whole_between(ends.map(|end| end / ratio))),
            tip: TipClock { step: TipClock::increment(exact_step, clock.tip.passes), ..clock.tip },
            ..*clock
        };
        let mut increment_errors = self.clock.increment_errors();
        for (error, step) in increment_errors.iter_mut().zip(exact_step) {
            *error = Float::abs(*error) + RATIO_ERROR * Float::abs(step.to_f64());
        }
        for bound in [&mut self.error_bound, &mut self.rate_error_bound] {
            bound.per_tick *= ratio.to_f64();
        }
        self.widen_bounds([TRUNCATION; 3], increment_errors);
    }

    /// Delays the motion by a number of ticks, which may be fractional and of either sign: the instant that was tick 0
    /// becomes tick `ticks`, and t = 0 is the instant of the new tick 0. A number that is not finite counts as 0. A
    /// cursor from before the change must be replaced.
    ///
    /// After `table.delay(n)`, a table that is launched at tick n of a running counter, or between two of its ticks,
    /// is read with the tick numbers of that counter. The tip angle keeps its whole turns. The error bound at tick 0
    /// grows by the bound's growth over `ticks` ticks. Cost: that of [`EphemerisView::set_tick`].
    ///
    /// ```
    /// # use toytop::{EphemerisF64, Motion, Release, State, Tick, Top, TopParameters};
    /// # let top = Top::sliding(&TopParameters {
    /// #     transverse_inertia: 3.0e-5,
    /// #     axial_inertia: 2.0e-5,
    /// #     com_height: 0.03,
    /// #     mass: 0.05,
    /// #     ..TopParameters::default()
    /// # })?;
    /// # let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
    /// # let motion = Motion::launch(&top, &State::release(&release)?)?;
    /// let mut table = EphemerisF64::new(&motion, Tick::hertz(1000)?)?;
    /// let start = table.at_tick(0).orientation();
    /// table.delay(250.25); // the motion starts a quarter of a tick after tick 250
    /// assert!(table.at(0.25025).orientation().distance(&start) < 1e-14);
    /// table.set_tick(Tick::hertz(4000)?);
    /// assert!(table.at_tick(1001).orientation().distance(&start) < 1e-14);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    pub fn delay(&mut self, ticks: f64) {
        let ticks = if ticks.is_finite() { ticks } else { 0.0 };
        let clock = &self.clock;
        let (whole, share) = Extended::from(-ticks).floor_and_rest();
        let start = clock.unstopped(whole_ticks(whole), share).map(PhaseFraction::to_phase);
        self.clock = Clock {
            first: first_phases(start, clock.exact_steps()),
            horizon: clock.nutation_interval().map(|ends| whole_between(ends.map(|end| end + ticks.into()))),
            tip: TipClock { start: clock.tip.between(whole, share).words(), ..clock.tip },
            ..*clock
        };
        for bound in [&mut self.error_bound, &mut self.rate_error_bound] {
            bound.constant = bound.after(ticks);
        }
        self.widen_bounds([TRUNCATION; 3], [0.0; 3]);
    }

    /// Adds errors of the phases, in turns, at tick 0 and per tick, to both error bounds.
    fn widen_bounds(&mut self, constant: [f64; 3], per_tick: [f64; 3]) {
        let [sweep, acceleration] = self.greatest_speeds();
        let [_, mean, axial] = self.clock.rates.map(Float::to_f64);
        let half_periods = self.half_periods_per_time();
        // the table is known, but not the motion
        let unknown =
            MotionRates { half_periods, mean, axial, rotor: 0.0, transverse: f64::INFINITY, sine: 1.0 };
        let of_rates = PhaseErrors::new(&unknown, sweep, acceleration);
        self.error_bound.constant += ErrorBound::of_phases(sweep, constant);
        self.error_bound.per_tick += ErrorBound::of_phases(sweep, per_tick);
        self.rate_error_bound.constant += of_rates.of(constant);
        self.rate_error_bound.per_tick += of_rates.of(per_tick);
    }

    /// Number of half nutation periods per unit of time; 0 where u is constant.
    pub(crate) fn half_periods_per_time(&self) -> f64 {
        // x changes by 2 over each pair of cells
        let [x_rate, ..] = self.clock.rates;
        x_rate.to_f64() / (2 * PAIRS) as f64
    }

    /// Upper bounds on the angular velocity without the mean rotation and on its derivative, in rad per half period and
    /// per half period squared, from the coefficients of the table.
    fn greatest_speeds(&self) -> [f64; 2] {
        let mut greatest = [0.0; 2];
        for (number, cell) in self.cells.map(Cell::from_bits).into_iter().enumerate() {
            let x_rate = ((2 * PAIRS) << cell.level()) as f64;
            for segment in self.segments.get(cell.segments(number)).unwrap_or_default() {
                let [slope, curvature] = derivatives::<R>(segment.as_ref());
                let speeds = [slope * x_rate, curvature * x_rate * x_rate];
                greatest.iter_mut().zip(speeds).for_each(|(most, speed)| *most = larger_or_nan(*most, speed));
            }
        }
        greatest
    }
}

/// Relative error of an increment that is the product of the previous increment and the ratio of two tick lengths: two
/// quotients, of which one was computed for the previous tick length, and two products.
const RATIO_ERROR: f64 = 4.0 * Extended::ROUNDING;

impl<W> Clock<W> {
    /// Ticks, fractional, between which the phase of an aperiodic motion changes; `None` for other motions.
    pub(crate) fn nutation_interval(&self) -> Option<[Extended; 2]> {
        let [first, _] = self.horizon?;
        let ([phase, ..], [step, ..]) = (self.at(first), self.exact_steps());
        Some(interval_of_half_turns(phase.to_signed_phase(), step).map(|end| end + first.into()))
    }
}

/// Upper bounds on the first two derivatives of a segment with respect to x, as 2 √(|α|² + |β|²): on [-1, 1] the derivatives
/// of a polynomial are at most Σ k |c_k| and Σ k (k - 1) |c_k|.
fn derivatives<R: EphemerisScalar>(terms: &[[R::Coefficient; 4]]) -> [f64; 2] {
    let mut sums = [[0.0; 4]; 2];
    for (power, coefficients) in terms.iter().enumerate() {
        let k = power as f64;
        for (i, &c) in coefficients.iter().enumerate() {
            let size = Float::abs(R::number(c, power).to_f64());
            let [slope, curvature] = &mut sums;
            for (sum, factor) in [(slope, k), (curvature, k * (k - 1.0))] {
                if let Some(sum) = sum.get_mut(i) {
                    *sum += factor * size;
                }
            }
        }
    }
    sums.map(|sums| 2.0 * Float::sqrt(sums.iter().map(|sum| sum * sum).sum::<f64>()))
}

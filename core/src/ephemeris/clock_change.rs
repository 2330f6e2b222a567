//! Change of the clock of an ephemeris: another tick length, or another instant as tick 0, with the same table.
//!
//! The table is a function of phases, and only the clock depends on the ticks. Therefore a change takes some divisions in place
//! of a set-up. The error bound remains an upper bound; `core/docs/error_bound.md` states its growth.

use crate::ephemeris::cell::{CELLS, Cell};
use crate::ephemeris::clock::{Clock, TipClock, first_phases, rise, whole_between, whole_ticks};
use crate::ephemeris::error_bound::{ErrorBound, TRUNCATION};
use crate::ephemeris::evaluation::EphemerisScalar;
use crate::ephemeris::storage::EphemerisView;
use crate::ephemeris::tick::Tick;
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
            horizon: clock.rise().map(|rise| whole_between(rise.map(|end| end / ratio))),
            tip: TipClock { step: TipClock::increment(exact_step, clock.tip.passes), ..clock.tip },
            ..*clock
        };
        let sweep = self.sweep();
        let mut missed = self.clock.missed();
        for (missed, step) in missed.iter_mut().zip(exact_step) {
            *missed = Float::abs(*missed) + RATIO_ERROR * Float::abs(step.to_f64());
        }
        self.widen_bounds(
            ErrorBound::of_phases(sweep, [TRUNCATION; 3]),
            self.error_bound.per_tick * ratio.to_f64() + ErrorBound::of_phases(sweep, missed),
        );
    }

    /// Delays the motion by a number of ticks, which may be fractional and of either sign: the instant that was tick 0
    /// becomes tick `ticks`, and t = 0 moves with tick 0. A number that is not finite counts as 0. A cursor from before
    /// the change must be replaced.
    ///
    /// With it a table that is launched at tick n of a running counter, or between two of its ticks, is read by that
    /// counter: `table.delay(n)`. The tip angle keeps its whole turns. The error bound at tick 0 grows by the bound's
    /// growth over `ticks` ticks. Cost: that of [`EphemerisView::set_tick`].
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
            horizon: clock.rise().map(|rise| whole_between(rise.map(|end| end + ticks.into()))),
            tip: TipClock { start: clock.tip.between(whole, share).words(), ..clock.tip },
            ..*clock
        };
        let truncation = ErrorBound::of_phases(self.sweep(), [TRUNCATION; 3]);
        let ErrorBound { per_tick, .. } = self.error_bound;
        self.widen_bounds(per_tick * Float::abs(ticks) + truncation, per_tick);
    }

    /// Adds `growth` to the error bound of the orientation at tick 0, and replaces its growth per tick. Both are caused by
    /// errors of the phases, which change the bound of the angular velocity in a fixed proportion.
    fn widen_bounds(&mut self, growth: f64, per_tick: f64) {
        let (before, rate) = (self.error_bound, self.rate_error_bound);
        let of_rate = if before.per_tick > 0.0 { rate.per_tick / before.per_tick } else { 0.0 };
        self.error_bound = ErrorBound { constant: before.constant + growth, per_tick };
        self.rate_error_bound =
            ErrorBound { constant: rate.constant + of_rate * growth, per_tick: of_rate * per_tick };
    }

    /// Upper bound on the angular velocity without the mean rotation, rad per half period, from the coefficients of the
    /// table.
    fn sweep(&self) -> f64 {
        let mut greatest = 0.0;
        for cell in self.cells.map(Cell::from_bits) {
            let (first, number) = (cell.first(), 1 << cell.level());
            for segment in self.segments.get(first..first + number).unwrap_or_default() {
                let slope = slope::<R>(segment.as_ref()) * (2 * CELLS * number) as f64;
                greatest = if slope > greatest { slope } else { greatest };
            }
        }
        greatest
    }
}

/// Relative error of an increment that is the product of another with the ratio of two tick lengths: two quotients, of
/// which one is from before, and two products.
const RATIO_ERROR: f64 = 4.0 * Extended::ROUNDING;

impl<W> Clock<W> {
    /// Ticks, fractional, between which the phase of an aperiodic motion changes; `None` for other motions.
    pub(crate) fn rise(&self) -> Option<[Extended; 2]> {
        let [first, _] = self.horizon?;
        let ([phase, ..], [step, ..]) = (self.at(first), self.exact_steps());
        // a whole number of 63 bits is the sum of two f64
        let leading = first as f64;
        let tick = Extended::sum(leading, i128::from(first).wrapping_sub(leading as i128) as f64);
        Some(rise(phase.to_signed_phase(), step).map(|end| end + tick))
    }
}

/// Upper bound on 2 √(|dα/dx|² + |dβ/dx|²) on a segment: on [-1, 1] a derivative is at most Σ k |c_k|.
fn slope<R: EphemerisScalar>(terms: &[[R::Coefficient; 4]]) -> f64 {
    let mut sums = [0.0; 4];
    for (power, coefficients) in terms.iter().enumerate() {
        for (sum, &c) in sums.iter_mut().zip(coefficients) {
            *sum += power as f64 * Float::abs(R::number(c, power).to_f64());
        }
    }
    2.0 * Float::sqrt(sums.iter().map(|sum| sum * sum).sum::<f64>())
}

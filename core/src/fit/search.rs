//! Search for a launch without a first guess, on longer and longer parts of the measurements.

use crate::fit::Fit;
use crate::fit::beginning::{Beginning, FIRST_WINDOW};
use crate::fit::outcome::{FitError, Reason, Statistics};
use crate::fit::pass::{Progress, SETTLED};
use crate::fit::sensor::{Hint, Measurement};
use crate::fit::window::Part;
use crate::scalar::Real;

/// Size of a correction, in standard deviations, below which a window is finished.
const NEAR: f64 = 0.5;
/// Number of measurements to which the windows after the first two are thinned.
const THINNED: usize = 192;
/// Number of measurements to which all of them are thinned before the last passes. The launch is then within some standard
/// deviations of the best one, and one pass over all measurements corrects it.
const LAST_THINNED: usize = 512;

/// Least mean square of residuals, in standard deviations, of rates that are in degrees: the noise given may be twice too large. For
/// rates that are not in degrees it is 57 times too large.
const LEAST_NOISE: f64 = 0.25;

/// Result of a search: the times of the first and the last measurement, how it ended, and the number of first guesses that
/// lead to another launch which fits equally well.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) times: [f64; 2],
    pub(super) progress: Progress,
    pub(super) alternatives: usize,
}

impl<F: Real> Fit<'_, F> {
    /// Cause of residuals that are too large, if it can be determined. The best launch is overwritten.
    ///
    /// * `chi_squared`: sum of squares of the best launch
    #[inline(never)] // it is called for a bad fit only
    pub(super) fn cause<I>(&mut self, measurements: &I, chi_squared: f64) -> Result<Option<Reason>, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        Ok(if self.fits_in_degrees(measurements, chi_squared)? {
            Some(Reason::RatesInDegrees)
        } else {
            self.is_at_rest(measurements.clone()).then_some(Reason::AtRest)
        })
    }

    /// Whether the measurements fit much better when the rates are read as degrees per unit time. Residuals far below the
    /// noise do not count: smaller numbers have smaller residuals, whatever the motion is.
    fn fits_in_degrees<I>(&mut self, measurements: &I, chi_squared: f64) -> Result<bool, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.rate_unit = Some(core::f64::consts::PI / 180.0);
        let degrees = self.search(measurements);
        self.rate_unit = None;
        let converged = self.reason(degrees?.progress).is_none();
        let Statistics { chi_squared: in_degrees, used, .. } = self.best.statistics;
        let has_noise = in_degrees > LEAST_NOISE * f64::from(used);
        Ok(has_noise && (converged || in_degrees < 0.1 * chi_squared))
    }

    /// Launch from the measurements in the unit that is tried, without a first guess.
    #[inline(never)] // two copies of it would take more stack
    pub(super) fn search<I>(&mut self, measurements: &I) -> Result<Found, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let (times, total) = self.checked(measurements)?;
        let [epoch, _] = times;
        self.start(None);
        if measurements_after(measurements, epoch) < 2 {
            return Ok(Found { times, progress: Progress::TooFew, alternatives: 0 });
        }
        let beginning = Beginning::of(self, measurements, epoch);
        let Some(beginning) = &beginning else {
            return Ok(Found { times, progress: Progress::NoBeginning, alternatives: 0 });
        };
        let mut count = 4 * FIRST_WINDOW * self.sensors.len();
        let alternatives = self.try_guesses(beginning, measurements, count);
        // each window begins from a launch that is good enough for it
        while count.saturating_mul(8) < total {
            count = count.saturating_mul(4);
            self.settle(measurements, Part { count, thinning: count / THINNED }, NEAR);
        }
        // a shorter window does not show how far the equations are linear over all measurements
        self.curvature = f64::INFINITY;
        if total / LAST_THINNED > 1 {
            self.settle(measurements, Part { count: total, thinning: total / LAST_THINNED }, NEAR);
        }
        let progress = self.settle_finally(measurements);
        Ok(Found { times, progress, alternatives })
    }

    /// Finds the best of the guesses on short windows, where no phase can have an error of a turn. Returns the number
    /// of those that lead to another launch which fits equally well.
    #[inline(never)] // its frame is on the stack only during the call
    fn try_guesses<I>(&mut self, beginning: &Beginning, measurements: &I, count: usize) -> usize
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut best = (f64::INFINITY, 0);
        for number in 0..beginning.count() {
            self.try_guess(beginning, number, measurements, count);
            if self.best.cost < best.0 {
                best = (self.best.cost, number);
            }
        }
        if beginning.is_ambiguous() { self.count_others(beginning, best, measurements, count) } else { 0 }
    }

    /// Begins from a guess, on a quarter of the first `count` measurements and then on all of these.
    fn try_guess<I>(&mut self, beginning: &Beginning, number: u32, measurements: &I, count: usize)
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.start(Some((beginning, number)));
        self.settle(measurements, Part::first(count / 4), NEAR);
        self.settle(measurements, Part::first(count), SETTLED);
    }

    /// Number of other guesses that lead to another launch and fit as well as the best guess, whose cost and number are
    /// given. The best launch is then that of the best guess.
    #[inline(never)] // a second launch is on the stack for ambiguous measurements only
    fn count_others<I>(
        &mut self,
        beginning: &Beginning,
        (least, best): (f64, u32),
        measurements: &I,
        count: usize,
    ) -> usize
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.try_guess(beginning, best, measurements, count);
        let best = self.best.launch;
        let mut others = 0;
        for number in 0..beginning.count() {
            self.start(Some((beginning, number)));
            self.settle(measurements, Part::first(count), SETTLED);
            let other = &self.best;
            if other.cost < least + 9.0 && other.launch.distance(&best) > 0.3 {
                others += 1;
            }
        }
        self.best.launch = best;
        others
    }

    /// Times of the first and the last measurement, and the number of measurements. Every measurement is checked.
    #[inline(never)] // its copy of the iterator is on the stack only during the call
    pub(super) fn checked<I>(&self, measurements: &I) -> Result<([f64; 2], usize), FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut total = 0;
        let mut last: Option<f64> = None;
        let mut first = None;
        for (index, measurement) in measurements.clone().enumerate() {
            let Measurement { time, sensor, values } = measurement;
            if !is_finite(time) || values.iter().any(|x| !is_finite(*x)) {
                return Err(FitError::NotFinite { index });
            }
            // most times equal that of the measurement before, and bits are compared faster than numbers
            if last.is_some_and(|last| time.to_bits() != last.to_bits() && time < last) {
                return Err(FitError::OutOfOrder { index });
            }
            if sensor >= self.sensors.len() {
                return Err(FitError::UnknownSensor { index });
            }
            last = Some(time);
            first = first.or(last);
            total = index + 1;
        }
        first.zip(last).map(|(first, last)| ([first, last], total)).ok_or(FitError::NoMeasurements)
    }

    pub(super) fn has_rates(&self, measurements: impl Iterator<Item = Measurement>) -> bool {
        measurements.take(64).any(|measurement| matches!(self.hint(&measurement), Hint::Rate { .. }))
    }

    /// Hint of a measurement, in the unit that is tried.
    pub(super) fn hint(&self, measurement: &Measurement) -> Hint {
        let hint = |values: &[f64; 4]| {
            self.sensors.get(measurement.sensor).map_or(Hint::None, |sensor| sensor.hint(values))
        };
        match (hint(&measurement.values), self.rate_unit) {
            (Hint::Rate { .. }, Some(unit)) => hint(&measurement.values.map(|x| x * unit)),
            (other, _) => other,
        }
    }

    /// Whether all components of all rates are below 0.1 per unit time, which a bias may explain.
    fn is_at_rest(&self, mut measurements: impl Iterator<Item = Measurement>) -> bool {
        measurements.all(|measurement| match self.hint(&measurement) {
            Hint::Rate { omega, axial_is_saturated } => {
                !axial_is_saturated && omega.iter().all(|x| libm::fabs(*x) < 0.1)
            }
            _ => true,
        })
    }
}

/// Whether a number is finite, by its bits: a chip without a unit for `f64` compares numbers by library calls.
fn is_finite(x: f64) -> bool {
    const EXPONENT: u32 = 0x7ff << 20;
    (x.to_bits() >> 32) as u32 & EXPONENT != EXPONENT
}

/// Number of measurements after a time; 2 stands for two or more.
#[inline(never)] // its copy of the iterator is on the stack only during the call
fn measurements_after<I>(measurements: &I, epoch: f64) -> usize
where
    I: Iterator<Item = Measurement> + Clone,
{
    measurements.clone().filter(|measurement| measurement.time > epoch).take(2).count()
}

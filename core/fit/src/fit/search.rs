//! Search for a launch without a first guess, on longer and longer parts of the measurements.

use crate::estimate::Estimate;
use crate::fit::error::{FitError, FitWarning};
use crate::fit::first_guess::{FIRST_INSTANTS, Guesses, rotation_from_vertical};
use crate::fit::marquardt::CONVERGED_SIGMA;
use crate::fit::pass::{Fit, Pass};
use crate::fit::statistics::Statistics;
use crate::sensors::{Hint, Measurement, Measurements};
use crate::vector::{Vector, cross, dot, scaled};
use toytop::scalar::Real;
use toytop::su2::Orientation;

/// Largest last correction of a part of the measurements, in standard deviations.
const PARTIAL_STEP_SIGMA: f64 = 0.5;
/// Largest difference of the sums of squares of two launches that fit equally well.
const EQUAL_COST: f64 = 9.0;
/// Least distance of two launches that are not the same, in standard deviations.
const OTHER_LAUNCH_SIGMA: f64 = 10.0;
/// Least mean square of residuals of rates in degrees: the noise given may be twice too large.
const LEAST_NOISE: f64 = 0.25;
/// Least quotient of a rate beyond the range and a reading at its end. Bias and mounting may shift the reading.
const RANGE_FRACTION: f64 = 0.9;
/// Largest sine of the tilt, and largest share of ω across the axis, of a launch that is compared with an upright one.
const UPRIGHT_SINE: f64 = 0.1;
/// Largest difference of sums of squares that chance explains: twice that of the best of a hundred spins, about 20.
const CHANCE_COST: f64 = 40.0;

/// Times of the first and the last measurement, and the number of measurements.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    pub(super) first: f64,
    pub(super) last: f64,
    total: usize,
}

impl<F: Real> Fit<'_, F> {
    /// Estimate without a first guess. Returns the reason why it must not be trusted, and the number of other launches that fit as well.
    #[inline(never)] // stack
    pub(super) fn search(
        &mut self,
        measurements: &impl Measurements,
        extent: &Extent,
    ) -> (Option<FitWarning>, usize) {
        self.start_from(&Estimate::new(Orientation::IDENTITY, [0.0; 3]));
        if measurements.clone().filter(|one| one.time > extent.first).take(2).count() < 2 {
            return (Some(FitWarning::TooFew), 0);
        }
        let Some(guesses) = self.guesses(measurements, extent.first) else {
            return (Some(FitWarning::NoBeginning), 0);
        };
        // the first part that is fitted is four times as long as that of the guess
        let mut count = 4 * FIRST_INSTANTS * self.sensors.len();
        let other_launch_count = self.try_guesses(&guesses, measurements, count);
        // each part begins from an estimate that is good enough for it
        while count.saturating_mul(8) < extent.total {
            count = count.saturating_mul(4);
            self.settle(measurements, count, PARTIAL_STEP_SIGMA);
        }
        // a shorter part does not show how far the equations are linear over all measurements
        self.curvature = f64::INFINITY;
        (self.settle_finally(measurements), other_launch_count)
    }

    /// Begins from the best of the guesses, on the first measurements, where no phase can have an error of a turn. Returns the number
    /// of other launches that fit as well.
    #[inline(never)] // stack
    fn try_guesses(&mut self, guesses: &Guesses, measurements: &impl Measurements, count: usize) -> usize {
        let mut best = (Estimate::new(Orientation::IDENTITY, [0.0; 3]), f64::INFINITY);
        let mut others = 0;
        for number in 0..guesses.count() {
            self.start_from(&guesses.get(number));
            self.settle(measurements, count / 4, PARTIAL_STEP_SIGMA);
            self.settle(measurements, count, CONVERGED_SIGMA);
            let Pass { estimate, information, statistics: Statistics { cost, .. } } = &self.best;
            let change = estimate.change_from(&best.0).map(F::from_f64);
            if *cost < best.1 - EQUAL_COST {
                others = 0;
            } else if *cost < best.1 + EQUAL_COST
                && information.square(&change).to_f64() > OTHER_LAUNCH_SIGMA * OTHER_LAUNCH_SIGMA
            {
                others += 1;
            }
            if *cost < best.1 {
                best = (*estimate, *cost);
            }
        }
        if guesses.count() > 1 {
            self.start_from(&best.0);
        }
        others
    }

    /// Passes over all measurements. Returns the reason why the estimate must not be trusted.
    pub(super) fn settle_finally(&mut self, measurements: &impl Measurements) -> Option<FitWarning> {
        let settled = self.settle(measurements, usize::MAX, CONVERGED_SIGMA);
        let launch = &self.best.estimate;
        let found = dot(launch.omega, launch.orientation.axis());
        let bound = |([_, _, low], saturated): (Vector<f64>, bool)| (saturated && low != 0.0).then_some(low);
        let least = self.rates(measurements).find_map(bound);
        // the axial rate is constant, so that one reading at the end of the range bounds it
        let spin = least.filter(|least| found / least < RANGE_FRACTION).unwrap_or(found);
        let warning = self.warning(settled && spin == found);
        let misfit =
            matches!(warning, Some(FitWarning::AllSaturated | FitWarning::TooFew | FitWarning::Misfit));
        let unknown = self.is_explained_upright(spin, measurements);
        if unknown && !misfit { Some(FitWarning::SpinUnknown) } else { warning }
    }

    /// Whether an upright launch with twice this spin explains the measurements equally well. They do not determine the spin then.
    ///
    /// An upright top with a saturated gyroscope fits any spin.
    #[inline(never)] // stack
    fn is_explained_upright(&mut self, spin: f64, measurements: &impl Measurements) -> bool {
        let found = self.best.estimate;
        let axis = found.orientation.axis();
        let across = cross(found.omega, axis);
        let [x, y, z] = axis;
        let near = UPRIGHT_SINE * UPRIGHT_SINE;
        if x * x + y * y > near || dot(across, across) > near * dot(found.omega, found.omega) {
            return false;
        }
        let sign = libm::copysign(1.0, z);
        let orientation = rotation_from_vertical(scaled(axis, sign)).inverse().compose(&found.orientation);
        self.current.estimate = Estimate { orientation, omega: [0.0, 0.0, sign * 2.0 * spin], ..found };
        self.pass(measurements, usize::MAX);
        // only the biases are corrected; the launch is held fixed
        for index in 0..self.model.count {
            let deviation = if index < self.model.motion_count { 1e-9 } else { 1e6 };
            self.current.information.add_prior(index, F::from_f64(deviation));
        }
        let change = self.current.information.solution();
        self.current.estimate = self.current.estimate.moved(&change.map(F::to_f64));
        self.pass(measurements, usize::MAX);
        self.current.statistics.cost <= self.best.statistics.cost + CHANCE_COST
    }

    /// Cause of residuals that are too large. The best estimate is overwritten.
    #[inline(never)] // stack
    pub(super) fn misfit_cause(
        &mut self,
        measurements: &impl Measurements,
        extent: &Extent,
        chi_squared: f64,
    ) -> Option<FitWarning> {
        self.rate_unit = core::f64::consts::PI / 180.0;
        let (warning, _) = self.search(measurements, extent);
        self.rate_unit = 1.0;
        // smaller numbers have smaller residuals, whatever the motion is
        let in_degrees = self.best.statistics.chi_squared;
        let has_noise = in_degrees > LEAST_NOISE * f64::from(self.best.statistics.used);
        if has_noise && (warning.is_none() || in_degrees < 0.1 * chi_squared) {
            return Some(FitWarning::RatesInDegrees);
        }
        let mut rates = self.rates(measurements);
        // below 0.1 per unit time, a bias may explain the rates
        let is_small = |(omega, saturated): (Vector<f64>, bool)| {
            !saturated && omega.iter().all(|x| libm::fabs(*x) < 0.1)
        };
        (rates.next().is_some_and(is_small) && rates.all(is_small)).then_some(FitWarning::AtRest)
    }

    /// Rates in the body frame, and whether their axial component is beyond the range.
    fn rates(&self, measurements: &impl Measurements) -> impl Iterator<Item = (Vector<f64>, bool)> {
        measurements.clone().filter_map(|measurement| match self.hint(&measurement) {
            Hint::Rate { omega, axial_is_saturated } => Some((omega, axial_is_saturated)),
            _ => None,
        })
    }

    /// Extent of the measurements. Each of them is checked.
    #[inline(never)] // stack
    pub(super) fn checked(&self, measurements: &impl Measurements) -> Result<Extent, FitError> {
        let mut extent: Option<Extent> = None;
        for (index, Measurement { time, sensor, values }) in measurements.clone().enumerate() {
            if !time.is_finite() || values.iter().any(|x| !x.is_finite()) {
                return Err(FitError::NotFinite { index });
            }
            let extent = extent.get_or_insert(Extent { first: time, last: time, total: 0 });
            if time < extent.last {
                return Err(FitError::OutOfOrder { index });
            }
            if sensor >= self.sensors.len() {
                return Err(FitError::UnknownSensor { index });
            }
            (extent.last, extent.total) = (time, index + 1);
        }
        extent.ok_or(FitError::NoMeasurements)
    }
}

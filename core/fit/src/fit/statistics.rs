//! Statistics of the residuals of a fit.

use crate::fit::limits::{FEW_OUTLIERS, GROSS_SIGMA, GROSS_WEIGHT, MAX_PRIOR, MISFIT_SIGMA, OUTLIER_PART};
use toytop::scalar::Real;

/// Residuals of a fit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Number of components that were used.
    pub used: u32,
    /// Number of components that are not used, because they are at the end of their range.
    pub unused: u32,
    /// Number of components whose weight was reduced.
    pub outliers: u32,
    /// Sum of the squares of all residuals in standard deviations; the residual of an outlier counts as the limit.
    pub chi_squared: f64,
    /// Largest residual in standard deviations.
    pub largest: f64,
    /// Sum of the squares of the differences from prior values, such as the biases, in standard deviations.
    pub prior_squares: f64,
    /// Sum of squares in which an outlier counts linearly; infinite where the motion cannot be followed.
    pub(super) cost: f64,
    /// Number of outliers, in which one beyond ten standard deviations counts as four.
    weighted_outliers: u32,
    /// Largest residual of a component that is no outlier.
    huber: f64,
    /// Whether the readings of one of the sensors contradict the motion.
    contradicted: bool,
}

impl Statistics {
    /// Statistics without residuals.
    pub(super) fn new(huber: f64, prior_squares: f64) -> Self {
        Self { huber, prior_squares, cost: prior_squares, ..Self::default() }
    }

    /// Adds a residual in standard deviations; returns the square root of its weight.
    pub(super) fn add<F: Real>(&mut self, residual: F) -> F {
        let size = residual.abs();
        let huber = F::from_f64(self.huber);
        let limited = if size > huber { huber } else { size };
        self.used += 1;
        // an addition of many numbers in `f32` would lose their digits
        self.chi_squared += limited.squared().to_f64();
        self.cost += (limited * (size.doubled() - limited)).to_f64();
        self.largest = self.largest.max(size.to_f64());
        if size <= huber {
            return F::ONE;
        }
        self.outliers += 1;
        self.weighted_outliers += if size > F::from_f64(GROSS_SIGMA) { GROSS_WEIGHT } else { 1 };
        (huber / size).sqrt()
    }

    /// Adds the statistics of a sensor.
    pub(super) fn add_sensor(&mut self, sensor: &Self) {
        self.contradicted |= sensor.is_misfit(0);
        self.used += sensor.used;
        self.unused += sensor.unused;
        self.outliers += sensor.outliers;
        self.weighted_outliers += sensor.weighted_outliers;
        self.chi_squared += sensor.chi_squared;
        self.cost += sensor.cost;
        self.largest = self.largest.max(sensor.largest);
    }

    /// Sum of squares over the number of degrees of freedom, observations minus unknowns: about 1 where model and noise
    /// are right.
    #[must_use]
    pub fn reduced_chi_squared(&self, unknowns: usize) -> f64 {
        let freedom = f64::from(self.used) - unknowns as f64;
        self.chi_squared / freedom.max(1.0)
    }

    /// Whether the residuals contradict the noise, by the rules of the [check](crate::partials#check).
    pub(super) fn is_misfit(&self, unknowns: usize) -> bool {
        let outliers = f64::from(self.outliers);
        let limited = if self.outliers > 0 { self.huber * self.huber * outliers } else { 0.0 };
        let freedom = (f64::from(self.used) - outliers - unknowns as f64).max(1.0);
        self.contradicted
            || self.prior_squares > MAX_PRIOR
            || self.weighted_outliers > self.used / OUTLIER_PART + FEW_OUTLIERS
            || self.chi_squared - limited > freedom + MISFIT_SIGMA * libm::sqrt(2.0 * freedom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_twentieth_of_gross_errors_is_as_bad_as_a_fifth_of_outliers() {
        let is_misfit = |outliers: u32, size: f64| {
            let mut statistics = Statistics::new(3.0, 0.0);
            for index in 0..100 {
                statistics.add(if index < outliers { size } else { 1.0 });
            }
            statistics.is_misfit(0)
        };
        assert_eq!([23, 24].map(|count| is_misfit(count, 5.0)), [false, true]);
        assert_eq!([5, 6].map(|count| is_misfit(count, 20.0)), [false, true]);
    }
}

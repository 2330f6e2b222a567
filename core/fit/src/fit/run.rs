//! Fit without a first guess, and from one.

use crate::fit::fitted::{FitError, Fitted, Reason};
use crate::fit::pass::Fit;
use crate::model::{Estimate, FreeRatio, Model};
use crate::sensors::{Measurement, Sensor};
use toytop::Top;
use toytop::scalar::Real;

impl<'a, F: Real> Fit<'a, F> {
    /// Fit of a launch of this top by these sensors.
    ///
    /// * `ratios`: unknown ratios of the top, at most four
    ///
    /// # Errors
    /// [`FitError::TooManyUnknowns`]: more than four sensors or ratios.
    pub fn new(top: &Top, sensors: &'a [&'a dyn Sensor<F>], ratios: &[FreeRatio]) -> Result<Self, FitError> {
        let model = Model::new(top, sensors, ratios, None).ok_or(FitError::TooManyUnknowns)?;
        Ok(Self::with_model(sensors, model))
    }

    /// Sets the residual, in standard deviations, from which an observation counts linearly instead of quadratically
    /// (Huber); infinite for least squares. The default is 3.
    #[must_use]
    pub fn with_huber(mut self, residual: f64) -> Self {
        self.huber = residual;
        self
    }

    /// Adds three losses of rotation to the unknowns: about the axis, across it and about the vertical. At most one ratio may then
    /// be free.
    ///
    /// * `deviation`: standard deviation of each loss before the fit, as a share of the rotation per unit time: 1/60 where the spin may
    ///   be lost in a minute
    ///
    /// # Errors
    /// [`FitError::TooManyUnknowns`]: more than one free ratio. [`FitError::DriftDeviation`]: not a positive number.
    pub fn with_drift(self, deviation: f64) -> Result<Self, FitError> {
        if !(deviation.is_finite() && deviation > 0.0) {
            return Err(FitError::DriftDeviation);
        }
        let model = Model::new(&self.model.top, self.sensors, self.model.free(), Some(deviation));
        let model = model.ok_or(FitError::TooManyUnknowns)?;
        Ok(Self::with_model(self.sensors, model).with_huber(self.huber))
    }

    /// Launch from all measurements, without a first guess. The measurements are read several times.
    ///
    /// # Errors
    /// [`FitError`]: no measurement, or one that is not finite, not in order, or of an unknown sensor.
    pub fn run<I>(&mut self, measurements: I) -> Result<Fitted, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let extent = self.checked(&measurements)?;
        let (reason, alternatives) = self.search(&measurements, &extent);
        let mut fitted = self.fitted(&extent, reason, alternatives);
        if matches!(fitted.reason, Some(Reason::Misfit | Reason::NotSettled)) {
            let cause = self.cause(&measurements, &extent, fitted.statistics.chi_squared);
            fitted.reason = cause.or(fitted.reason);
        }
        Ok(fitted)
    }

    /// Launch from all measurements, from a first guess at the time of the first measurement.
    ///
    /// # Errors
    /// The errors of [`Fit::run`].
    pub fn run_from<I>(&mut self, guess: Estimate, measurements: I) -> Result<Fitted, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let extent = self.checked(&measurements)?;
        self.start_from(&guess);
        let reason = self.settle_finally(&measurements);
        Ok(self.fitted(&extent, reason, 0))
    }
}

//! Fit: the launch of a top from measurements, with its covariance.
//!
//! A pass reads one measurement after another and stores none of them; its result is a triangular matrix (`triangle`).
//! After a pass the launch is corrected by the method of Levenberg and Marquardt, and the next pass begins. The derivation
//! of the derivatives is in `docs/partials.md`.

// In the order of dependence.
mod triangle;

mod singular;

mod sensor;

mod instruments;

mod launch;

mod covariance;

mod drift;

mod outcome;

mod node;

mod period;

mod place;

mod path;

mod rows;

mod model;

mod window;

mod sums;

mod knowledge;

mod beginning;

mod pass;

mod correction;

mod ending;

mod upright;

mod search;

mod result;

mod tracking;

pub use covariance::Covariance;
pub use drift::Drift;
pub use instruments::{
    Accelerometer, AxisCamera, Gyroscope, Magnetometer, Mark, OrientationCamera, TipCamera,
};
pub use launch::{FreeRatio, Launch};
pub use outcome::{FitError, Fitted, Reason, Statistics, Unobservable};
pub use sensor::{Hint, Measurement, Mounting, Noise, Prediction, Sensor};
pub use tracking::Tracked;
pub use triangle::MOST_UNKNOWNS;

use crate::fit::model::Model;
use crate::fit::pass::Pass;
use crate::fit::path::Path;
use crate::fit::rows::Rows;
use crate::fit::search::Found;
use crate::fit::tracking::Prior;
use crate::scalar::Real;
use crate::top::Top;

/// Largest number of sensors.
pub const MOST_SENSORS: usize = 4;
/// Largest number of ratios that are unknowns.
pub const MOST_RATIOS: usize = 4;
/// Fit of a launch to measurements.
///
/// The unknowns are the launch, the ratios that are free, and a constant bias of each component of the sensors that
/// have one. The measurements are compared with the motion in the scalar `F`: `f32` suffices for sensors whose noise is
/// at least 1e-4 of their readings. The state of the fit then takes less than 16 KiB; it does not grow with the
/// measurements.
#[derive(Clone)]
pub struct Fit<'a, F = f64> {
    sensors: &'a [&'a dyn Sensor<F>],
    model: Model,
    /// Residual, in standard deviations, from which an observation counts linearly instead of quadratically.
    huber: f64,
    /// Best launch so far, with the information and the sum of squares of its pass.
    best: Pass<F>,
    /// Launch of the current pass.
    current: Pass<F>,
    /// Marquardt's damping.
    damping: f64,
    /// Size of the last correction from the same measurements, in standard deviations.
    last_change: Option<f64>,
    /// Size of a correction over the square of the size of the one before it.
    curvature: f64,
    path: Path<F>,
    rows: Rows<F>,
    /// Derivatives of the ratios with respect to the unknowns.
    shares: [[F; 4]; MOST_RATIOS],
    /// Biases of the launch of the pass, in the scalar of the measurements.
    biases: [F; 3 * MOST_SENSORS],
    /// Time of the launch: that of the first measurement of the pass.
    epoch: Option<f64>,
    /// Time to which the path was moved: that of the last measurement.
    now: Option<f64>,
    /// Factor by which the readings of rate gyroscopes are multiplied, to try another unit where the fit is bad.
    rate_unit: Option<f64>,
    prior: Option<Prior<F>>,
}

impl<'a, F: Real> Fit<'a, F> {
    /// Fit of a launch of this top by these sensors.
    ///
    /// * `ratios`: unknown ratios of the top, at most four
    ///
    /// # Errors
    /// [`FitError::TooManyUnknowns`]: more than four sensors or ratios.
    pub fn new(top: &Top, sensors: &'a [&'a dyn Sensor<F>], ratios: &[FreeRatio]) -> Result<Self, FitError> {
        if sensors.len() > MOST_SENSORS || ratios.len() > MOST_RATIOS {
            return Err(FitError::TooManyUnknowns);
        }
        Ok(Self::of(sensors, Model::new(top, sensors, ratios)))
    }

    /// Fit of these unknowns.
    fn of(sensors: &'a [&'a dyn Sensor<F>], model: Model) -> Self {
        let pass = Pass::new(Launch::default(), model.count);
        Self {
            sensors,
            model,
            huber: 3.0,
            best: pass,
            current: pass,
            damping: pass::FIRST_DAMPING,
            last_change: None,
            curvature: f64::INFINITY,
            path: model.path(),
            rows: Rows::new(model.common()),
            shares: model.shares(&pass.launch),
            biases: [F::ZERO; 3 * MOST_SENSORS],
            epoch: None,
            now: None,
            rate_unit: None,
            prior: None,
        }
    }

    /// Sets the residual, in standard deviations, from which an observation counts linearly instead of quadratically
    /// (Huber); infinite for least squares. The default is 3.
    #[must_use]
    pub fn with_huber(mut self, residual: f64) -> Self {
        self.huber = residual;
        self
    }

    /// Adds a drift of the first integrals to the unknowns: three losses of rotation, about the axis, across it and about
    /// the vertical. At most one ratio may then be free.
    ///
    /// * `deviation`: standard deviation of each loss before the fit, in units of the rotation itself per unit time:
    ///   1/60 where the spin may be lost in a minute
    ///
    /// # Errors
    /// [`FitError::TooManyUnknowns`]: more than one free ratio. [`FitError::DriftDeviation`]: not a positive number.
    pub fn with_drift(self, deviation: f64) -> Result<Self, FitError> {
        if !(deviation.is_finite() && deviation > 0.0) {
            return Err(FitError::DriftDeviation);
        }
        let model = self.model.with_losses(deviation).ok_or(FitError::TooManyUnknowns)?;
        Ok(Self::of(self.sensors, model).with_huber(self.huber))
    }

    /// Launch from all measurements, without a first guess. The launch is the state at the time of the first
    /// measurement; with a drift, it is the state at the time of the last one. The measurements are read several times.
    ///
    /// # Errors
    /// [`FitError`]: a measurement that is not finite, that is earlier than its predecessor, or of a sensor that is not
    /// in the list; no measurement at all.
    pub fn run<I>(&mut self, measurements: I) -> Result<Fitted, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let found = self.search(&measurements)?;
        let mut fitted = self.fitted(&found);
        if matches!(fitted.reason, Some(Reason::Misfit | Reason::NotSettled))
            && self.has_rates(measurements.clone())
        {
            let cause = self.cause(&measurements, fitted.statistics.chi_squared)?;
            fitted.reason = cause.or(fitted.reason);
        }
        Ok(fitted)
    }

    /// Launch from all measurements, from a first guess at the time of the first measurement.
    ///
    /// # Errors
    /// The errors of [`Fit::run`].
    pub fn run_from<I>(&mut self, guess: Launch, measurements: I) -> Result<Fitted, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let (times, _) = self.checked(&measurements)?;
        self.start_from(&guess);
        let progress = self.settle_finally(&measurements);
        Ok(self.fitted(&Found { times, progress, alternatives: 0 }))
    }
}

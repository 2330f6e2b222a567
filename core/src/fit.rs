//! Fit: the launch of a top from measurements, with its covariance.
//!
//! A pass reads one measurement after another and
//! stores none of them; its result is a triangular matrix (`triangle`). After a pass the launch is corrected by the
//! method of Levenberg and Marquardt, and the next pass begins. The derivation of the derivatives is in
//! `docs/partials.md`.

// In the order of dependence.
mod triangle;

mod sensor;

mod instruments;

mod launch;

mod outcome;

mod node;

mod path;

mod rows;

mod model;

mod window;

mod pass;

mod beginning;

mod upright;

mod tracking;

mod carrying;

mod drift;

pub use drift::Drift;
pub use instruments::{
    Accelerometer, AxisCamera, Gyroscope, Magnetometer, Mark, OrientationCamera, TipCamera,
};
pub use launch::{FreeRatio, Launch};
pub use outcome::{FitError, Fitted, Reason, Statistics, Unobservable};
pub use sensor::{Hint, Measurement, Mounting, Noise, Prediction, Sensor};
pub use tracking::Tracked;
pub use triangle::{MOST_UNKNOWNS, Symmetric};

use crate::fit::beginning::Beginning;
use crate::fit::model::Model;
use crate::fit::pass::{Pass, Progress, SETTLED};
use crate::fit::path::Path;
use crate::fit::rows::Rows;
use crate::fit::tracking::Prior;
use crate::fit::window::Part;
use crate::scalar::Real;
use crate::top::Top;

/// Largest number of sensors.
pub const MOST_SENSORS: usize = 4;
/// Largest number of ratios that are unknowns.
pub const MOST_RATIOS: usize = 4;
/// Number of instants in the first window; the others are each four times as long.
const FIRST_WINDOW: usize = 16;
/// Size of a correction, in standard deviations, with which a window is done.
const NEAR: f64 = 0.5;
/// Number of measurements to which the windows after the first two are thinned.
const THINNED: usize = 192;
/// Number of measurements to which all of them are thinned before the last passes. The launch is then within some standard
/// deviations of the best one, and one pass over all measurements corrects it.
const LAST_THINNED: usize = 512;
/// Fit of a launch to measurements.
///
/// The unknowns are the launch, the ratios that are free, and a constant bias of each component of the sensors that
/// have one. The measurements are compared with the motion in the scalar `F`: `f32` suffices for sensors whose noise is
/// 1e-4 or more of what they read. The state of the fit then takes less than 16 KiB; it does not grow with the
/// measurements.
#[derive(Clone)]
pub struct Fit<'a, F = f64> {
    sensors: &'a [&'a dyn Sensor<F>],
    model: Model,
    /// Residual, in standard deviations, from which an observation counts linearly instead of quadratically.
    huber: f64,
    /// Best launch so far, with the information and the sum of squares of its pass.
    best: Pass<F>,
    /// Launch of the pass that is under way.
    current: Pass<F>,
    /// Marquardt's damping.
    damping: f64,
    /// Size of the last correction from the same measurements, in standard deviations.
    last_change: Option<f64>,
    /// Size of a correction over the square of the size of the one before it.
    curvature: f64,
    path: Path<F>,
    rows: Rows<F>,
    /// Derivatives of the ratios by the unknowns.
    shares: [[F; 4]; MOST_RATIOS],
    /// Biases of the launch of the pass, in the scalar of the measurements.
    biases: [F; 3 * MOST_SENSORS],
    /// Time of the launch: that of the first measurement of the pass.
    epoch: Option<f64>,
    /// Time to which the path was moved: that of the last measurement.
    now: Option<f64>,
    /// Factor of the readings of rate gyroscopes: another unit that is tried where the fit is bad.
    rate_unit: Option<f64>,
    prior: Option<Prior<F>>,
}

/// Result of a search: the times of the first and the last measurement, how it ended, and the number of other launches that fit as well.
#[derive(Clone, Copy, Debug)]
struct Found {
    times: [f64; 2],
    progress: Progress,
    alternatives: usize,
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
            damping: 1e-3,
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
    /// (Huber); infinite for least squares. It is 3 at first.
    #[must_use]
    pub fn with_huber(mut self, residual: f64) -> Self {
        self.huber = residual;
        self
    }

    /// Adds a drift of the first integrals to the unknowns: three losses of rotation, about the axis, across it and about
    /// the vertical. There may be one free ratio then.
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
    /// measurement; with a drift, at that of the last one. The measurements are read several times.
    ///
    /// # Errors
    /// [`FitError`]: a measurement that is not finite, that is earlier than the one before, or of a sensor that is not
    /// in the list; no measurement at all.
    pub fn run<I>(&mut self, measurements: I) -> Result<Fitted, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let found = self.search(&measurements)?;
        let mut reason = self.reason(found.progress);
        if matches!(reason, Some(Reason::Misfit | Reason::NotSettled)) && self.has_rates(measurements.clone())
        {
            reason = self.cause(&measurements)?.or(reason);
        }
        let unobservable = self.unobservable();
        Ok(self.fitted(found.times, reason, found.alternatives, unobservable))
    }

    /// Cause of residuals that are too large, if it can be determined. The best launch stays.
    #[inline(never)] // the copy of a pass is on the stack while it works only
    fn cause<I>(&mut self, measurements: &I) -> Result<Option<Reason>, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let best = self.best;
        let cause = if self.fits_in_degrees(measurements, best.statistics.chi_squared)? {
            Some(Reason::RatesInDegrees)
        } else {
            self.is_at_rest(measurements.clone()).then_some(Reason::AtRest)
        };
        self.best = best;
        Ok(cause)
    }

    /// Launch from all measurements, from a first guess at the time of the first measurement.
    ///
    /// # Errors
    /// As [`Fit::run`].
    pub fn run_from<I>(&mut self, guess: Launch, measurements: I) -> Result<Fitted, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let (times, _) = self.checked(&measurements)?;
        self.start(&guess);
        let progress = self.settle_finally(&measurements);
        let unobservable = self.unobservable();
        Ok(self.fitted(times, self.reason(progress), 0, unobservable))
    }

    /// Whether the measurements fit better by far when the rates are read as degrees per unit time.
    fn fits_in_degrees<I>(&mut self, measurements: &I, chi_squared: f64) -> Result<bool, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        self.rate_unit = Some(core::f64::consts::PI / 180.0);
        let degrees = self.search(measurements);
        self.rate_unit = None;
        let converged = self.reason(degrees?.progress).is_none();
        Ok(converged || self.best.statistics.chi_squared < 0.1 * chi_squared)
    }

    /// Launch from the measurements in the unit that is tried, without a first guess.
    #[inline(never)] // two copies of it would take more stack
    fn search<I>(&mut self, measurements: &I) -> Result<Found, FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let (times, total) = self.checked(measurements)?;
        let [epoch, _] = times;
        self.start(&Launch::default());
        if instants_after(measurements, epoch) < 2 {
            return Ok(Found { times, progress: Progress::TooFew, alternatives: 0 });
        }
        let beginning = Beginning::of(self, measurements);
        if beginning.is_empty() {
            return Ok(Found { times, progress: Progress::NoBeginning, alternatives: 0 });
        }
        // the best of the guesses on short windows, where no phase can be off by a turn
        let mut count = 4 * FIRST_WINDOW * self.sensors.len();
        let mut best: Option<(Launch, f64)> = None;
        let mut alternatives = 0;
        for guess in beginning.guesses() {
            self.start(&guess);
            self.settle(measurements, Part::first(count / 4), NEAR);
            self.settle(measurements, Part::first(count), SETTLED);
            let found = (self.best.launch, self.best.cost);
            if best.is_none_or(|(_, least)| found.1 < least) {
                best = Some(found);
            }
        }
        if let Some((launch, cost)) = best {
            // another guess that led to another launch and fits as well
            for guess in beginning.guesses().filter(|_| beginning.is_ambiguous()) {
                self.start(&guess);
                self.settle(measurements, Part::first(count), SETTLED);
                let other = &self.best;
                if other.cost < cost + 9.0 && other.launch.distance(&launch) > 0.3 {
                    alternatives += 1;
                }
            }
            self.best.launch = launch;
        }
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

    /// Times of the first and the last measurement, and the number of all, after a look at them.
    #[inline(never)] // its copy of the iterator is on the stack while it works only
    fn checked<I>(&self, measurements: &I) -> Result<([f64; 2], usize), FitError>
    where
        I: Iterator<Item = Measurement> + Clone,
    {
        let mut total = 0;
        let mut last: Option<f64> = None;
        let mut first = None;
        for (index, measurement) in measurements.clone().enumerate() {
            let Measurement { time, sensor, values } = measurement;
            if !time.is_finite() || values.iter().any(|x| !x.is_finite()) {
                return Err(FitError::NotFinite { index });
            }
            if last.is_some_and(|last| time < last) {
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

    fn has_rates(&self, measurements: impl Iterator<Item = Measurement>) -> bool {
        measurements.take(64).any(|measurement| matches!(self.hint(&measurement), Hint::Rate { .. }))
    }

    /// Statement of a measurement, in the unit that is tried.
    fn hint(&self, measurement: &Measurement) -> Hint {
        let hint = |values: &[f64; 4]| {
            self.sensors.get(measurement.sensor).map_or(Hint::None, |sensor| sensor.hint(values))
        };
        match (hint(&measurement.values), self.rate_unit) {
            (Hint::Rate { .. }, Some(unit)) => hint(&measurement.values.map(|x| x * unit)),
            (other, _) => other,
        }
    }

    /// Whether no rate is beyond what bias and noise explain.
    fn is_at_rest(&self, mut measurements: impl Iterator<Item = Measurement>) -> bool {
        measurements.all(|measurement| match self.hint(&measurement) {
            Hint::Rate { omega, axial_is_saturated } => {
                !axial_is_saturated && omega.iter().all(|x| libm::fabs(*x) < 0.1)
            }
            _ => true,
        })
    }
}

/// Number of measurements after a time; 2 stands for more.
#[inline(never)] // its copy of the iterator is on the stack while it works only
fn instants_after<I>(measurements: &I, epoch: f64) -> usize
where
    I: Iterator<Item = Measurement> + Clone,
{
    measurements.clone().filter(|measurement| measurement.time > epoch).take(2).count()
}

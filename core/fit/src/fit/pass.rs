//! Passes over the measurements.

use crate::course::Course;
use crate::fit::statistics::Statistics;
use crate::least_squares::{MOST_UNKNOWNS, Triangle};
use crate::model::{Estimate, MOST_SENSORS, Model};
use crate::sensors::{Hint, Measurement, Measurements, Prediction, Sensor};
use toytop::scalar::Real;
use toytop::su2::Orientation;

/// Marquardt's damping at the beginning.
pub(super) const FIRST_DAMPING: f64 = 1e-3;

/// Fit of a launch to measurements.
///
/// The unknowns are the launch, the free ratios, and the constant biases of the sensors. The scalar `f32` suffices for sensors whose noise
/// is at least 1e-4 of their readings; the fit then takes less than 8 KiB, whatever the number of measurements.
#[derive(Clone)]
pub struct Fit<'a, F = f64> {
    pub(super) sensors: &'a [&'a dyn Sensor<F>],
    pub(super) model: Model,
    /// Residual, in standard deviations, from which an observation counts linearly instead of quadratically.
    pub(super) huber: f64,
    /// Best estimate so far, with the information and the sum of squares of its pass.
    pub(super) best: Pass<F>,
    /// Estimate of the current pass.
    pub(super) current: Pass<F>,
    /// Marquardt's damping.
    pub(super) damping: f64,
    /// Size of the last correction from the same measurements, in standard deviations.
    pub(super) last_change: Option<f64>,
    /// Size of a correction over the square of the size of the one before it.
    pub(super) curvature: f64,
    course: Course<F>,
    /// Factor by which the readings of rate gyroscopes are multiplied, to try another unit where the fit is bad.
    pub(super) rate_unit: f64,
    /// Information about the launch from earlier measurements, and the estimate that it is about.
    pub(super) prior: Option<(Estimate, Triangle<F>)>,
}

/// One pass over the measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass<F> {
    pub(super) estimate: Estimate,
    pub(super) information: Triangle<F>,
    pub(super) statistics: Statistics,
    /// Sum of squares, in which an outlier counts linearly; infinite where the motion cannot be followed.
    pub(super) cost: f64,
}

impl<'a, F: Real> Fit<'a, F> {
    /// Fit of these unknowns.
    pub(super) fn with_model(sensors: &'a [&'a dyn Sensor<F>], model: Model) -> Self {
        let estimate = Estimate::new(Orientation::IDENTITY, [0.0; 3]);
        let pass = Pass {
            estimate,
            information: Triangle::new(model.count),
            statistics: Statistics::default(),
            cost: f64::INFINITY,
        };
        Self {
            sensors,
            model,
            huber: 3.0,
            best: pass,
            current: pass,
            damping: FIRST_DAMPING,
            last_change: None,
            curvature: f64::INFINITY,
            course: model.course(&estimate),
            rate_unit: 1.0,
            prior: None,
        }
    }

    /// Begins without information, from an estimate.
    #[inline(never)] // its copies are on the stack only here
    pub(super) fn start_from(&mut self, estimate: &Estimate) {
        self.best.information.clear();
        self.best.statistics = Statistics::default();
        self.best.estimate = *estimate;
        self.best.estimate.orientation = estimate.orientation.normalised();
        self.best.cost = f64::INFINITY;
        self.damping = FIRST_DAMPING;
        self.curvature = f64::INFINITY;
    }

    /// One pass over the first `count` measurements with the estimate of the current pass.
    pub(super) fn pass(&mut self, measurements: &impl Measurements, count: usize) {
        let prior = self.begin_pass();
        let mut sensors = [Statistics::new(self.huber, 0.0); MOST_SENSORS];
        let mut epoch = None;
        for measurement in measurements.clone().take(count) {
            let start = *epoch.get_or_insert(measurement.time);
            let added = self.course.move_to(measurement.time - start).and_then(|()| {
                let sensor = sensors.get_mut(measurement.sensor)?;
                self.add(&measurement, sensor)
            });
            if added.is_none() {
                self.current.cost = f64::INFINITY;
                return;
            }
        }
        let mut all = Statistics::new(self.huber, prior);
        sensors.iter().for_each(|sensor| all.add_sensor(sensor));
        (self.current.statistics, self.current.cost) = (all, all.cost);
    }

    /// Begins a pass; returns the sum of squares of the differences from the prior information.
    #[inline(never)] // its matrices are on the stack between passes only
    fn begin_pass(&mut self) -> f64 {
        let Pass { estimate, information, statistics, .. } = &mut self.current;
        information.clear();
        *statistics = Statistics::default();
        let cost = match &self.prior {
            Some((known, prior)) => {
                information.clone_from(prior);
                let change = known.change_from(estimate).map(F::from_f64);
                information.point_to(&change).to_f64()
            }
            None => self.model.add_prior(estimate, information),
        };
        self.course.begin(&estimate.orientation, estimate.omega, &self.model.equations(estimate));
        cost
    }

    /// Adds one measurement to the current pass, at the time to which the course was moved. `None` where there is no such
    /// sensor.
    #[inline(never)] // the prediction and the motion must not be on the stack together
    fn add(&mut self, measurement: &Measurement, statistics: &mut Statistics) -> Option<()> {
        let sensor = self.sensors.get(measurement.sensor)?;
        let prediction = sensor.predict(self.course.now(), &self.reading(measurement));
        let Prediction { difference, deviation, columns } = &prediction;
        let (bias, common) = (self.model.bias(measurement.sensor), self.model.common());
        let Pass { estimate, information, .. } = &mut self.current;
        for (component, (difference, deviation)) in difference.iter().zip(deviation).enumerate() {
            let per_deviation = F::ONE / *deviation;
            if per_deviation == F::ZERO {
                statistics.unused += 1;
                continue;
            }
            let bias = bias.map(|first| first + component);
            let known = bias.and_then(|bias| estimate.unknown(bias)).map_or(F::ZERO, F::from_f64);
            let residual = (*difference - known) * per_deviation;
            let weight = statistics.add(residual);
            let scale = weight * per_deviation;
            let mut row = [F::ZERO; MOST_UNKNOWNS];
            for (slot, column) in row.iter_mut().zip(columns).take(common) {
                *slot = scale * column.get(component).copied()?;
            }
            if let Some(slot) = bias.and_then(|bias| row.get_mut(bias)) {
                *slot = scale;
            }
            information.add(row, weight * residual);
        }
        Some(())
    }

    /// Values of a measurement, in the unit that is tried.
    fn reading(&self, Measurement { sensor, values, .. }: &Measurement) -> [f64; 4] {
        let unit = self.rate_unit;
        match self.sensors.get(*sensor) {
            Some(sensor) if unit != 1.0 && matches!(sensor.hint(values), Hint::Rate { .. }) => {
                values.map(|x| x * unit)
            }
            _ => *values,
        }
    }

    /// Hint of a measurement, in the unit that is tried.
    pub(super) fn hint(&self, measurement: &Measurement) -> Hint {
        let reading = self.reading(measurement);
        self.sensors.get(measurement.sensor).map_or(Hint::None, |sensor| sensor.hint(&reading))
    }
}

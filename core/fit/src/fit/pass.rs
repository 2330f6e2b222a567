//! Passes over the measurements: the rows of a least-squares problem.

use crate::estimate::Estimate;
use crate::fit::statistics::Statistics;
use crate::information::Information;
use crate::model::{MOST_SENSORS, Model};
use crate::sensitivity::{PASS, Tangent, Trajectory};
use crate::sensors::{Hint, Measurement, Measurements, Residual, Sensor};
use crate::triangle::MOST_UNKNOWNS;
use toytop::scalar::Real;

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
    /// Largest residual that counts quadratically, in standard deviations. Larger ones count linearly.
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
    trajectory: Trajectory<F>,
    /// Factor of the readings of rate gyroscopes. A bad fit tries another unit.
    pub(super) rate_unit: f64,
    /// Information before the measurements, and the estimate that it is about.
    pub(super) prior: (Estimate, Information<F>),
}

/// One pass over the measurements.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pass<F> {
    pub(super) estimate: Estimate,
    pub(super) information: Information<F>,
    pub(super) statistics: Statistics,
}

/// Trajectory of an estimate, whose columns are changes along the body axes.
fn trajectory<F: Real>(estimate: &Estimate, model: &Model) -> Trajectory<F> {
    let tangents = Tangent::along_body_axes(&estimate.orientation);
    Trajectory::new(&estimate.body_state(), tangents, &model.equations(estimate), PASS)
}

impl<'a, F: Real> Fit<'a, F> {
    /// Fit of these unknowns.
    pub(super) fn with_model(sensors: &'a [&'a dyn Sensor<F>], model: Model) -> Self {
        let prior @ (estimate, _) = model.prior();
        let pass =
            Pass { estimate, information: Information::new(model.count), statistics: Statistics::default() };
        Self {
            sensors,
            model,
            huber: 3.0,
            best: pass,
            current: pass,
            damping: FIRST_DAMPING,
            last_change: None,
            curvature: f64::INFINITY,
            trajectory: trajectory(&estimate, &model),
            rate_unit: 1.0,
            prior,
        }
    }

    /// Begins without information, from an estimate.
    #[inline(never)] // stack
    pub(super) fn start_from(&mut self, estimate: &Estimate) {
        self.best.information = Information::new(self.model.count);
        self.best.statistics = Statistics::infinite();
        self.best.estimate = *estimate;
        self.best.estimate.orientation = estimate.orientation.normalised();
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
            let added = self.trajectory.move_to(measurement.time - start).and_then(|()| {
                let sensor = sensors.get_mut(measurement.sensor)?;
                self.add(&measurement, sensor)
            });
            if added.is_none() {
                self.current.statistics.cost = f64::INFINITY;
                return;
            }
        }
        let mut all = Statistics::new(self.huber, prior);
        sensors.iter().for_each(|sensor| all.add_sensor(sensor));
        self.current.statistics = all;
    }

    /// Begins a pass; returns the sum of squares of the differences from the prior information.
    #[inline(never)] // stack
    fn begin_pass(&mut self) -> f64 {
        let Pass { estimate, information, statistics, .. } = &mut self.current;
        *statistics = Statistics::default();
        let (known, prior) = &self.prior;
        information.clone_from(prior);
        let change = known.change_from(estimate).map(F::from_f64);
        information.set_solution(&change);
        self.trajectory = trajectory(estimate, &self.model);
        prior.square(&change).to_f64()
    }

    /// Adds one measurement to the current pass, at the time of the trajectory. `None` if there is no such sensor.
    #[inline(never)] // stack
    fn add(&mut self, measurement: &Measurement, statistics: &mut Statistics) -> Option<()> {
        let sensor = self.sensors.get(measurement.sensor)?;
        let prediction = sensor.residual(&self.trajectory.now, &self.reading(measurement));
        let Residual { difference, deviation, columns } = &prediction;
        let (bias, motion_count) = (self.model.bias(measurement.sensor), self.model.motion_count);
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
            for (slot, column) in row.iter_mut().zip(columns).take(motion_count) {
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

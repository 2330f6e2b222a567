//! Pass over the measurements: the rows of a least-squares problem at one estimate.

use crate::estimate::Estimate;
use crate::fit::problem::Problem;
use crate::fit::statistics::Statistics;
use crate::information::Information;
use crate::model::{MAX_SENSORS, Model, Prior};
use crate::sensitivity::{Partials, Trajectory};
use crate::sensors::{Measurement, Measurements, Residual, Sensor};
use crate::triangle::MAX_UNKNOWNS;
use toytop::scalar::Real;

/// Estimate, and the least-squares problem of its corrections.
#[derive(Clone, Copy)]
pub(super) struct Pass<F> {
    pub(super) estimate: Estimate,
    /// Rows of the prior and of the measurements.
    pub(super) information: Information<F>,
    pub(super) statistics: Statistics,
}

impl<F: Real> Pass<F> {
    /// Reads the first `count` measurements. The sum of squares is infinite where the motion cannot be followed.
    pub(super) fn read(
        &mut self,
        problem: &Problem<F, impl Measurements>,
        count: usize,
        prior: &Prior<F>,
        trajectory: &mut Trajectory<F>,
    ) {
        let prior_squares = self.begin(problem.model, prior, trajectory);
        let mut sensors = [Statistics::new(problem.huber, 0.0); MAX_SENSORS];
        let mut epoch = None;
        for measurement in problem.measurements().take(count) {
            let start = *epoch.get_or_insert(measurement.time);
            let added = trajectory.move_to(measurement.time - start).and_then(|()| {
                let sensor = problem.sensors.get(measurement.sensor)?;
                let statistics = sensors.get_mut(measurement.sensor)?;
                self.add(*sensor, problem.model, &trajectory.now, &measurement, statistics)
            });
            if added.is_none() {
                self.statistics.cost = f64::INFINITY;
                return;
            }
        }
        let mut all = Statistics::new(problem.huber, prior_squares);
        sensors.iter().for_each(|sensor| all.add_sensor(sensor));
        self.statistics = all;
    }

    /// Sets the trajectory and the prior information; returns the sum of squares of the differences from the prior estimate.
    #[inline(never)] // stack
    fn begin(&mut self, model: &Model, prior: &Prior<F>, trajectory: &mut Trajectory<F>) -> f64 {
        let Self { estimate, information, statistics } = self;
        *statistics = Statistics::default();
        information.clone_from(&prior.information);
        let change = prior.estimate.change_from(estimate).map(F::from_f64);
        information.set_solution(&change);
        *trajectory = model.trajectory(estimate);
        prior.information.square(&change).to_f64()
    }

    /// Adds one measurement.
    #[inline(never)] // stack
    fn add(
        &mut self,
        sensor: &dyn Sensor<F>,
        model: &Model,
        at: &Partials<F>,
        measurement: &Measurement,
        statistics: &mut Statistics,
    ) -> Option<()> {
        let Residual { difference, deviation, columns } = &sensor.residual(at, &measurement.values);
        let first_bias = model.bias(measurement.sensor);
        for (component, (difference, deviation)) in difference.iter().zip(deviation).enumerate() {
            let per_deviation = F::ONE / *deviation;
            if per_deviation == F::ZERO {
                statistics.unused += 1;
                continue;
            }
            let bias = first_bias.map(|first| first + component);
            let known = bias.and_then(|bias| self.estimate.unknown(bias)).map_or(F::ZERO, F::from_f64);
            let residual = (*difference - known) * per_deviation;
            let weight = statistics.add(residual);
            let scale = weight * per_deviation;
            let mut row = [F::ZERO; MAX_UNKNOWNS];
            for (slot, column) in row.iter_mut().zip(columns).take(model.motion_count) {
                *slot = scale * column.get(component).copied()?;
            }
            if let Some(slot) = bias.and_then(|bias| row.get_mut(bias)) {
                *slot = scale;
            }
            self.information.add(row, weight * residual);
        }
        Some(())
    }
}

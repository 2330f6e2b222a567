//! State of a fit, and its passes over a part of the measurements, by the method of Levenberg and Marquardt:
//!
//! 1. The prior information and each measurement are added to the sum of squares at the estimate that is tried.
//! 2. An estimate with a lower sum becomes the best one, and the damping a tenth. Otherwise the damping is ten times as large.
//! 3. The damped sum of the best estimate gives its correction, and with it the next estimate.
//! 4. The passes end if the next correction would be small.

use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::limits::{CONVERGED, FIRST_DAMPING, MAX_PASSES, OPEN_DEVIATION, PART_CONVERGED};
use crate::fit::statistics::Statistics;
use crate::model::{MAX_SENSORS, Model, Prior};
use crate::sensitivity::{Partials, Trajectory};
use crate::sensors::{Measurement, Measurements, Residual, Sensor};
use crate::square_root::{MAX_UNKNOWNS, SquareRoot};
use toytop::scalar::Real;

/// Unknowns of a fit, and its estimates.
#[derive(Clone)]
pub(super) struct Solver<F> {
    pub(super) model: Model,
    /// Largest residual that counts quadratically, in standard deviations.
    pub(super) huber: f64,
    pub(super) prior: Prior<F>,
    /// Pass with the least sum of squares.
    pub(super) best: Pass<F>,
    /// Pass of the estimate that is tried.
    current: Pass<F>,
    trajectory: Trajectory<F>,
    /// Marquardt's damping: this fraction of each unknown's own information is added.
    damping: f64,
}

/// Estimate, and the least-squares problem of its corrections.
#[derive(Clone, Copy)]
pub(super) struct Pass<F> {
    pub(super) estimate: Estimate,
    /// Rows of the prior and of the measurements.
    pub(super) information: SquareRoot<F>,
    pub(super) statistics: Statistics,
}

impl<F: Real> Pass<F> {
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

impl<F: Real> Solver<F> {
    /// Solver for the unknowns of a model.
    pub(super) fn new(model: Model, huber: f64) -> Self {
        let prior = model.prior();
        let Prior { estimate, .. } = prior;
        let pass = Pass { estimate, information: SquareRoot::ZERO, statistics: Statistics::default() };
        Self {
            model,
            huber,
            prior,
            best: pass,
            current: pass,
            trajectory: model.trajectory(&estimate),
            damping: FIRST_DAMPING,
        }
    }

    /// Sets the information before the measurements to the prior information of the model.
    #[inline(never)] // stack
    pub(super) fn reset_prior(&mut self) {
        self.prior = self.model.prior();
    }

    /// Begins without information, from an estimate.
    #[inline(never)] // stack
    pub(super) fn start_from(&mut self, estimate: &Estimate) {
        let Pass { information, statistics, .. } = &mut self.best;
        *information = SquareRoot::ZERO;
        *statistics = Statistics::default();
        self.best.estimate = Estimate { orientation: estimate.orientation.normalised(), ..*estimate };
        self.damping = FIRST_DAMPING;
    }

    /// Passes over the first `count` measurements until the next correction would be small. Returns whether it would.
    #[inline(never)] // stack
    pub(super) fn converge(&mut self, block: &Block<F, impl Measurements>, count: usize) -> bool {
        let limit = if count < block.total { PART_CONVERGED } else { CONVERGED };
        self.best.statistics.cost = f64::INFINITY;
        self.current.estimate = self.best.estimate;
        // damping left from other measurements would end the passes after one tiny correction
        self.damping = self.damping.min(FIRST_DAMPING);
        let mut last_size = 0.0;
        for _ in 0..MAX_PASSES {
            self.pass(block, count);
            let rise = self.current.statistics.cost - self.best.statistics.cost;
            let is_better = rise <= 0.0;
            if is_better {
                self.best = self.current;
                self.damping *= 0.1;
            } else if rise < CONVERGED {
                return true;
            } else {
                self.damping = (10.0 * self.damping).max(FIRST_DAMPING);
            }
            let Some((next, size)) = self.corrected() else { return false };
            // after a better pass, the next correction is smaller by the same factor as this one, or by more
            let next_size = if is_better { size * (size / last_size).min(1.0) } else { size };
            if next_size < limit {
                self.end_with(next, size);
                return true;
            }
            self.current.estimate = next;
            last_size = size;
        }
        false
    }

    /// Reads the first `count` measurements at the estimate that is tried. The sum of squares is infinite where the motion cannot be
    /// followed.
    fn pass(&mut self, block: &Block<F, impl Measurements>, count: usize) {
        let prior_squares = self.begin();
        let Self { model, huber, current, trajectory, .. } = self;
        let mut statistics = [Statistics::new(*huber, 0.0); MAX_SENSORS];
        let mut epoch = None;
        for measurement in block.measurements().take(count) {
            let start = *epoch.get_or_insert(measurement.time);
            let added = trajectory.move_to(measurement.time - start).and_then(|()| {
                let sensor = block.sensors.get(measurement.sensor)?;
                let statistics = statistics.get_mut(measurement.sensor)?;
                current.add(*sensor, model, &trajectory.now, &measurement, statistics)
            });
            if added.is_none() {
                current.statistics.cost = f64::INFINITY;
                return;
            }
        }
        current.statistics = Statistics::new(*huber, prior_squares);
        statistics.iter().for_each(|sensor| current.statistics.add_sensor(sensor));
    }

    /// Sets the trajectory and the prior information; returns the sum of squares of the differences from the prior estimate.
    #[inline(never)] // stack
    fn begin(&mut self) -> f64 {
        let Self { prior, current: Pass { estimate, information, statistics }, .. } = self;
        *statistics = Statistics::default();
        information.clone_from(&prior.information);
        let change = prior.estimate.change_from(estimate).map(F::from_f64);
        information.set_solution(&change);
        self.trajectory = self.model.trajectory(estimate);
        prior.information.quadratic_form(&change).to_f64()
    }

    /// Best estimate after its correction, and the size of the correction in standard deviations. `None` where that is not finite.
    #[inline(never)] // stack
    fn corrected(&mut self) -> Option<(Estimate, f64)> {
        let change = self.damped(self.damping).solution();
        let Pass { estimate, information, statistics } = &self.best;
        let size = information.quadratic_form(&change).sqrt().to_f64();
        let is_finite = size.is_finite() && statistics.cost.is_finite();
        is_finite.then(|| (estimate.corrected(&change.map(F::to_f64)), size))
    }

    /// Makes the last correction. It lowers the sum of squares by the square of its size, as far as the equations are linear.
    fn end_with(&mut self, corrected: Estimate, size: f64) {
        let Pass { estimate, information, statistics } = &mut self.best;
        information.set_solution(&[F::ZERO; MAX_UNKNOWNS]);
        *estimate = corrected;
        statistics.cost -= size * size;
        statistics.chi_squared = (statistics.chi_squared - size * size).max(0.0);
    }

    /// Information of the best pass plus the damping of Marquardt: along each unknown, `damping` times its own information, and a prior of
    /// ten units. It overwrites the information of the current pass.
    #[inline(never)] // stack
    pub(super) fn damped(&mut self, damping: f64) -> &SquareRoot<F> {
        let Self { model, best: Pass { estimate, information, .. }, current, .. } = self;
        let damped = &mut current.information;
        damped.clone_from(information);
        for (index, unit) in model.units(estimate).into_iter().enumerate().take(model.count) {
            let least = F::from_f64(1.0 / (OPEN_DEVIATION * unit));
            let square = information.entry(index, index) * F::from_f64(damping);
            damped.add_unknown(index, (square + least.squared()).sqrt());
        }
        damped
    }

    /// Sum of squares of another launch, with the biases that fit it best.
    pub(super) fn cost_of(&mut self, launch: Estimate, block: &Block<F, impl Measurements>) -> f64 {
        /// Factor that keeps an unknown of the motion as it is.
        const HELD: f64 = 1e9;
        self.current.estimate = launch;
        self.pass(block, usize::MAX);
        let Pass { estimate, information, .. } = &mut self.current;
        for index in 0..self.model.motion_count {
            information.add_unknown(index, F::from_f64(HELD));
        }
        *estimate = estimate.corrected(&information.solution().map(F::to_f64));
        self.pass(block, usize::MAX);
        self.current.statistics.cost
    }
}

//! State of a fit, and its correction, pass by pass, by the method of Levenberg and Marquardt. [`Fit::settle`] repeats these steps:
//!
//! 1. The prior information and each measurement are added to the sum of squares at the estimate that is tried.
//! 2. An estimate with a lower sum becomes the best one, and the damping a tenth; otherwise the damping is ten times as large.
//! 3. The damped sum of the best estimate gives its correction, and with it the next estimate.
//! 4. It ends if that correction is small, or if the next one will be.

use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::statistics::Statistics;
use crate::model::{MAX_SENSORS, Model, Prior};
use crate::sensitivity::{LAUNCH_COLUMNS, Partials, Tangent, Trajectory};
use crate::sensors::{Measurement, Measurements, Residual, Sensor};
use crate::squares::{MAX_UNKNOWNS, Squares, unit_row};
use toytop::scalar::Real;

/// Largest size of the last correction, or of the one expected after it, of an estimate that has settled on all measurements, in standard
/// deviations.
const CONVERGED_SIGMA: f64 = 0.05;
/// Largest size of such a correction on a part of the measurements, in standard deviations.
const PARTIAL_SIGMA: f64 = 0.5;
/// Damping at the beginning.
const FIRST_DAMPING: f64 = 1e-3;
/// Largest number of passes over one part of the measurements.
const MAX_PASSES: u32 = 30;
/// Least sine of the tilt at which a fit may end without another pass.
const MIN_TILT: f64 = 0.1;
/// Largest change of the sum of squares that the error of the integration causes.
const COST_ERROR: f64 = 0.05;

/// Fit of a launch to measurements.
///
/// The unknowns are the launch, the free ratios, and the constant biases of the sensors. The scalar `f32` suffices for sensors whose noise
/// is at least 1e-4 of their readings; the fit then keeps 5.4 KB, whatever the number of measurements, and takes
/// 13 KB of stack.
#[derive(Clone)]
pub struct Fit<'a, F = f64> {
    pub(super) sensors: &'a [&'a dyn Sensor<F>],
    pub(super) model: Model,
    /// Largest residual that counts quadratically, in standard deviations.
    pub(super) huber: f64,
    pub(super) prior: Prior<F>,
    /// Pass with the least sum of squares.
    pub(super) best: Pass<F>,
    /// Pass of the estimate that is tried.
    current: Pass<F>,
    trajectory: Trajectory<F>,
    /// Part of the information that is added to it, by Marquardt.
    damping: f64,
    /// Size of the last correction from the same measurements, in standard deviations.
    last_change: Option<f64>,
}

/// Estimate, and the least-squares problem of its corrections.
#[derive(Clone, Copy)]
pub(super) struct Pass<F> {
    pub(super) estimate: Estimate,
    /// Rows of the prior and of the measurements.
    pub(super) information: Squares<F>,
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

impl<'a, F: Real> Fit<'a, F> {
    /// Fit of the unknowns of a model.
    pub(super) fn with_model(sensors: &'a [&'a dyn Sensor<F>], model: Model, huber: f64) -> Self {
        let prior = model.prior();
        let Prior { estimate, .. } = prior;
        let pass = Pass { estimate, information: Squares::ZERO, statistics: Statistics::default() };
        Self {
            sensors,
            model,
            huber,
            prior,
            best: pass,
            current: pass,
            trajectory: model.trajectory(&estimate),
            damping: FIRST_DAMPING,
            last_change: None,
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
        *information = Squares::ZERO;
        *statistics = Statistics::default();
        self.best.estimate = Estimate { orientation: estimate.orientation.normalised(), ..*estimate };
        self.damping = FIRST_DAMPING;
    }

    /// Passes over the first `count` measurements until the estimate does not change any more. Returns whether it settled.
    #[inline(never)] // stack
    pub(super) fn settle(&mut self, block: &Block<F, impl Measurements>, count: usize) -> bool {
        let settled = if count < block.total { PARTIAL_SIGMA } else { CONVERGED_SIGMA };
        self.best.statistics.cost = f64::INFINITY;
        // damping left from other measurements would end the fit after one tiny correction
        self.damping = self.damping.min(FIRST_DAMPING);
        self.last_change = None;
        self.current.estimate = self.best.estimate;
        for _ in 0..MAX_PASSES {
            self.pass(block, count);
            if let Some(done) = self.correct(settled) {
                return done;
            }
        }
        false
    }

    /// Reads the first `count` measurements at the estimate that is tried. The sum of squares is infinite where the motion cannot be
    /// followed.
    fn pass(&mut self, block: &Block<F, impl Measurements>, count: usize) {
        let prior_squares = self.begin();
        let Self { sensors, model, huber, current, trajectory, .. } = self;
        let mut statistics = [Statistics::new(*huber, 0.0); MAX_SENSORS];
        let mut epoch = None;
        for measurement in block.measurements().take(count) {
            let start = *epoch.get_or_insert(measurement.time);
            let added = trajectory.move_to(measurement.time - start).and_then(|()| {
                let sensor = sensors.get(measurement.sensor)?;
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
        prior.information.at(&change).to_f64()
    }

    /// Corrects the estimate after a pass. `None` where there must be another pass; otherwise whether it settled.
    #[inline(never)] // stack
    fn correct(&mut self, settled: f64) -> Option<bool> {
        let previous = self.best.statistics.cost;
        let cost = self.current.statistics.cost;
        let improved = cost <= previous && cost.is_finite();
        if !improved && cost - previous < COST_ERROR {
            return Some(true);
        }
        if improved {
            // a bad fit that hardly improves
            let statistics = &self.current.statistics;
            let stuck = statistics.outliers > statistics.used / 5 + 10 && previous - cost < 1e-3 * previous;
            self.best = self.current;
            self.damping *= 0.1;
            if stuck {
                return Some(false);
            }
        } else {
            self.damping = (10.0 * self.damping).max(FIRST_DAMPING);
            if self.damping > 1e9 || !self.best.statistics.cost.is_finite() {
                return Some(false);
            }
        }
        let change = self.damped(self.damping, 1000.0).solution();
        let best = &mut self.best;
        let next = best.estimate.corrected(&change.map(F::to_f64));
        let size = best.information.at(&change).sqrt().to_f64();
        if !size.is_finite() {
            return Some(false);
        }
        let last = self.last_change.replace(size).filter(|_| improved);
        // near the vertical the derivatives themselves depend on the launch
        let [x, y, _] = next.orientation.axis();
        let is_tilted = x * x + y * y > MIN_TILT * MIN_TILT;
        // the next correction is smaller by the same factor, or by more
        let near = is_tilted && last.is_some_and(|last| size * size < settled * last);
        if size < settled || near {
            // the information is about changes along the body axes, and does not turn with the correction
            best.information.set_solution(&[F::ZERO; MAX_UNKNOWNS]);
            best.estimate = next;
            // the correction lowers the sum of squares by this amount, as far as the equations are linear
            best.statistics.cost -= size * size;
            best.statistics.chi_squared = (best.statistics.chi_squared - size * size).max(0.0);
            return Some(true);
        }
        self.current.estimate = next;
        None
    }

    /// Information of the best pass plus the damping of Marquardt: along each unknown, `damping` times its own information, and a prior of
    /// `limit` units. It overwrites the information of the current pass. Damping is along the fixed axes, because yaw may be unobservable.
    #[inline(never)] // stack
    pub(super) fn damped(&mut self, damping: f64, limit: f64) -> &Squares<F> {
        let Self { model, best: Pass { estimate, information, .. }, current, .. } = self;
        let damped = &mut current.information;
        damped.clone_from(information);
        let launch = Tangent::along_body_axes(&estimate.orientation.inverse());
        for (index, unit) in model.units(estimate).into_iter().enumerate().take(model.count) {
            let mut direction = unit_row(index, F::ONE);
            if let Some(along) = launch.iter().take(LAUNCH_COLUMNS).nth(index) {
                direction.iter_mut().zip(along.components()).for_each(|(slot, x)| *slot = x);
            }
            let least = F::from_f64(1.0 / (limit * unit));
            let square = information.at(&direction) * F::from_f64(damping);
            let weight = (square + least.squared()).sqrt();
            damped.add(direction.map(|x| weight * x), F::ZERO);
        }
        damped
    }

    /// Sum of squares of another launch, with the biases that fit it best.
    pub(super) fn cost_of(&mut self, launch: Estimate, block: &Block<F, impl Measurements>) -> f64 {
        self.current.estimate = launch;
        self.pass(block, usize::MAX);
        let Pass { estimate, information, .. } = &mut self.current;
        for index in 0..self.model.count {
            let factor = if index < self.model.motion_count { 1e9 } else { 1e-6 };
            information.add_unknown(index, F::from_f64(factor));
        }
        *estimate = estimate.corrected(&information.solution().map(F::to_f64));
        self.pass(block, usize::MAX);
        self.current.statistics.cost
    }
}

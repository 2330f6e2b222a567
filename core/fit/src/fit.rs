//! Fit of a launch to measurements:
//!
//! 1. Search (`search`): the first measurements give one or more guesses (`first_guess`). Each one is corrected on the first part of the
//!    measurements, and the best one on longer and longer parts. A first guess of the caller, or the fit of the block before, replaces
//!    the search.
//! 2. Solve (`solver`): a pass reads a part of the measurements and stores none of them. Then the launch is corrected, and the next pass
//!    begins. The last passes read all measurements.
//! 3. Check (`check`): the residuals are compared with the noise (`statistics`), and the launch with others that would fit as well.
//! 4. Result (`fitted`): the covariance, the directions that stay open, and the drift.
//!
//! The numbers that decide in these steps are in `limits`, the formulas on the page of [partials](crate::partials).

// In the order of dependence.
mod limits;

mod block;

mod statistics;

mod warning;

mod solver;

mod first_guess;

mod search;

mod check;

mod fitted;

use crate::estimate::{Estimate, FreeRatio};
use crate::model::{Model, Prior, propagated};
use crate::sensitivity::LAUNCH_COLUMNS;
use crate::sensors::{Measurement, Sensor};
use crate::square_root::SquareRoot;
use crate::vector::{Vector, norm, rotation_vector};
use block::Block;
pub use fitted::{Drift, Fitted, Unobservable};
use solver::Solver;
pub use statistics::Statistics;
use toytop::internal::{check, check_item};
use toytop::scalar::Real;
use toytop::{ParameterError, Top};
pub use warning::FitWarning;

/// Fit of a launch to measurements.
///
/// The unknowns are the launch, the free ratios, the constant biases of the sensors, and the losses of rotation. The scalar `f32` suffices for sensors whose noise
/// is at least 1e-4 of their readings; the fit then keeps 5.4 KB, whatever the number of measurements, and takes
/// 12 KB of stack.
#[derive(Clone)]
pub struct Fit<'a, F = f64> {
    sensors: &'a [&'a dyn Sensor<F>],
    solver: Solver<F>,
}

/// Fit of a block, and its difference from the prediction of the last block.
#[derive(Clone, Copy, Debug)]
pub struct Tracked {
    /// Fit of the block.
    pub fitted: Fitted,
    /// Rotation vector from the predicted to the fitted orientation, rad.
    pub jump: Vector<f64>,
    /// Mean rates of change of l, n and h between the two launches, per unit time.
    pub drift_rates: Vector<f64>,
}

impl<'a, F: Real> Fit<'a, F> {
    /// Fit of a launch of this top by these sensors.
    ///
    /// * `ratios`: unknown ratios of the top, at most four
    ///
    /// # Errors
    /// `sensors`, `ratios`: more than four, or a number of one of them is out of range.
    pub fn new(
        top: &Top,
        sensors: &'a [&'a dyn Sensor<F>],
        ratios: &[FreeRatio],
    ) -> Result<Self, ParameterError> {
        Ok(Self { sensors, solver: Solver::new(Model::new(top, sensors, ratios, None)?, 3.0) })
    }

    /// Sets the largest residual that counts quadratically, in standard deviations; larger ones count linearly (Huber). It is infinite for
    /// least squares. The default is 3.
    ///
    /// # Errors
    /// `residual`: below 1, or NaN.
    pub fn with_huber(mut self, residual: f64) -> Result<Self, ParameterError> {
        check(residual >= 1.0, "residual", "a number from 1, or infinite")?;
        self.solver.huber = residual;
        Ok(self)
    }

    /// Adds three losses of rotation to the unknowns: about the axis, across it and about the vertical. At most one ratio may then
    /// be free.
    ///
    /// * `deviation`: standard deviation of each loss before the fit, per unit time: 1/60 /s for a spin that
    ///   may stop in a minute
    ///
    /// # Errors
    /// `ratios`: more than one. `deviation`: not a positive number.
    pub fn with_losses(self, deviation: f64) -> Result<Self, ParameterError> {
        check(deviation.is_finite() && deviation > 0.0, "deviation", "finite and positive")?;
        let Self { sensors, solver: Solver { model, huber, .. } } = self;
        let model = Model::new(&model.top, sensors, model.free(), Some(deviation))?;
        Ok(Self { sensors, solver: Solver::new(model, huber) })
    }

    /// Launch from all measurements, without a first guess. The measurements are read several times.
    ///
    /// # Errors
    /// `measurements`: none, or one that is not finite, not in order, or of an unknown sensor.
    pub fn run(
        &mut self,
        measurements: impl Iterator<Item = Measurement> + Clone,
    ) -> Result<Fitted, ParameterError> {
        let solver = &mut self.solver;
        let block = Block::new(self.sensors, measurements)?;
        solver.reset_prior();
        let (warning, other_launch_count) = solver.search_and_check(&block);
        let mut fitted = Fitted::new(solver, block.times, warning);
        fitted.other_launch_count = other_launch_count;
        if matches!(fitted.warning, Some(FitWarning::Misfit | FitWarning::NotConverged)) {
            let cause = solver.diagnose_misfit(&block, fitted.statistics.chi_squared);
            fitted.warning = cause.or(fitted.warning);
        }
        Ok(fitted)
    }

    /// Launch from all measurements, from a first guess at the time of the first measurement.
    ///
    /// # Errors
    /// The errors of [`Fit::run`].
    pub fn run_from(
        &mut self,
        guess: Estimate,
        measurements: impl Iterator<Item = Measurement> + Clone,
    ) -> Result<Fitted, ParameterError> {
        let solver = &mut self.solver;
        let block = Block::new(self.sensors, measurements)?;
        solver.reset_prior();
        solver.start_from(&guess);
        let warning = solver.converge_and_check(&block);
        Ok(Fitted::new(solver, block.times, warning))
    }

    /// Fits the next block of measurements. The fit of the last block, propagated to the first measurement with its covariance, is the prior.
    ///
    /// * `drift_deviation`: standard deviation of a change of ω between blocks, as a part of |ω| per unit time: 1/60 /s for a spin that may stop in
    ///   a minute
    ///
    /// # Errors
    /// The errors of [`Fit::run`]. `measurements`: the first one is earlier than the last launch. `last`: it has another top or other unknowns, or its
    /// motion cannot be followed to the first measurement. `drift_deviation`: negative or not finite.
    pub fn track(
        &mut self,
        last: &Fitted,
        drift_deviation: f64,
        measurements: impl Iterator<Item = Measurement> + Clone,
    ) -> Result<Tracked, ParameterError> {
        let is_valid = drift_deviation.is_finite() && drift_deviation >= 0.0;
        check(is_valid, "drift_deviation", "finite and not negative")?;
        let solver = &mut self.solver;
        let is_same = solver.model.has_unknowns_of(&last.model);
        check(is_same, "last", "of the same top, and have the same unknowns")?;
        let block = Block::new(self.sensors, measurements)?;
        let [first, _] = block.times;
        let span = first - last.launch_time;
        check_item(span >= 0.0, "measurements", 0, "as late as the last launch, or later")?;
        let allowed = "a motion that reaches the first measurement";
        let refused = ParameterError::new("last", allowed);
        let (predicted, at) = solver.model.predicted(&last.launch, span).ok_or(refused)?;
        let rows = last.covariance.rows().map(|row| {
            let mut row = propagated(&at.tangents, &row);
            // the losses may have changed: they get their own prior below
            solver
                .model
                .losses()
                .for_each(|(index, _)| row.iter_mut().skip(index).take(1).for_each(|x| *x = 0.0));
            row
        });
        let mut covariance: SquareRoot<f64> = rows.collect();
        let noise = drift_deviation * norm(predicted.omega) * span;
        for index in 0..LAUNCH_COLUMNS {
            let noise = if index < 3 { 0.5 * span * noise } else { noise };
            covariance.add_unknown(index, noise);
        }
        for (index, deviation) in solver.model.losses() {
            covariance.add_unknown(index, deviation);
        }
        let information = covariance.inverse_rows().map(|row| row.map(F::from_f64)).collect();
        solver.prior = Prior { estimate: predicted, information };
        solver.start_from(&predicted);
        let converged = solver.converge(&block, usize::MAX);
        let warning = solver.warning(converged);
        let fitted = Fitted::new(solver, block.times, warning);
        let turn = solver.best.estimate.orientation.compose(&predicted.orientation.inverse());
        let span = fitted.launch_time - last.launch_time;
        let drift_rates = solver.model.mean_rates([&last.launch, &fitted.launch], span);
        Ok(Tracked { fitted, jump: rotation_vector(&turn), drift_rates })
    }
}

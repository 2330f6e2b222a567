//! Correction of an estimate, pass by pass, by the method of Levenberg and Marquardt.

use crate::estimate::Estimate;
use crate::fit::pass::Pass;
use crate::fit::problem::Problem;
use crate::fit::statistics::Statistics;
use crate::information::Information;
use crate::model::{Model, Prior};
use crate::sensitivity::Trajectory;
use crate::sensors::Measurements;
use crate::triangle::MAX_UNKNOWNS;
use toytop::scalar::Real;

/// Size of the last correction of a fit that has converged, in standard deviations. The next one would be about its square.
pub(super) const CONVERGED_SIGMA: f64 = 0.05;
/// Damping at the beginning.
const FIRST_DAMPING: f64 = 1e-3;
/// Largest number of passes over one part of the measurements.
const MAX_PASSES: u32 = 30;
/// Largest estimated size of the next correction, in standard deviations, for a fit to end without another pass.
const NEXT_SETTLED: f64 = 0.1;
/// Largest correction after which a fit may end without another pass, in standard deviations.
const MAX_UNCONFIRMED: f64 = 10.0;
/// Least sine of the tilt at which a fit may end without another pass.
const MIN_TILT: f64 = 0.1;
/// Largest change of the sum of squares that the error of the integration causes.
const COST_ERROR: f64 = 0.05;

/// Solver by the method of Levenberg and Marquardt: the best estimate so far, and the one that is tried.
#[derive(Clone)]
pub(super) struct Solver<F> {
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
    /// Size of a correction over the square of the size of the one before it.
    pub(super) curvature: f64,
}

impl<F: Real> Solver<F> {
    /// Solver of a problem with these unknowns.
    pub(super) fn new(model: &Model) -> Self {
        let prior = model.prior();
        let Prior { estimate, .. } = prior;
        let information = Information::new(model.count);
        let pass = Pass { estimate, information, statistics: Statistics::default() };
        Self {
            prior,
            best: pass,
            current: pass,
            trajectory: model.trajectory(&estimate),
            damping: FIRST_DAMPING,
            last_change: None,
            curvature: f64::INFINITY,
        }
    }

    /// Sets the information before the measurements to the prior information of the model.
    #[inline(never)] // stack
    pub(super) fn reset_prior(&mut self, model: &Model) {
        self.prior = model.prior();
    }

    /// Begins without information, from an estimate.
    #[inline(never)] // stack
    pub(super) fn start_from(&mut self, estimate: &Estimate) {
        let Pass { information, statistics, .. } = &mut self.best;
        *information = Information::new(information.count);
        *statistics = Statistics::default();
        self.best.estimate = Estimate { orientation: estimate.orientation.normalised(), ..*estimate };
        self.damping = FIRST_DAMPING;
        self.curvature = f64::INFINITY;
    }

    /// Passes over the first `count` measurements until the estimate does not change any more. Returns whether it settled.
    ///
    /// * `settled`: largest correction of an estimate that counts as unchanged, in standard deviations
    #[inline(never)] // stack
    pub(super) fn settle(
        &mut self,
        problem: &Problem<F, impl Measurements>,
        count: usize,
        settled: f64,
    ) -> bool {
        self.best.statistics.cost = f64::INFINITY;
        // damping left from other measurements would end the fit after one tiny correction
        self.damping = self.damping.min(FIRST_DAMPING);
        self.last_change = None;
        self.current.estimate = self.best.estimate;
        for _ in 0..MAX_PASSES {
            self.pass(problem, count);
            if let Some(done) = self.correct(problem.model, settled) {
                return done;
            }
        }
        false
    }

    /// Reads the first `count` measurements at the estimate that is tried.
    fn pass(&mut self, problem: &Problem<F, impl Measurements>, count: usize) {
        self.current.read(problem, count, &self.prior, &mut self.trajectory);
    }

    /// Corrects the estimate after a pass. `None` where there must be another pass; otherwise whether it settled.
    #[inline(never)] // stack
    fn correct(&mut self, model: &Model, settled: f64) -> Option<bool> {
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
        let change = self.damped(model, self.damping, 1000.0).solution();
        let best = &mut self.best;
        let next = best.estimate.corrected(&change.map(F::to_f64));
        let size = best.information.square(&change).sqrt().to_f64();
        if !size.is_finite() {
            return Some(false);
        }
        if let Some(last) = self.last_change.replace(size).filter(|_| improved) {
            self.curvature = size / (last * last);
        }
        // near the vertical the derivatives themselves depend on the launch
        let [x, y, _] = next.orientation.axis();
        let near = x * x + y * y > MIN_TILT * MIN_TILT
            && size < MAX_UNCONFIRMED
            && self.curvature * size * size < NEXT_SETTLED;
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

    /// Information of the best pass, damped by [`Model::damp`]. It overwrites the current pass's.
    pub(super) fn damped(&mut self, model: &Model, damping: f64, limit: f64) -> &Information<F> {
        let Pass { estimate, information, .. } = &self.best;
        let damped = &mut self.current.information;
        damped.clone_from(information);
        model.damp(estimate, information, [damping, limit], damped);
        damped
    }

    /// Sum of squares of another launch, with the biases that fit it best.
    pub(super) fn cost_of(&mut self, launch: Estimate, problem: &Problem<F, impl Measurements>) -> f64 {
        self.current.estimate = launch;
        self.pass(problem, usize::MAX);
        let Pass { estimate, information, .. } = &mut self.current;
        for index in 0..problem.model.count {
            let deviation = if index < problem.model.motion_count { 1e-9 } else { 1e6 };
            information.add_prior(index, F::from_f64(deviation));
        }
        *estimate = estimate.corrected(&information.solution().map(F::to_f64));
        self.pass(problem, usize::MAX);
        self.current.statistics.cost
    }
}

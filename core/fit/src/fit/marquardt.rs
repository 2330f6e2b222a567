//! Correction of the estimate after a pass, by the method of Levenberg and Marquardt.

use crate::fit::error::FitWarning;
use crate::fit::pass::{FIRST_DAMPING, Fit};
use crate::sensitivity::LAUNCH_COLUMNS;
use crate::sensors::Measurements;
use crate::triangle::MOST_UNKNOWNS;
use toytop::scalar::Real;

/// Size of the last correction of a fit that has converged, in standard deviations. The next one would be about its square.
pub(super) const CONVERGED_SIGMA: f64 = 0.05;
/// Largest number of passes over one part of the measurements.
const MOST_PASSES: u32 = 30;
/// Largest estimated size of the next correction, in standard deviations, for a fit to end without another pass.
const NEXT_SETTLED: f64 = 0.1;
/// Largest correction after which a fit may end without another pass, in standard deviations.
const MOST_UNCONFIRMED: f64 = 10.0;
/// Least sine of the tilt at which a fit may end without another pass.
const LEAST_TILT: f64 = 0.1;
/// Change of the sum of squares that the error of the integration may cause.
const ROUNDING: f64 = 0.05;

impl<F: Real> Fit<'_, F> {
    /// Passes over the first `count` measurements until the estimate does not change any more. Returns whether it settled.
    ///
    /// * `settled`: largest correction of an estimate that counts as unchanged, in standard deviations
    #[inline(never)] // stack
    pub(super) fn settle(&mut self, measurements: &impl Measurements, count: usize, settled: f64) -> bool {
        self.best.statistics.cost = f64::INFINITY;
        // a large damping of other measurements would make the first correction so small that the fit would end with it
        self.damping = self.damping.min(FIRST_DAMPING);
        self.last_change = None;
        self.current.estimate = self.best.estimate;
        for _ in 0..MOST_PASSES {
            self.pass(measurements, count);
            if let Some(done) = self.correct(settled) {
                return done;
            }
        }
        false
    }

    /// Corrects the estimate after a pass. `None` where there must be another pass; otherwise whether it settled.
    #[inline(never)] // stack
    fn correct(&mut self, settled: f64) -> Option<bool> {
        let (previous, cost) = (self.best.statistics.cost, self.current.statistics.cost);
        let improved = cost <= previous && cost.is_finite();
        if !improved && cost - previous < ROUNDING {
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
        // the information of the current pass is not needed any more
        let (best, damped) = (&mut self.best, &mut self.current.information);
        damped.clone_from(&best.information);
        self.model.damp(&best.estimate, &best.information, [self.damping, 1000.0], damped);
        let change = damped.solution();
        let next = best.estimate.moved(&change.map(F::to_f64));
        let size = best.information.square(&change).sqrt().to_f64();
        if !size.is_finite() {
            return Some(false);
        }
        if let Some(last) = self.last_change.replace(size).filter(|_| improved) {
            self.curvature = size / (last * last);
        }
        // near the vertical the derivatives themselves depend on the launch
        let [x, y, _] = next.orientation.axis();
        let near = x * x + y * y > LEAST_TILT * LEAST_TILT
            && size < MOST_UNCONFIRMED
            && self.curvature * size * size < NEXT_SETTLED;
        if size < settled || near {
            // the information is about changes along the body axes, and does not turn with the correction
            best.information.set_solution(&[F::ZERO; MOST_UNKNOWNS]);
            best.estimate = next;
            // the correction lowers the sum of squares by this amount, as far as the equations are linear
            best.statistics.cost -= size * size;
            best.statistics.chi_squared = (best.statistics.chi_squared - size * size).max(0.0);
            return Some(true);
        }
        self.current.estimate = next;
        None
    }

    /// Reason why the best estimate must not be trusted.
    pub(super) fn warning(&self, settled: bool) -> Option<FitWarning> {
        let statistics = &self.best.statistics;
        if statistics.used == 0 && statistics.unused > 0 {
            Some(FitWarning::AllSaturated)
        } else if statistics.used < LAUNCH_COLUMNS as u32 {
            Some(FitWarning::TooFew)
        } else if statistics.is_misfit(self.model.count) {
            Some(FitWarning::Misfit)
        } else if settled {
            None
        } else {
            Some(FitWarning::NotSettled)
        }
    }
}

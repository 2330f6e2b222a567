//! Result of a fit from its best pass.

use crate::fit::Fit;
use crate::fit::covariance::Covariance;
use crate::fit::outcome::{Fitted, Reason, Unobservable};
use crate::fit::pass::Pass;
use crate::fit::search::Found;
use crate::scalar::Real;

impl<F: Real> Fit<'_, F> {
    /// Directions that the measurements do not determine.
    #[inline(never)] // its matrix must not be on the stack during the following work
    fn unobservable(&self) -> Unobservable {
        self.model.unobservable(&self.best.launch, &self.best.information)
    }

    /// Result after a search.
    pub(super) fn fitted(&mut self, &Found { times, progress, alternatives }: &Found) -> Fitted {
        let unobservable = self.unobservable();
        self.limit_information();
        let [epoch, end] = times;
        let mut fitted = self.result(epoch);
        self.current.information.covariance(&mut fitted.covariance);
        (fitted.unobservable, fitted.alternatives) = (unobservable, alternatives);
        fitted.reason = self.reason(progress);
        if self.model.has_losses() && self.carry_to_end(&mut fitted, end).is_none() {
            fitted.reason = fitted.reason.or(Some(Reason::NotSettled));
        }
        fitted
    }

    /// Copies the information of the best pass to the current one, and limits the deviations of undetermined directions.
    #[inline(never)] // its numbers and the result must not be on the stack together
    fn limit_information(&mut self) {
        let Pass { launch, information, .. } = &self.best;
        // not larger, so that the covariance keeps the digits of what is determined
        let floor = self.model.damping(launch, information, 0.0, 10.0);
        let limited = &mut self.current.information;
        limited.clone_from(information);
        limited.damp(&floor);
    }

    /// Result of the best launch, without its covariance.
    #[inline(never)] // it is built where it is needed
    fn result(&self, epoch: f64) -> Fitted {
        Fitted {
            epoch,
            launch: self.best.launch,
            covariance: Covariance::ZERO,
            statistics: self.best.statistics,
            unobservable: Unobservable::default(),
            reason: None,
            alternatives: 0,
            count: self.model.count,
            ratios: self.model.ratios(&self.best.launch),
            directions: self.model.directions(),
            drift: None,
        }
    }
}

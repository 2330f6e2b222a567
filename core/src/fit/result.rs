//! Result of a fit from its best pass.

use crate::fit::Fit;
use crate::fit::outcome::{Fitted, Reason, Unobservable};
use crate::fit::pass::Pass;
use crate::fit::triangle::MOST_UNKNOWNS;
use crate::scalar::Real;

impl<F: Real> Fit<'_, F> {
    /// Directions that the measurements do not determine.
    #[inline(never)] // its matrices are on the stack without those of the result
    pub(super) fn unobservable(&self) -> Unobservable {
        self.model.unobservable(&self.best.launch, &self.best.information)
    }

    #[inline(never)] // its matrices are on the stack at the end only
    pub(super) fn fitted(
        &mut self,
        times: [f64; 2],
        reason: Option<Reason>,
        alternatives: usize,
        unobservable: Unobservable,
    ) -> Fitted {
        let Pass { launch, information, statistics, .. } = &self.best;
        let (launch, statistics) = (*launch, *statistics);
        // not larger, so that the covariance keeps the digits of what is determined
        let floor = self.model.damping(&launch, information, 0.0, 10.0);
        let [epoch, end] = times;
        let scratch = &mut self.current.information;
        scratch.clone_from(information);
        scratch.damp(&floor);
        let mut fitted = Fitted {
            epoch,
            launch,
            covariance: [[0.0; MOST_UNKNOWNS]; MOST_UNKNOWNS],
            statistics,
            unobservable,
            reason,
            alternatives,
            count: self.model.count,
            ratios: self.model.ratios(&launch),
            directions: self.model.directions(),
            drift: None,
        };
        scratch.covariance(&mut fitted.covariance);
        if self.model.has_losses() && self.carry_to_end(&mut fitted, end).is_none() {
            fitted.reason = fitted.reason.or(Some(Reason::NotSettled));
        }
        fitted
    }
}

//! How far a run of the core is from the full solver, at the moments that the run has gone through.

use super::run::{Moment, Run};
use crate::Failure;
use crate::full_solver::FullState;
use crate::invariants::natural_scales;
use crate::scenario::Scenario;
use crate::truth;
use toytop::{Motion, Phi};

/// The greatest errors over all samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Errors {
    /// 2 √(|Δα|² + |Δβ|²), rad.
    pub(super) orientation: f64,
    pub(super) u: f64,
    /// Of the tip, in units of s.
    pub(super) tip: f64,
    /// Of l, n and h as recomputed from α, β and their rates, in units of [`natural_scales`].
    pub(super) integrals: [f64; 3],
}

/// The full solver at the times of the last run: most runs go through the same.
#[derive(Default)]
pub(super) struct Truth {
    times: Vec<f64>,
    states: Vec<FullState>,
}

impl Truth {
    /// Compares a run with the full solver at the times the run has truly gone through: an f32 step lands next to the time
    /// asked for.
    pub(super) fn measure(&mut self, scenario: &Scenario, run: &Run) -> Result<Errors, Failure> {
        let times: Vec<f64> = run.moments.iter().map(|moment| moment.sample.t).collect();
        if times != self.times {
            self.states = truth::states(scenario, &times)?;
            self.times = times;
        }
        let mut errors = Errors::default();
        run.moments.iter().zip(&self.states).for_each(|(moment, state)| {
            errors.worsen(&scenario.motion, moment, state);
        });
        Ok(errors)
    }
}

impl Errors {
    fn worsen(&mut self, motion: &Motion, Moment { sample, integrals }: &Moment, truth: &FullState) {
        let truth = truth::phi(truth);
        let Phi { alpha, beta } = truth;
        let tip = (alpha * beta).scaled(2.0);
        let tip_error = sample.tip.scaled(1.0 / motion.top().tip_scale()) - tip;
        worsen(&mut self.orientation, truth::distance(&sample.orientation(), &truth));
        worsen(&mut self.u, (sample.u - (alpha.norm_squared() - beta.norm_squared())).abs());
        worsen(&mut self.tip, tip_error.norm_squared().sqrt());
        let constants = motion.first_integrals();
        let scales = natural_scales(motion);
        let differences =
            [integrals[0] - constants.l, integrals[1] - constants.n, integrals[2] - constants.h];
        for ((worst, difference), scale) in self.integrals.iter_mut().zip(differences).zip(scales) {
            worsen(worst, difference.abs() / scale);
        }
    }
}

/// The greatest so far; a NaN stays.
fn worsen(worst: &mut f64, error: f64) {
    if error > *worst || error.is_nan() {
        *worst = error;
    }
}

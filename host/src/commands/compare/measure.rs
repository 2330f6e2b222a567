//! Errors of a run of the core against the full solver, at the times of the run's samples.

use super::run::Run;
use crate::Failure;
use crate::full_equations::full_solver::FullState;
use crate::full_equations::solution;
use crate::input::scenario::Scenario;
use crate::motion::invariants::natural_scales;
use crate::motion::propagate::Sample;
use toytop::{Motion, Orientation};

/// Greatest errors over all samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Errors {
    /// Error of the orientation, 2 √(|Δα|² + |Δβ|²), rad.
    pub(super) orientation: f64,
    pub(super) u: f64,
    /// Error of the tip, in units of s.
    pub(super) tip: f64,
    /// Errors of l, n and h as recomputed from α, β and their rates, in units of [`natural_scales`].
    pub(super) integrals: [f64; 3],
}

/// States of the full solver at the times of the last run, which most other runs share.
#[derive(Default)]
pub(super) struct Truth {
    times: Vec<f64>,
    states: Vec<FullState>,
}

impl Truth {
    /// Errors of a run against the full solver at the times that the run has reached, because an f32 step ends near the requested
    /// time, not at it.
    pub(super) fn measure(&mut self, scenario: &Scenario, run: &Run) -> Result<Errors, Failure> {
        let times: Vec<f64> = run.samples.iter().map(|(sample, _)| sample.t).collect();
        if times != self.times {
            self.states = solution::states(scenario, &times)?;
            self.times = times;
        }
        let mut errors = Errors::default();
        run.samples.iter().zip(&self.states).for_each(|(sample, state)| {
            errors.worsen(&scenario.motion, sample, state);
        });
        Ok(errors)
    }
}

impl Errors {
    fn worsen(&mut self, motion: &Motion, (sample, integrals): &(Sample, [f64; 3]), truth: &FullState) {
        let truth = solution::phi(truth);
        let Orientation { alpha, beta } = truth;
        let tip = (alpha * beta).scaled(2.0);
        let tip_error = sample.tip.scaled(1.0 / motion.top().tip_scale()) - tip;
        worsen(&mut self.orientation, sample.orientation().distance(&truth));
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

/// Replaces the worst error by a larger one; a NaN stays.
fn worsen(worst: &mut f64, error: f64) {
    if error > *worst || error.is_nan() {
        *worst = error;
    }
}

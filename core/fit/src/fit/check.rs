//! Last passes over all measurements, and reasons not to trust the launch that they find.

use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::first_guess::rotation_from_vertical;
use crate::fit::limits::{CHANCE_COST, MAX_RATE_AT_REST, MIN_NOISE, RANGE_FRACTION, SMALL_ANGLE_SINE};
use crate::fit::solver::Solver;
use crate::fit::warning::FitWarning;
use crate::sensitivity::LAUNCH_COLUMNS;
use crate::sensors::Measurements;
use crate::vector::{Vector, cross, dot, scaled};
use toytop::scalar::Real;

impl<F: Real> Solver<F> {
    /// Passes over all measurements. Returns the reason not to trust the estimate.
    pub(super) fn converge_and_check(&mut self, block: &Block<F, impl Measurements>) -> Option<FitWarning> {
        let converged = self.converge(block, usize::MAX);
        let launch = &self.best.estimate;
        let found = dot(launch.omega, launch.orientation.axis());
        let bound = |([_, _, low], saturated): (Vector<f64>, bool)| (saturated && low != 0.0).then_some(low);
        let least = block.rates().find_map(bound);
        // the axial rate is constant, so that one reading at the end of the range bounds it
        let spin = least.filter(|least| found / least < RANGE_FRACTION).unwrap_or(found);
        let warning = self.warning(converged && spin == found);
        let misfit =
            matches!(warning, Some(FitWarning::AllSaturated | FitWarning::TooFew | FitWarning::Misfit));
        let unknown = self.is_explained_upright(block, spin);
        if unknown && !misfit { Some(FitWarning::SpinUnknown) } else { warning }
    }

    /// Reason in the residuals not to trust the best estimate.
    pub(super) fn warning(&self, converged: bool) -> Option<FitWarning> {
        let statistics = &self.best.statistics;
        if statistics.used == 0 && statistics.unused > 0 {
            Some(FitWarning::AllSaturated)
        } else if statistics.used < LAUNCH_COLUMNS as u32 {
            Some(FitWarning::TooFew)
        } else if statistics.is_misfit(self.model.count) {
            Some(FitWarning::Misfit)
        } else {
            (!converged).then_some(FitWarning::NotConverged)
        }
    }

    /// Whether an upright launch with twice this spin explains the measurements equally well. They do not determine the spin then.
    ///
    /// An upright top with a saturated gyroscope fits any spin.
    #[inline(never)] // stack
    fn is_explained_upright(&mut self, block: &Block<F, impl Measurements>, spin: f64) -> bool {
        let found = self.best.estimate;
        let axis = found.orientation.axis();
        let transverse = cross(found.omega, axis);
        let [x, y, z] = axis;
        let near = SMALL_ANGLE_SINE * SMALL_ANGLE_SINE;
        if x * x + y * y > near || dot(transverse, transverse) > near * dot(found.omega, found.omega) {
            return false;
        }
        let sign = 1_f64.copysign(z);
        let orientation = rotation_from_vertical(scaled(axis, sign)).inverse().compose(&found.orientation);
        let upright = Estimate { orientation, omega: [0.0, 0.0, sign * 2.0 * spin], ..found };
        self.cost_of(upright, block) <= self.best.statistics.cost + CHANCE_COST
    }

    /// Cause of residuals that are too large. The launch is searched for once more, with the rates in degrees: the best estimate is lost.
    #[inline(never)] // stack
    pub(super) fn diagnose_misfit(
        &mut self,
        block: &Block<F, impl Measurements>,
        chi_squared: f64,
    ) -> Option<FitWarning> {
        let (warning, _) = self.search_and_check(&block.in_degrees());
        // smaller numbers have smaller residuals, whatever the motion is
        let statistics = &self.best.statistics;
        let has_noise = statistics.chi_squared > MIN_NOISE * f64::from(statistics.used);
        if has_noise && (warning.is_none() || statistics.chi_squared < 0.1 * chi_squared) {
            return Some(FitWarning::RatesInDegrees);
        }
        let mut rates = block.rates();
        let is_small = |(omega, saturated): (Vector<f64>, bool)| {
            !saturated && omega.iter().all(|x| x.abs() < MAX_RATE_AT_REST)
        };
        (rates.next().is_some_and(is_small) && rates.all(is_small)).then_some(FitWarning::AtRest)
    }
}

//! Search for a launch without a first guess, on longer and longer parts of the measurements; and reasons not to trust what it finds.

use crate::error::FitWarning;
use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::first_guess::{FIRST_INSTANTS, Guesses, guesses, rotation_from_vertical};
use crate::fit::solver::{Fit, Pass};
use crate::sensitivity::LAUNCH_COLUMNS;
use crate::sensors::Measurements;
use crate::vector::{Vector, cross, dot, scaled};
use toytop::scalar::Real;
use toytop::su2::Orientation;

/// Largest difference of the sums of squares of two launches that fit equally well.
const EQUAL_COST: f64 = 9.0;
/// Least distance of two launches that are not the same, in standard deviations.
const OTHER_LAUNCH_SIGMA: f64 = 10.0;
/// Least mean square of residuals of rates in degrees: the noise given may be twice too large.
const MIN_NOISE: f64 = 0.25;
/// Least quotient of a rate beyond the range and a reading at its end. Bias and mounting may shift the reading.
const RANGE_FRACTION: f64 = 0.9;
/// Largest sine of the tilt, and largest fraction of ω across the axis, of a launch that is compared with an upright one.
const UPRIGHT_SINE: f64 = 0.1;
/// Largest difference of sums of squares that chance explains: twice that between the best of 100 random spins and the true one.
const CHANCE_COST: f64 = 40.0;

impl<F: Real> Fit<'_, F> {
    /// Finds an estimate without a first guess. Returns the reason not to trust it, and the number of other launches that fit as well.
    #[inline(never)] // stack
    pub(super) fn search(&mut self, block: &Block<F, impl Measurements>) -> (Option<FitWarning>, usize) {
        let [first, _] = block.times;
        self.start_from(&Estimate::new(Orientation::IDENTITY, [0.0; 3]));
        if block.measurements().filter(|one| one.time > first).take(2).count() < 2 {
            return (Some(FitWarning::TooFew), 0);
        }
        let Some(guesses) = guesses(block, self.model.top.tip_scale()) else {
            return (Some(FitWarning::NoBeginning), 0);
        };
        // the first part that is fitted is four times as long as the part of the guess
        let mut count = 4 * FIRST_INSTANTS * self.sensors.len();
        let other_launch_count = self.try_guesses(block, &guesses, count);
        // each part begins from an estimate that is good enough for it
        while count.saturating_mul(8) < block.total {
            count = count.saturating_mul(4);
            self.settle(block, count);
        }
        (self.settle_on_all(block), other_launch_count)
    }

    /// Begins from the best of the guesses, on the first measurements, where no phase can have an error of a turn. Returns the number
    /// of other launches that fit as well.
    #[inline(never)] // stack
    fn try_guesses(&mut self, block: &Block<F, impl Measurements>, guesses: &Guesses, count: usize) -> usize {
        let mut best = (self.best.estimate, f64::INFINITY);
        let mut others = 0;
        for guess in (0..).map_while(|number| guesses.get(number)) {
            self.start_from(&guess);
            self.settle(block, count / 4);
            self.settle(block, count);
            let Pass { estimate, information, statistics } = &self.best;
            let cost = statistics.cost;
            let change = estimate.change_from(&best.0).map(F::from_f64);
            if cost < best.1 - EQUAL_COST {
                others = 0;
            } else if cost < best.1 + EQUAL_COST
                && information.at(&change).to_f64() > OTHER_LAUNCH_SIGMA * OTHER_LAUNCH_SIGMA
            {
                others += 1;
            }
            if cost < best.1 {
                best = (*estimate, cost);
            }
        }
        if guesses.get(1).is_some() {
            self.start_from(&best.0);
        }
        others
    }

    /// Passes over all measurements. Returns the reason not to trust the estimate.
    pub(super) fn settle_on_all(&mut self, block: &Block<F, impl Measurements>) -> Option<FitWarning> {
        let settled = self.settle(block, usize::MAX);
        let launch = &self.best.estimate;
        let found = dot(launch.omega, launch.orientation.axis());
        let bound = |([_, _, low], saturated): (Vector<f64>, bool)| (saturated && low != 0.0).then_some(low);
        let least = block.rates().find_map(bound);
        // the axial rate is constant, so that one reading at the end of the range bounds it
        let spin = least.filter(|least| found / least < RANGE_FRACTION).unwrap_or(found);
        let warning = self.warning(settled && spin == found);
        let misfit =
            matches!(warning, Some(FitWarning::AllSaturated | FitWarning::TooFew | FitWarning::Misfit));
        let unknown = self.is_explained_upright(block, spin);
        if unknown && !misfit { Some(FitWarning::SpinUnknown) } else { warning }
    }

    /// Reason in the residuals not to trust the best estimate.
    pub(super) fn warning(&self, settled: bool) -> Option<FitWarning> {
        let statistics = &self.best.statistics;
        if statistics.used == 0 && statistics.unused > 0 {
            Some(FitWarning::AllSaturated)
        } else if statistics.used < LAUNCH_COLUMNS as u32 {
            Some(FitWarning::TooFew)
        } else if statistics.is_misfit(self.model.count) {
            Some(FitWarning::Misfit)
        } else {
            (!settled).then_some(FitWarning::NotSettled)
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
        let near = UPRIGHT_SINE * UPRIGHT_SINE;
        if x * x + y * y > near || dot(transverse, transverse) > near * dot(found.omega, found.omega) {
            return false;
        }
        let sign = 1_f64.copysign(z);
        let orientation = rotation_from_vertical(scaled(axis, sign)).inverse().compose(&found.orientation);
        let upright = Estimate { orientation, omega: [0.0, 0.0, sign * 2.0 * spin], ..found };
        self.cost_of(upright, block) <= self.best.statistics.cost + CHANCE_COST
    }

    /// Cause of residuals that are too large. The best estimate is overwritten.
    #[inline(never)] // stack
    pub(super) fn misfit_cause(
        &mut self,
        block: &Block<F, impl Measurements>,
        chi_squared: f64,
    ) -> Option<FitWarning> {
        let (warning, _) = self.search(&block.in_degrees());
        // smaller numbers have smaller residuals, whatever the motion is
        let statistics = &self.best.statistics;
        let has_noise = statistics.chi_squared > MIN_NOISE * f64::from(statistics.used);
        if has_noise && (warning.is_none() || statistics.chi_squared < 0.1 * chi_squared) {
            return Some(FitWarning::RatesInDegrees);
        }
        let mut rates = block.rates();
        // below 0.1 per unit time, a bias may explain the rates
        let is_small =
            |(omega, saturated): (Vector<f64>, bool)| !saturated && omega.iter().all(|x| x.abs() < 0.1);
        (rates.next().is_some_and(is_small) && rates.all(is_small)).then_some(FitWarning::AtRest)
    }
}

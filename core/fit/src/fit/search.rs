//! Search for a launch without a first guess, on longer and longer parts of the measurements.

use crate::estimate::Estimate;
use crate::fit::block::Block;
use crate::fit::first_guess::guesses;
use crate::fit::limits::{CHANCE_COST, FIRST_READINGS, GROSS_SIGMA, PART_FACTOR};
use crate::fit::solver::{Pass, Solver};
use crate::fit::warning::FitWarning;
use crate::sensors::Measurements;
use toytop::scalar::Real;
use toytop::su2::Orientation;

impl<F: Real> Solver<F> {
    /// Searches for a launch, and checks it. Returns the reason not to trust the estimate, and the number of other launches that fit the first
    /// measurements equally well.
    pub(super) fn search_and_check(
        &mut self,
        block: &Block<F, impl Measurements>,
    ) -> (Option<FitWarning>, usize) {
        match self.search(block) {
            Ok(other_launch_count) => (self.converge_and_check(block), other_launch_count),
            Err(warning) => (Some(warning), 0),
        }
    }

    /// Finds an estimate that is good enough for passes over all measurements. Returns the number of other launches that fit the first
    /// measurements equally well, or the reason why there is no guess.
    #[inline(never)] // stack
    fn search(&mut self, block: &Block<F, impl Measurements>) -> Result<usize, FitWarning> {
        let [first, _] = block.times;
        self.start_from(&Estimate::new(Orientation::IDENTITY, [0.0; 3]));
        if block.measurements().filter(|one| one.time > first).take(2).count() < 2 {
            return Err(FitWarning::TooFew);
        }
        let guesses = guesses(block, self.model.top.tip_scale()).ok_or(FitWarning::NoFirstGuess)?;
        let first = FIRST_READINGS * block.sensors.len();
        let other_launch_count = self.try_guesses(block, guesses, first);
        let parts = core::iter::successors(Some(first), |count| count.checked_mul(PART_FACTOR));
        for count in parts.skip(2).take_while(|count| *count < block.total) {
            self.converge(block, count);
        }
        Ok(other_launch_count)
    }

    /// Corrects each guess on the first two parts, where no phase can be wrong by a turn, and begins from the best. Returns the
    /// number of other launches that fit as well.
    ///
    /// * `first`: number of measurements of the first part
    #[inline(never)] // stack
    fn try_guesses(
        &mut self,
        block: &Block<F, impl Measurements>,
        guesses: impl Iterator<Item = Estimate>,
        first: usize,
    ) -> usize {
        let mut best = (self.best.estimate, f64::INFINITY);
        let mut others = 0;
        for guess in guesses {
            self.start_from(&guess);
            self.converge(block, first);
            self.converge(block, PART_FACTOR * first);
            let Pass { estimate, information, statistics } = &self.best;
            let cost = statistics.cost;
            let change = estimate.change_from(&best.0).map(F::from_f64);
            if cost < best.1 - CHANCE_COST {
                others = 0;
            } else if cost < best.1 + CHANCE_COST
                && information.quadratic_form(&change).to_f64() > GROSS_SIGMA * GROSS_SIGMA
            {
                others += 1;
            }
            if cost < best.1 {
                best = (*estimate, cost);
            }
        }
        self.start_from(&best.0);
        others
    }
}

//! What many trials add up to.

use super::trial::{Outcome, Trial, Worst};
use std::collections::BTreeMap;
use toytop_host::output::names::regime;

/// Worst cases that are kept.
const KEPT: usize = 5;

/// Counts and quantiles of both scalars.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Motions by regime.
    pub regimes: BTreeMap<&'static str, u64>,
    /// What must not happen: refused, or panicked, with the numbers or the stream of the motion.
    pub failures: Vec<String>,
    /// Of f64 and of f32.
    pub scalars: [Side; 2],
}

/// One scalar.
#[derive(Clone, Debug, Default)]
pub struct Side {
    /// Fits, by segments.
    pub fits: BTreeMap<usize, u64>,
    /// Typed refusals.
    pub no_fit: u64,
    /// An error beyond its bound, near or far, of the orientation or of the rates.
    pub violated: u64,
    /// The first period.
    pub near: Spread,
    /// Far away.
    pub far: Spread,
    /// Rates, near and far.
    pub rates: Spread,
    /// The greatest errors over bound, with their motions.
    pub worst: Vec<Case>,
}

/// A case that is worth a look.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Error and bound.
    pub worst: Worst,
    /// Of its table.
    pub segments: usize,
    /// Its motion.
    pub trial: Trial,
}

/// Of one kind of times.
#[derive(Clone, Debug, Default)]
pub struct Spread {
    /// Bound over error, motion by motion.
    ratios: Vec<f64>,
    /// rad; for rates, shares of the greatest angular speed.
    errors: Vec<f64>,
}

impl Tally {
    /// Adds a trial.
    pub fn add(&mut self, trial: &Trial) {
        *self.regimes.entry(regime(trial.regime)).or_default() += 1;
        for (side, outcome) in self.scalars.iter_mut().zip(&trial.outcomes) {
            side.add(outcome, trial);
        }
    }

    /// With what another thread has.
    #[must_use]
    pub fn merged(mut self, other: Self) -> Self {
        for (regime, count) in other.regimes {
            *self.regimes.entry(regime).or_default() += count;
        }
        self.failures.extend(other.failures);
        for (side, other) in self.scalars.iter_mut().zip(other.scalars) {
            side.merge(other);
        }
        self
    }

    /// Puts numbers in order; before that there are no quantiles.
    pub fn finish(&mut self) {
        for side in &mut self.scalars {
            for spread in [&mut side.near, &mut side.far, &mut side.rates] {
                spread.ratios.sort_by(f64::total_cmp);
                spread.errors.sort_by(f64::total_cmp);
            }
        }
    }
}

impl Side {
    fn add(&mut self, outcome: &Outcome, trial: &Trial) {
        let Outcome::Fits { segments, near, far, rates } = outcome else {
            self.no_fit += 1;
            return;
        };
        *self.fits.entry(*segments).or_default() += 1;
        self.near.add(near);
        self.far.add(far);
        self.rates.add(rates);
        let worse = if far.strain() > near.strain() { far } else { near };
        self.violated += u64::from(worse.strain() > 1.0 || rates.strain() > 1.0);
        self.keep(Case { worst: *worse, segments: *segments, trial: *trial });
    }

    fn keep(&mut self, case: Case) {
        self.worst.push(case);
        self.worst.sort_by(|a, b| b.worst.strain().total_cmp(&a.worst.strain()));
        self.worst.truncate(KEPT);
    }

    fn merge(&mut self, other: Self) {
        for (segments, count) in other.fits {
            *self.fits.entry(segments).or_default() += count;
        }
        self.no_fit += other.no_fit;
        self.violated += other.violated;
        self.near.merge(other.near);
        self.far.merge(other.far);
        self.rates.merge(other.rates);
        other.worst.into_iter().for_each(|case| self.keep(case));
    }
}

impl Spread {
    fn add(&mut self, worst: &Worst) {
        if worst.bound > 0.0 {
            self.ratios.push(1.0 / worst.strain());
            self.errors.push(worst.error);
        }
    }

    fn merge(&mut self, other: Self) {
        self.ratios.extend(other.ratios);
        self.errors.extend(other.errors);
    }

    /// Bound over error, of which this share of the motions has less.
    #[must_use]
    pub fn ratio(&self, share: f64) -> f64 {
        quantile(&self.ratios, share)
    }

    /// Error, in its unit.
    #[must_use]
    pub fn error(&self, share: f64) -> f64 {
        quantile(&self.errors, share)
    }

    /// The share of motions whose bound is at most so many times the error.
    #[must_use]
    pub fn within(&self, ratio: f64) -> f64 {
        self.ratios.partition_point(|x| *x <= ratio) as f64 / self.ratios.len().max(1) as f64
    }
}

fn quantile(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((share * last as f64).round() as usize).copied().unwrap_or(f64::NAN)
}

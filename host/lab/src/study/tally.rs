//! Counts and quantiles over many trials.

use super::trial::{Outcome, Trial, Worst};
use std::collections::BTreeMap;
use toytop_host::output::names::regime;

/// Number of worst cases that are kept.
const KEPT: usize = 5;

/// Counts and quantiles of both scalars.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    /// Number of motions by regime.
    pub regimes: BTreeMap<&'static str, u64>,
    /// Failures, which must not happen: refusals and panics, with the numbers or the stream of the motion.
    pub failures: Vec<String>,
    /// Results of f64 and f32.
    pub scalars: [Side; 2],
}

/// Results of one scalar.
#[derive(Clone, Debug, Default)]
pub(crate) struct Side {
    /// Number of tables by their number of segments.
    pub fits: BTreeMap<usize, u64>,
    /// Number of motions for which no table is large enough.
    pub no_fit: u64,
    /// Number of motions with an error of the orientation or of the rates beyond its bound.
    pub violated: u64,
    /// Errors in the first period.
    pub near: Spread,
    /// Errors at distant times.
    pub far: Spread,
    /// Errors of the rates at all times.
    pub rates: Spread,
    /// Cases with the greatest quotients of error and bound.
    pub worst: Vec<Case>,
}

/// Case with a large quotient of error and bound.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    /// Error and bound of the case.
    pub worst: Worst,
    /// Number of segments of its table.
    pub segments: usize,
    /// Motion of the case.
    pub trial: Trial,
}

/// Errors and ratios of all motions at one kind of times.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spread {
    /// Quotient of bound and error of each motion.
    ratios: Vec<f64>,
    /// Errors in rad; for rates, relative to the greatest angular speed.
    errors: Vec<f64>,
}

impl Tally {
    /// Adds a trial.
    pub(crate) fn add(&mut self, trial: &Trial) {
        *self.regimes.entry(regime(trial.regime)).or_default() += 1;
        for (side, outcome) in self.scalars.iter_mut().zip(&trial.outcomes) {
            side.add(outcome, trial);
        }
    }

    /// Sum with the tally of another thread.
    #[must_use]
    pub(crate) fn merged(mut self, other: Self) -> Self {
        for (regime, count) in other.regimes {
            *self.regimes.entry(regime).or_default() += count;
        }
        self.failures.extend(other.failures);
        for (side, other) in self.scalars.iter_mut().zip(other.scalars) {
            side.merge(other);
        }
        self
    }

    /// Sorts the numbers, which quantiles need.
    pub(crate) fn finish(&mut self) {
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
        let closer = if far.of_bound() > near.of_bound() { far } else { near };
        self.violated += u64::from(closer.of_bound() > 1.0 || rates.of_bound() > 1.0);
        self.keep(Case { worst: *closer, segments: *segments, trial: *trial });
    }

    fn keep(&mut self, case: Case) {
        self.worst.push(case);
        self.worst.sort_by(|a, b| b.worst.of_bound().total_cmp(&a.worst.of_bound()));
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
            self.ratios.push(1.0 / worst.of_bound());
            self.errors.push(worst.error);
        }
    }

    fn merge(&mut self, other: Self) {
        self.ratios.extend(other.ratios);
        self.errors.extend(other.errors);
    }

    /// Quantile of the quotient of bound and error: this share of the motions has a smaller one.
    #[must_use]
    pub(crate) fn ratio(&self, share: f64) -> f64 {
        quantile(&self.ratios, share)
    }

    /// Quantile of the error.
    #[must_use]
    pub(crate) fn error(&self, share: f64) -> f64 {
        quantile(&self.errors, share)
    }

    /// Share of the motions whose bound is at most `ratio` times the error.
    #[must_use]
    pub(crate) fn within(&self, ratio: f64) -> f64 {
        self.ratios.partition_point(|x| *x <= ratio) as f64 / self.ratios.len().max(1) as f64
    }
}

fn quantile(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((share * last as f64).round() as usize).copied().unwrap_or(f64::NAN)
}

//! Sums and greatest values over many trials.

use super::reading::SCALARS;
use super::trial::{Kept, Outcome};
use std::collections::BTreeMap;
use toytop_host::output::names::regime;

/// Counts and greatest errors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    /// Number of inputs in range that were launched.
    pub moving: u64,
    /// Number of inputs in range that were refused, by the name of the parameter.
    pub refused: BTreeMap<&'static str, u64>,
    /// Number of inputs outside the range, which were all refused.
    pub beyond: u64,
    /// Results by regime.
    pub regimes: BTreeMap<&'static str, Regime>,
    /// Failures, which must not happen.
    pub failures: Vec<String>,
}

/// Results of one regime.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Regime {
    /// Number of motions.
    pub motions: u64,
    /// Number of motions that were compared with the truth.
    pub with_truth: u64,
    /// Greatest change of Φ by the last place of the input, rad.
    pub sensitivity: f64,
    /// Results by scalar.
    pub scalars: [Side; 4],
}

/// Results of one scalar.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Side {
    /// Number of motions for which no table is large enough.
    pub no_fit: u64,
    /// Number of motions with a norm or a turning point beyond the bound.
    pub checks_violated: u64,
    /// Number of motions with an error beyond the bound.
    pub violated: u64,
    /// Greatest error of norm and turning points, as a share of the bound.
    pub checks_of_bound: f64,
    /// Greatest drift of energy and momenta.
    pub drift: f64,
    /// Greatest error, rad.
    pub error: f64,
    /// Greatest error as a share of the bound.
    pub of_bound: f64,
    /// Greatest error in units of a rounding of the scalar plus the change by the last place of the input.
    pub of_condition: f64,
    /// Greatest error of the rates, as a share of the greatest angular speed.
    pub rates: f64,
    /// Greatest error of the rates, as a share of their bound.
    pub rates_of_bound: f64,
    /// Number of motions with an error of the rates beyond their bound.
    pub rates_violated: u64,
    /// Number of motions that were compared with the truth, number of those whose bound is at most ten times their greatest error, and number
    /// of those whose bound on the rates is at most ten times the error of the rates.
    pub judged: [u64; 3],
    /// Number of places of these motions, and number of those at which more than half of the bound comes from the number of ticks.
    pub places: [u64; 2],
}

/// Least share of the bound for an error that counts as close to it.
const CLOSE: f64 = 0.1;

/// Greatest number of failures in a report.
const REPORTED: usize = 20;

impl Tally {
    /// Adds the outcome of an input in range.
    pub(crate) fn add(&mut self, name: &dyn std::fmt::Display, outcome: &Outcome) {
        let (kind, kept, sensitivity) = match outcome {
            Outcome::Refused(error) => {
                *self.refused.entry(error.parameter()).or_default() += 1;
                return;
            }
            Outcome::Moves { regime: kind, kept, sensitivity } => (regime(*kind), kept, sensitivity),
        };
        self.moving += 1;
        let regime = self.regimes.entry(kind).or_default();
        regime.motions += 1;
        regime.with_truth += u64::from(sensitivity.is_some());
        regime.sensitivity = regime.sensitivity.max(sensitivity.unwrap_or(0.0));
        for ((side, kept), (scalar, _)) in regime.scalars.iter_mut().zip(kept.iter()).zip(SCALARS) {
            let before = side.beyond_bound();
            side.add(kept);
            if side.beyond_bound() > before {
                let checks_of_bound = kept.map_or(0.0, |kept| kept.checks_of_bound);
                let error = kept.and_then(|kept| kept.error).unwrap_or_default();
                self.failures.push(format!(
                    "{scalar}, {kind}: norm and turning points at {checks_of_bound:.2}, error at {:.2} of the bound at tick {} (greatest {:.1e} rad), rates at {:.2} of theirs at tick {}: {name}",
                    error.of_bound, error.tick, error.error, error.rates_of_bound, error.rates_tick
                ));
            }
        }
    }

    /// Sum with the tally of another thread.
    #[must_use]
    pub(crate) fn merged(mut self, other: Self) -> Self {
        self.moving += other.moving;
        self.beyond += other.beyond;
        for (parameter, count) in other.refused {
            *self.refused.entry(parameter).or_default() += count;
        }
        for (name, regime) in other.regimes {
            self.regimes.entry(name).or_default().merge(&regime);
        }
        self.failures.extend(other.failures);
        self
    }

    /// Sum over all regimes of the scalar with this index in [`SCALARS`].
    #[must_use]
    pub(crate) fn of_scalar(&self, scalar: usize) -> Side {
        let mut side = Side::default();
        self.regimes.values().for_each(|regime| side.merge(&regime.scalars[scalar]));
        side
    }

    /// Number of motions that were compared with the truth.
    #[must_use]
    pub(crate) fn truths(&self) -> u64 {
        self.regimes.values().map(|regime| regime.with_truth).sum()
    }

    /// Lines for the first failures, and one with the number of the others.
    #[must_use]
    pub(crate) fn report(&self) -> Vec<String> {
        let more = self.failures.len().saturating_sub(REPORTED);
        let rest = (more > 0).then(|| format!("and {more} more"));
        self.failures.iter().take(REPORTED).map(|failure| format!("FAILURE: {failure}")).chain(rest).collect()
    }
}

impl Regime {
    fn merge(&mut self, other: &Self) {
        self.motions += other.motions;
        self.with_truth += other.with_truth;
        self.sensitivity = self.sensitivity.max(other.sensitivity);
        self.scalars.iter_mut().zip(&other.scalars).for_each(|(side, other)| side.merge(other));
    }
}

impl Side {
    fn add(&mut self, kept: &Option<Kept>) {
        let Some(Kept { checks_of_bound, drift, error }) = *kept else {
            self.no_fit += 1;
            return;
        };
        let judged = u64::from(error.is_some());
        let error = error.unwrap_or_default();
        self.merge(&Self {
            no_fit: 0,
            checks_violated: u64::from(checks_of_bound > 1.0),
            violated: u64::from(error.of_bound > 1.0),
            checks_of_bound,
            drift,
            error: error.error,
            of_bound: error.of_bound,
            of_condition: error.of_condition,
            rates: error.rates,
            rates_of_bound: error.rates_of_bound,
            rates_violated: u64::from(error.rates_of_bound > 1.0),
            judged: [judged, u64::from(error.of_bound >= CLOSE), u64::from(error.rates_of_bound >= CLOSE)],
            places: error.places,
        });
    }

    /// Number of motions with an error of the orientation or of the rates, or of norm or turning points, beyond its bound.
    #[must_use]
    pub(crate) fn beyond_bound(&self) -> u64 {
        self.checks_violated + self.violated + self.rates_violated
    }

    /// Adds the results of another regime or seed.
    pub(crate) fn merge(&mut self, other: &Self) {
        self.judged.iter_mut().zip(other.judged).for_each(|(sum, more)| *sum += more);
        self.places.iter_mut().zip(other.places).for_each(|(sum, more)| *sum += more);
        self.rates_violated += other.rates_violated;
        self.rates = self.rates.max(other.rates);
        self.rates_of_bound = self.rates_of_bound.max(other.rates_of_bound);
        self.no_fit += other.no_fit;
        self.checks_violated += other.checks_violated;
        self.violated += other.violated;
        self.checks_of_bound = self.checks_of_bound.max(other.checks_of_bound);
        self.drift = self.drift.max(other.drift);
        self.error = self.error.max(other.error);
        self.of_bound = self.of_bound.max(other.of_bound);
        self.of_condition = self.of_condition.max(other.of_condition);
    }
}

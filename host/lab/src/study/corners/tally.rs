//! What many trials add up to.

use super::reading::SCALARS;
use super::trial::{Kept, Outcome};
use std::collections::BTreeMap;
use toytop_host::output::names::regime;

/// Counts and greatest errors.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Inputs in range: how many move, and how many are refused, by the name of the parameter.
    pub moving: u64,
    /// Refused by a launch, by parameter.
    pub refused: BTreeMap<&'static str, u64>,
    /// Inputs beyond the range, all refused.
    pub beyond: u64,
    /// By regime.
    pub regimes: BTreeMap<&'static str, Regime>,
    /// What must not happen.
    pub failures: Vec<String>,
}

/// One regime.
#[derive(Clone, Copy, Debug, Default)]
pub struct Regime {
    /// Motions.
    pub motions: u64,
    /// Of which the truth was asked.
    pub with_truth: u64,
    /// The greatest change of Φ by the last place of the input, rad.
    pub sensitivity: f64,
    /// By scalar.
    pub scalars: [Side; 4],
}

/// One scalar.
#[derive(Clone, Copy, Debug, Default)]
pub struct Side {
    /// Typed: no table fits.
    pub no_fit: u64,
    /// Norm or turning points beyond the bound.
    pub astray: u64,
    /// An error beyond the bound.
    pub violated: u64,
    /// Norm and turning points, as a share of the bound.
    pub strain: f64,
    /// Of energy and momenta.
    pub drift: f64,
    /// rad.
    pub error: f64,
    /// As a share of the bound.
    pub of_bound: f64,
    /// In units of a rounding of the scalar and what one of the input does.
    pub of_condition: f64,
    /// Error of the rates, as a share of the greatest angular speed.
    pub rates: f64,
    /// Error of the rates, as a share of their bound.
    pub rates_of_bound: f64,
    /// Errors of the rates beyond their bound.
    pub rates_violated: u64,
    /// Motions held against the truth, those of them whose bound is at most ten times their greatest error, and those
    /// whose bound on the rates is.
    pub judged: [u64; 3],
    /// Places of those motions, and those of them at which more than half of the bound comes from the number of ticks.
    pub places: [u64; 2],
}

/// Errors of at least this share of the bound are close to it.
const CLOSE: f64 = 0.1;

/// Failures that are told one by one.
const TOLD: usize = 20;

impl Tally {
    /// Adds what became of an input in range.
    pub fn add(&mut self, name: &dyn std::fmt::Display, outcome: &Outcome) {
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
                let strain = kept.map_or(0.0, |kept| kept.strain);
                let error = kept.and_then(|kept| kept.error).unwrap_or_default();
                self.failures.push(format!(
                    "{scalar}, {kind}: norm and turning points at {strain:.2}, error at {:.2} of the bound at tick {} (greatest {:.1e} rad), rates at {:.2} of theirs at tick {}: {name}",
                    error.of_bound, error.tick, error.error, error.rates_of_bound, error.rates_tick
                ));
            }
        }
    }

    /// Adds what another thread has.
    #[must_use]
    pub fn merged(mut self, other: Self) -> Self {
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

    /// All regimes of one scalar, by its place in [`SCALARS`].
    #[must_use]
    pub fn of_scalar(&self, scalar: usize) -> Side {
        let mut side = Side::default();
        self.regimes.values().for_each(|regime| side.merge(&regime.scalars[scalar]));
        side
    }

    /// Motions held against the truth.
    #[must_use]
    pub fn truths(&self) -> u64 {
        self.regimes.values().map(|regime| regime.with_truth).sum()
    }

    /// What must not happen, so many of them in words.
    #[must_use]
    pub fn told(&self) -> Vec<String> {
        let more = self.failures.len().saturating_sub(TOLD);
        let rest = (more > 0).then(|| format!("and {more} more"));
        self.failures.iter().take(TOLD).map(|failure| format!("FAILURE: {failure}")).chain(rest).collect()
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
        let Some(Kept { strain, drift, error }) = *kept else {
            self.no_fit += 1;
            return;
        };
        let judged = u64::from(error.is_some());
        let error = error.unwrap_or_default();
        self.merge(&Self {
            no_fit: 0,
            astray: u64::from(strain > 1.0),
            violated: u64::from(error.of_bound > 1.0),
            strain,
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

    /// Motions of which an error, of the orientation or of the rates, or a check is beyond its bound.
    #[must_use]
    pub fn beyond_bound(&self) -> u64 {
        self.astray + self.violated + self.rates_violated
    }

    /// Adds what another regime or seed has.
    pub fn merge(&mut self, other: &Self) {
        self.judged.iter_mut().zip(other.judged).for_each(|(sum, more)| *sum += more);
        self.places.iter_mut().zip(other.places).for_each(|(sum, more)| *sum += more);
        self.rates_violated += other.rates_violated;
        self.rates = self.rates.max(other.rates);
        self.rates_of_bound = self.rates_of_bound.max(other.rates_of_bound);
        self.no_fit += other.no_fit;
        self.astray += other.astray;
        self.violated += other.violated;
        self.strain = self.strain.max(other.strain);
        self.drift = self.drift.max(other.drift);
        self.error = self.error.max(other.error);
        self.of_bound = self.of_bound.max(other.of_bound);
        self.of_condition = self.of_condition.max(other.of_condition);
    }
}

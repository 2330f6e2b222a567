//! `toytop-lab corners`: random launches near every degenerate case. Each keeps its error bound or is refused with a typed error.

mod inputs;
mod trial;

use crate::{Found, Study};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use toytop_host::input::random::Random;
use toytop_host::motion::Scalar;
use toytop_host::output::Record;
use toytop_host::output::names::regime;
use toytop_host::{Failure, thread_pool};
use trial::Errors;

/// Reciprocal of the share of inputs outside the allowed range.
const ONE_BEYOND_IN: u64 = 64;
/// Name of the rows for the motions of all regimes.
const ALL: &str = "all";

/// Results of many launches.
#[derive(Default)]
struct Tally {
    /// Errors by regime, for each scalar.
    regimes: BTreeMap<&'static str, [Errors; 4]>,
    /// Number of inputs in range that were refused, by the name of the parameter.
    refused: BTreeMap<&'static str, u64>,
    /// Number of inputs outside the range, all of them refused.
    beyond: u64,
    failures: Vec<String>,
}

pub fn run(study: &Study, truths: u64) -> Result<Found, Failure> {
    let cores = thread_pool::of_all_cores()?;
    let add = |tally: &mut Tally, launch| tally.add(study, truths, launch);
    let tally = thread_pool::tally(&cores, (study.motions, "launches"), add, Tally::merged);
    let refused: u64 = tally.refused.values().sum();
    let headline = format!(
        "toytop {}, seed {}: {} launches; refused in range: {refused} {:?}; beyond the range: {}, all refused; failures: {}.",
        env!("CARGO_PKG_VERSION"),
        study.seed,
        study.motions,
        tally.refused.keys().collect::<Vec<_>>(),
        tally.beyond,
        tally.failures.len(),
    );
    let rows = tally.regimes.iter().flat_map(|(regime, errors)| {
        Scalar::ALL.iter().zip(errors).map(|(scalar, errors)| row(regime, scalar.name(), errors))
    });
    Ok(Found { headline, rows: rows.collect(), failures: tally.failures })
}

impl Tally {
    /// Draws the launch of this number and tries it.
    fn add(&mut self, study: &Study, truths: u64, launch: u64) {
        let mut random = Random::new(study.seed, launch);
        if random.one_in(ONE_BEYOND_IN) {
            let input = inputs::beyond(&mut random);
            match input.motion() {
                Ok(_) => self.failures.push(format!("{launch}: beyond the range, but launched: {input}")),
                Err(_) => self.beyond += 1,
            }
            return;
        }
        let input = inputs::random(&mut random);
        // launches are independent, so that those with the truth may be spread evenly
        let with_truth = launch.is_multiple_of((study.motions / truths).max(1));
        match catch_unwind(AssertUnwindSafe(|| trial::run(&input, &mut random, with_truth))) {
            Ok(Ok((kind, errors))) => {
                for (scalar, errors) in Scalar::ALL.iter().zip(&errors).filter(|(_, it)| it.beyond_bound > 0)
                {
                    self.failures.push(format!("{launch}: {}: {errors:?}: {input}", scalar.name()));
                }
                for name in [regime(kind), ALL] {
                    merge(self.regimes.entry(name).or_default(), &errors);
                }
            }
            Ok(Err(refusal)) => *self.refused.entry(refusal.parameter()).or_default() += 1,
            Err(_) => self.failures.push(format!("{launch}: panicked: {input}")),
        }
    }

    /// Sum with the tally of another thread.
    fn merged(mut self, other: Self) -> Self {
        for (name, errors) in &other.regimes {
            merge(self.regimes.entry(name).or_default(), errors);
        }
        for (parameter, count) in other.refused {
            *self.refused.entry(parameter).or_default() += count;
        }
        self.beyond += other.beyond;
        self.failures.extend(other.failures);
        self
    }
}

fn merge(sums: &mut [Errors; 4], more: &[Errors; 4]) {
    sums.iter_mut().zip(more).for_each(|(sum, more)| sum.add(more));
}

fn row(regime: &str, scalar: &str, errors: &Errors) -> Record {
    let truth = |x: f64| (errors.truths > 0).then_some(x);
    let share = |count: u64| truth(count as f64 / errors.truths as f64);
    Record::default()
        .with("regime", regime)
        .with("scalar", scalar)
        .with("motions", errors.motions)
        .with("no_table", errors.no_table)
        .with("norm_and_height_of_bound", errors.norm_and_height)
        .with("truths", errors.truths)
        .with("places", errors.places)
        .with("places_by_ticks", errors.places_by_ticks)
        .with("error_rad", truth(errors.error))
        .with("error_of_bound", truth(errors.of_bound))
        .with("bound_within_hundred", share(errors.close))
        .with("rate_error_of_bound", truth(errors.rates_of_bound))
        .with("rate_bound_within_hundred", share(errors.rates_close))
        .with("beyond_bound", errors.beyond_bound)
}

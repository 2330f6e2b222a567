//! `toytop-lab fit`: launches fitted to simulated samples.

mod launches;

use crate::{Found, Study};
use launches::{Outcome, SETS, run as trial};
use std::collections::BTreeMap;
use toytop_host::input::random::Random;
use toytop_host::output::Record;
use toytop_host::{Failure, thread_pool};

/// Results of the launches with one set of sensors.
#[derive(Default)]
struct Sums {
    converged: u64,
    covered: u64,
    /// Sum of the squares of the normalised errors, and of the numbers of directions that the samples determine.
    squares: f64,
    freedom: u64,
    wrong: Vec<u64>,
    refused: BTreeMap<String, u64>,
}

pub fn run(study: &Study) -> Result<Found, Failure> {
    let cores = thread_pool::of_all_cores()?;
    let add = |sums: &mut [Sums; 3], launch| {
        for (set, sums) in sums.iter_mut().enumerate() {
            sums.add(study.seed, launch, set);
        }
    };
    let sums = thread_pool::tally(&cores, (study.motions, "launches"), add, merged);
    let wrong = |(name, sums): (&&str, &Sums)| {
        let launches: Vec<_> = sums.wrong.iter().take(20).collect();
        (!launches.is_empty()).then(|| format!("{name}: accepted, but wrong: launches {launches:?}"))
    };
    Ok(Found {
        headline: format!("{} launches of each set, seed {}.", study.motions, study.seed),
        rows: SETS.iter().zip(&sums).map(|(name, sums)| sums.row(name)).collect(),
        failures: SETS.iter().zip(&sums).filter_map(wrong).collect(),
    })
}

fn merged(mut sums: [Sums; 3], more: [Sums; 3]) -> [Sums; 3] {
    for (sums, more) in sums.iter_mut().zip(more) {
        sums.converged += more.converged;
        sums.covered += more.covered;
        sums.squares += more.squares;
        sums.freedom += more.freedom;
        sums.wrong.extend(more.wrong);
        for (reason, count) in more.refused {
            *sums.refused.entry(reason).or_default() += count;
        }
    }
    sums
}

impl Sums {
    fn add(&mut self, seed: u64, launch: u64, set: usize) {
        let stream = 3 * launch + set as u64;
        let noise = seed.wrapping_mul(1_000_003).wrapping_add(stream);
        match trial(&mut Random::new(seed, stream), set, noise) {
            Outcome::Good { square, freedom, covered } => {
                self.converged += 1;
                self.covered += u64::from(covered);
                self.squares += square;
                self.freedom += freedom as u64;
            }
            Outcome::Wrong => self.wrong.push(launch),
            Outcome::Refused(reason) => *self.refused.entry(reason).or_default() += 1,
        }
    }

    fn row(&self, name: &str) -> Record {
        let refused: Vec<_> =
            self.refused.iter().map(|(reason, count)| format!("{count} {reason}")).collect();
        Record::default()
            .with("sensors", name)
            .with("not_converged", refused.join("; "))
            .with("converged", self.converged)
            .with("wrong", self.wrong.len())
            .with("in_the_95_percent_ellipsoid", self.covered as f64 / self.converged as f64)
            .with("rms_error_of_bound", (self.squares / self.freedom as f64).sqrt())
    }
}

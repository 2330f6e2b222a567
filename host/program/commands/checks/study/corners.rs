//! `toytop study corners`: random launches near every degenerate case. Each keeps its error bound or is refused with a typed error.

mod random_launch;
mod trial;

use super::{StudyOptions, Summary};
use crate::terminal::parallel::map_with_progress;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use toytop_host::Failure;
use toytop_host::motion::Scalar;
use toytop_host::motion::errors::greater_or_infinite;
use trial::{TableErrors, Trial};

pub fn run(study: &StudyOptions, truths: u64) -> Result<Summary<Row>, Failure> {
    // launches are independent, so that those with the truth may be spread evenly
    let spacing = (study.motions / truths).max(1);
    let trial = |launch: u64| trial::run(study.seed, launch, launch.is_multiple_of(spacing));
    let (mut regimes, mut launched) = (BTreeMap::<_, usize>::new(), Vec::new());
    let (mut refused, mut refusals, mut failures) = (BTreeSet::new(), 0, Vec::new());
    for (launch, tried) in map_with_progress(study.motions, "launches", trial)?.into_iter().enumerate() {
        match tried {
            Err(refusal) => {
                refusals += 1;
                refused.insert(refusal.parameter());
            }
            Ok(Trial { input, regime, tables }) => {
                for (scalar, errors) in Scalar::ALL.iter().zip(&tables) {
                    if let Some(errors) = errors.filter(TableErrors::beyond_bound) {
                        failures.push(format!("{launch}: {}: {errors:?}: {input:?}", scalar.name()));
                    }
                }
                *regimes.entry(toytop_model::constants::regime(regime)).or_default() += 1;
                launched.push(tables);
            }
        }
    }
    let regimes: Vec<_> = regimes.iter().map(|(regime, motions)| format!("{motions} {regime}")).collect();
    let headline = format!(
        "toytop {}, seed {}: {} launches ({}); refused: {refusals} ({}); failures: {}.",
        env!("CARGO_PKG_VERSION"),
        study.seed,
        study.motions,
        regimes.join(", "),
        Vec::from_iter(refused).join(", "),
        failures.len(),
    );
    let row = |(index, scalar): (usize, &Scalar)| {
        let tables: Vec<_> = launched.iter().map(|tables| tables[index]).collect();
        Row::new(scalar.name(), &tables)
    };
    let rows = Scalar::ALL.iter().enumerate().map(row).collect();
    Ok(Summary { headline, rows, failures })
}

/// Least share of the bound for an error that counts as close to it.
const CLOSE: f64 = 0.01;

/// Tables of one scalar. The names are the keys of JSON.
#[derive(Serialize)]
pub struct Row {
    scalar: &'static str,
    motions: usize,
    /// Number of motions for which no table is large enough.
    no_table: usize,
    norm_error_over_bound: f64,
    /// Number of motions that were compared with the truth.
    compared_motions: usize,
    compared_ticks: usize,
    distant_ticks: usize,
    error_rad: Option<f64>,
    error_over_bound: Option<f64>,
    /// Share of the compared motions whose error is close to its bound.
    tight_bounds: Option<f64>,
    rate_error_over_bound: Option<f64>,
    tight_rate_bounds: Option<f64>,
    /// Number of motions with an error beyond its bound.
    beyond_bound: usize,
}

impl Row {
    /// * `tables`: `None` for a motion for which no table is large enough
    fn new(scalar: &'static str, tables: &[Option<TableErrors>]) -> Self {
        let errors: Vec<_> = tables.iter().flatten().collect();
        let compared: Vec<_> = errors.iter().filter(|errors| errors.ticks > 0).collect();
        let truths = compared.len();
        let greatest = |error: fn(&TableErrors) -> f64| {
            errors.iter().map(|errors| error(errors)).fold(0.0, greater_or_infinite)
        };
        let truth = |error| (truths > 0).then(|| greatest(error));
        let close = |error: fn(&TableErrors) -> f64| {
            let close = compared.iter().filter(|errors| error(errors) >= CLOSE).count();
            (truths > 0).then(|| close as f64 / truths as f64)
        };
        Self {
            scalar,
            motions: tables.len(),
            no_table: tables.len() - errors.len(),
            norm_error_over_bound: greatest(|errors| errors.norm_over_bound),
            compared_motions: truths,
            compared_ticks: compared.iter().map(|errors| errors.ticks).sum(),
            distant_ticks: compared.iter().map(|errors| errors.distant_ticks).sum(),
            error_rad: truth(|errors| errors.error),
            error_over_bound: truth(|errors| errors.error_over_bound),
            tight_bounds: close(|errors| errors.error_over_bound),
            rate_error_over_bound: truth(|errors| errors.rate_error_over_bound),
            tight_rate_bounds: close(|errors| errors.rate_error_over_bound),
            beyond_bound: errors.iter().filter(|errors| errors.beyond_bound()).count(),
        }
    }
}

//! `toytop-lab study --corners`: random launches near every degenerate case.

mod scalars;
mod seeds;

use crate::cli::StudyArgs;
use crate::study::corners::input::Input;
use crate::study::corners::reading::SCALARS;
use crate::study::corners::tally::{Regime, Side, Tally};
use crate::study::corners::trial;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use toytop_host::Failure;
use toytop_host::Report;
use toytop_host::cli::Format;
use toytop_host::input::random::Random;
use toytop_host::output::doc_markers;
use toytop_host::output::{self, Cell, Record};
use toytop_host::thread_pool;

/// Reciprocal of the share of inputs outside the allowed range.
const ONE_BEYOND_IN: u64 = 64;

pub(super) fn run(arguments: &StudyArgs) -> Result<Report, Failure> {
    if let Some(path) = &arguments.docs {
        // a missing place in the page is reported before the computation
        doc_markers::check(path, "--docs", MARK)?;
    }
    let cores = thread_pool::of_all_cores()?;
    let seeds: Vec<_> = (0..arguments.seeds).map(|i| arguments.seed.wrapping_add(i)).collect();
    let of_seed = |&seed: &u64| {
        let add = |tally: &mut Tally, stream| add(tally, arguments, seed, stream);
        (seed, thread_pool::tally(&cores, (arguments.count(), "launches"), add, Tally::merged))
    };
    let tallies: Vec<_> = seeds.iter().map(of_seed).collect();
    let of_seeds: Vec<_> = tallies.iter().map(|(seed, tally)| seeds::record(*seed, tally)).collect();
    let tally = tallies.into_iter().map(|(_, tally)| tally).fold(Tally::default(), Tally::merged);
    let of_scalars = scalars::records(&tally);
    let of_regimes: Vec<_> = tally.regimes.iter().flat_map(|(name, regime)| records(name, regime)).collect();

    let headline = headline(arguments, &tally);
    let tables = [seeds::rows(&of_seeds), scalars::rows(&of_scalars), rows(&of_regimes)];
    let text = match arguments.format {
        Format::Table => {
            let [of_seeds, of_scalars, of_regimes] = tables.clone();
            let columns = [
                output::columns(of_seeds, 0),
                output::columns(of_scalars, 1),
                output::columns(of_regimes, 2),
            ];
            format!("{headline}\n{}", columns.join("\n"))
        }
        Format::Csv => output::csv(&of_regimes).map_err(Failure::Output)?,
        Format::Json => {
            let parts = [("seeds", &of_seeds), ("scalars", &of_scalars), ("rows", &of_regimes)];
            output::json(&BTreeMap::from(parts)).map_err(Failure::Output)?
        }
    };
    if let Some(path) = &arguments.docs {
        let tables: Vec<_> = tables.iter().map(|rows| doc_markers::table(rows)).collect();
        doc_markers::write(path, "--docs", MARK, &format!("{headline}\n\n{}", tables.join("\n")))?;
    }
    let missed = !tally.failures.is_empty();
    let below = arguments.format == Format::Table;
    Ok(Report { text, missed, ..Report::default() }.with_remarks(tally.report(), below))
}

const MARK: &str = "toytop-lab study: corners";

fn add(tally: &mut Tally, arguments: &StudyArgs, seed: u64, stream: u64) {
    let mut random = Random::new(seed, stream);
    if random.one_in(ONE_BEYOND_IN) {
        let input = Input::beyond(&mut random);
        match input.motion() {
            Ok(_) => tally
                .failures
                .push(format!("seed {seed}, launch {stream}: beyond the range, but launched: {input}")),
            Err(_) => tally.beyond += 1,
        }
        return;
    }
    let input = Input::random(&mut random);
    // launches are independent, so that those with the truth may be spread evenly
    let with_truth = stream.is_multiple_of((arguments.count() / arguments.truths).max(1));
    let trial = || trial::run(&input, &mut random, with_truth);
    match catch_unwind(AssertUnwindSafe(trial)) {
        Ok(outcome) => tally.add(&input, &outcome),
        Err(_) => tally.failures.push(format!("seed {seed}, launch {stream}: panicked: {input}")),
    }
}

fn headline(arguments: &StudyArgs, tally: &Tally) -> String {
    let refused: Vec<_> = tally.refused.iter().map(|(name, count)| format!("{count} for {name}")).collect();
    let refused = if refused.is_empty() { "none".to_owned() } else { refused.join(", ") };
    let truths = tally.truths();
    let last = arguments.seed.wrapping_add(arguments.seeds - 1);
    let seeds = match arguments.seeds {
        1 => format!("seed {last}: {} launches", arguments.count()),
        _ => format!("seeds {} to {last}: {} launches each", arguments.seed, arguments.count()),
    };
    format!(
        "toytop {}, {seeds}; {} move, {truths} of them compared with the truth; refused in range: {refused}; \
         beyond the range: {}, all refused; failures: {}.",
        env!("CARGO_PKG_VERSION"),
        tally.moving,
        tally.beyond,
        tally.failures.len(),
    )
}

fn records(name: &'static str, regime: &Regime) -> Vec<Record> {
    let record = |((scalar, _), side): ((&str, f64), &Side)| {
        let truth = |x: f64| (regime.with_truth > 0 && side.no_fit < regime.motions).then_some(x);
        Record(vec![
            ("regime", Cell::Text(name.to_owned())),
            ("scalar", Cell::Text(scalar.to_owned())),
            ("motions", Cell::Count(regime.motions)),
            ("no_table", Cell::Count(side.no_fit)),
            ("checks_of_bound", Cell::Number(side.checks_of_bound)),
            ("drift", side_drift(scalar, side)),
            ("truths", Cell::Count(regime.with_truth)),
            ("error_rad", truth(side.error).into()),
            ("error_of_bound", truth(side.of_bound).into()),
            ("last_place_rad", Cell::Number(regime.sensitivity)),
            ("error_of_condition", truth(side.of_condition).into()),
            ("rate_error", truth(side.rates).into()),
            ("rate_error_of_bound", truth(side.rates_of_bound).into()),
            ("beyond_bound", Cell::Count(side.beyond_bound())),
        ])
    };
    SCALARS.into_iter().zip(&regime.scalars).map(record).collect()
}

/// Drift of the first integrals; absent in fixed point, which cannot represent ω.
fn side_drift(scalar: &str, side: &Side) -> Cell {
    if scalar.starts_with('q') { Cell::Absent } else { Cell::Number(side.drift) }
}

/// Headings of the table, for the keys of the records.
const HEADER: [&str; 14] = [
    "regime",
    "scalar",
    "motions",
    "no table",
    "norm, turning points / bound",
    "drift of l, n, h",
    "truths",
    "error, rad",
    "error / bound",
    "last place of input, rad",
    "error / condition",
    "error of the rates / greatest rate",
    "error of the rates / bound",
    "beyond bound",
];

/// Header and rows of the table.
fn rows(records: &[Record]) -> Vec<Vec<String>> {
    text(&HEADER, records)
}

/// Header and rows of a table, with shares to two places and other numbers to one digit.
fn text(header: &[&str], records: &[Record]) -> Vec<Vec<String>> {
    let cell = |(name, cell): &(&str, Cell)| match cell {
        Cell::Text(text) => text.replace('_', " "),
        Cell::Count(count) => count.to_string(),
        Cell::Number(x) if name.contains("_of_") => format!("{x:.2}"),
        Cell::Number(x) => format!("{x:.0e}"),
        _ => "-".to_owned(),
    };
    let header = header.iter().map(|&name| name.to_owned()).collect();
    std::iter::once(header).chain(records.iter().map(|record| record.0.iter().map(cell).collect())).collect()
}

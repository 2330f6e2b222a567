//! `toytop study --corners`: launches towards every degenerate corner.

use super::Report;
use crate::Failure;
use crate::cli::{Format, StudyArgs};
use crate::cores;
use crate::marked;
use crate::output::{self, Cell, Record};
use crate::study::corners::input::Input;
use crate::study::corners::reading::SCALARS;
use crate::study::corners::tally::{Regime, Side, Tally};
use crate::study::corners::trial;
use crate::study::gauss::Rule;
use crate::study::random::Random;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// One input in so many is beyond the range.
const ONE_BEYOND_IN: u64 = 64;

pub(super) fn run(arguments: &StudyArgs) -> Result<Report, Failure> {
    if let Some(path) = &arguments.docs {
        // a place that is not there is told before the work, not after
        marked::check(path, "--docs", MARK)?;
    }
    let cores = cores::all()?;
    let rule = Rule::new();
    let add = |tally: &mut Tally, stream| add(tally, arguments, stream, &rule);
    let tally = cores::tally(&cores, (arguments.count(), "launches"), add, Tally::merged);

    let records: Vec<_> = tally.regimes.iter().flat_map(|(name, regime)| records(name, regime)).collect();
    let text = match arguments.format {
        Format::Table => format!("{}\n{}", headline(arguments, &tally), output::columns(rows(&records), 2)),
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records).map_err(Failure::Output)?,
    };
    if let Some(path) = &arguments.docs {
        let body = format!("{}\n\n{}", headline(arguments, &tally), marked::table(&rows(&records)));
        marked::write(path, "--docs", MARK, &body)?;
    }
    let missed = !tally.failures.is_empty();
    let below = arguments.format == Format::Table;
    Ok(Report { text, missed, ..Report::default() }.with_remarks(tally.told(), below))
}

const MARK: &str = "toytop study: corners";

fn add(tally: &mut Tally, arguments: &StudyArgs, stream: u64, rule: &Rule) {
    let mut random = Random::new(arguments.seed, stream);
    if random.one_in(ONE_BEYOND_IN) {
        let input = Input::beyond(&mut random);
        match input.motion() {
            Ok(_) => tally.failures.push(format!("launch {stream}: beyond the range, but launched: {input}")),
            Err(_) => tally.beyond += 1,
        }
        return;
    }
    let input = Input::random(&mut random);
    // launches are independent: every so many is as good as any
    let with_truth = stream.is_multiple_of((arguments.count() / arguments.truths).max(1));
    let trial = || trial::run(&input, &mut random, with_truth.then_some(rule));
    match catch_unwind(AssertUnwindSafe(trial)) {
        Ok(outcome) => tally.add(&input, &outcome),
        Err(_) => tally.failures.push(format!("launch {stream}: panicked: {input}")),
    }
}

fn headline(arguments: &StudyArgs, tally: &Tally) -> String {
    let refused: Vec<_> = tally.refused.iter().map(|(name, count)| format!("{count} for {name}")).collect();
    let refused = if refused.is_empty() { "none".to_owned() } else { refused.join(", ") };
    let truths: u64 = tally.regimes.values().map(|regime| regime.with_truth).sum();
    format!(
        "toytop {}, seed {}: {} launches; {} move, {truths} of them held against the truth; refused in range: {refused}; \
         beyond the range: {}, all refused; failures: {}.",
        env!("CARGO_PKG_VERSION"),
        arguments.seed,
        arguments.count(),
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
            ("checks_of_bound", Cell::Number(side.strain)),
            ("drift", side_drift(scalar, side)),
            ("truths", Cell::Count(regime.with_truth)),
            ("error_rad", truth(side.error).into()),
            ("error_of_bound", truth(side.of_bound).into()),
            ("last_place_rad", Cell::Number(regime.sensitivity)),
            ("error_of_condition", truth(side.of_condition).into()),
            ("beyond_bound", Cell::Count(side.violated + side.astray)),
        ])
    };
    SCALARS.into_iter().zip(&regime.scalars).map(record).collect()
}

/// Fixed point does not hold ω.
fn side_drift(scalar: &str, side: &Side) -> Cell {
    if scalar.starts_with('q') { Cell::Absent } else { Cell::Number(side.drift) }
}

/// For reading, what the keys of the records mean.
const HEADER: [&str; 12] = [
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
    "beyond bound",
];

/// Header and cells, for reading.
fn rows(records: &[Record]) -> Vec<Vec<String>> {
    let cell = |(name, cell): &(&str, Cell)| match cell {
        Cell::Text(text) => text.replace('_', " "),
        Cell::Count(count) => count.to_string(),
        Cell::Number(x) if name.contains("_of_") => format!("{x:.2}"),
        Cell::Number(x) => format!("{x:.0e}"),
        _ => "-".to_owned(),
    };
    let header = HEADER.map(str::to_owned).to_vec();
    std::iter::once(header).chain(records.iter().map(|record| record.0.iter().map(cell).collect())).collect()
}

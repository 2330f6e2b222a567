//! `toytop-lab study --fit`: launches fitted to simulated samples.

use crate::cli::StudyArgs;
use crate::study::launches::{Outcome, SETS, run as trial};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use toytop_host::cli::Format;
use toytop_host::input::random::Random;
use toytop_host::output::{self, Cell, Record, doc_markers};
use toytop_host::{Failure, Report, thread_pool};

const MARK: &str = "toytop-lab study --fit: launches";

/// Throws of one set of sensors.
#[derive(Clone, Debug, Default)]
struct Side {
    good: u64,
    covered: u64,
    wrong: Vec<u64>,
    squares: f64,
    freedom: u64,
    refused: BTreeMap<&'static str, u64>,
}

type Tally = [Side; 3];

pub(super) fn run(arguments: &StudyArgs) -> Result<Report, Failure> {
    if let Some(path) = &arguments.docs {
        doc_markers::check(path, "--docs", MARK)?;
    }
    let cores = thread_pool::of_all_cores()?;
    let add = |tally: &mut Tally, stream| add(tally, arguments.seed, stream);
    let tally = thread_pool::tally(&cores, (arguments.count(), "launches"), add, merged);
    let records: Vec<_> = SETS.iter().zip(&tally).map(|(name, side)| record(name, side)).collect();
    let rows = rows(&records);
    let text = match arguments.format {
        Format::Table => {
            let head = format!("{} launches of each set, seed {}\n", arguments.count(), arguments.seed);
            format!("{head}{}{}", output::columns(rows.clone(), 1), wrong(&tally))
        }
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records).map_err(Failure::Output)?,
    };
    if let Some(path) = &arguments.docs {
        let head = format!("{} launches of each set, seed {}.\n\n", arguments.count(), arguments.seed);
        doc_markers::write(path, "--docs", MARK, &(head + &doc_markers::table(&rows)))?;
    }
    let missed = tally.iter().any(|side| !side.wrong.is_empty());
    Ok(Report { text, missed, ..Report::default() })
}

fn add(tally: &mut Tally, seed: u64, stream: u64) {
    for (set, side) in tally.iter_mut().enumerate() {
        let mut random = Random::new(seed, 3 * stream + set as u64);
        let noise = seed.wrapping_mul(1_000_003).wrapping_add(3 * stream + set as u64);
        match catch_unwind(AssertUnwindSafe(|| trial(&mut random, set, noise))) {
            Ok(outcome @ Outcome::Good { square, freedom }) => {
                side.good += 1;
                side.covered += u64::from(outcome.is_covered());
                side.squares += square;
                side.freedom += freedom as u64;
            }
            Ok(Outcome::Wrong) => side.wrong.push(stream),
            Ok(Outcome::NotConverged(reason)) => *side.refused.entry(reason).or_default() += 1,
            Err(_) => *side.refused.entry("panicked").or_default() += 1,
        }
    }
}

fn merged(a: Tally, b: Tally) -> Tally {
    let mut sides = a;
    for (side, other) in sides.iter_mut().zip(b) {
        side.good += other.good;
        side.covered += other.covered;
        side.wrong.extend(other.wrong);
        side.squares += other.squares;
        side.freedom += other.freedom;
        for (reason, count) in other.refused {
            *side.refused.entry(reason).or_default() += count;
        }
    }
    sides
}

fn record(name: &str, side: &Side) -> Record {
    let refused: Vec<_> = side.refused.iter().map(|(reason, count)| format!("{count} {reason}")).collect();
    Record(vec![
        ("sensors", Cell::Text(name.to_owned())),
        ("converged", Cell::Count(side.good)),
        ("wrong", Cell::Count(side.wrong.len() as u64)),
        ("refused", Cell::Text(refused.join(", "))),
        ("covered_by_95_percent", Cell::Number(side.covered as f64 / side.good as f64)),
        ("rms_error_by_bound", Cell::Number((side.squares / side.freedom as f64).sqrt())),
    ])
}

fn rows(records: &[Record]) -> Vec<Vec<String>> {
    let header =
        ["sensors", "converged", "wrong", "not converged", "in the 95 % ellipsoid", "RMS error / bound"];
    let cell = |cell: &Cell| match cell {
        Cell::Text(text) => text.clone(),
        Cell::Count(count) => count.to_string(),
        Cell::Number(x) => output::short(*x, 4),
        _ => String::new(),
    };
    let row = |Record(cells): &Record| cells.iter().map(|(_, value)| cell(value)).collect();
    std::iter::once(header.map(str::to_owned).to_vec()).chain(records.iter().map(row)).collect()
}

/// Lines with the numbers of the launches that are wrong and were accepted.
fn wrong(tally: &Tally) -> String {
    let line = |(name, side): (&&str, &Side)| {
        let streams: Vec<_> = side.wrong.iter().take(20).map(u64::to_string).collect();
        (!streams.is_empty()).then(|| format!("WRONG, {name}: launches {}\n", streams.join(" ")))
    };
    SETS.iter().zip(tally).filter_map(line).collect()
}

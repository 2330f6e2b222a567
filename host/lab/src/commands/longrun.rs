//! `toytop-lab longrun`: errors of steppers and cursors over very many ticks, forward and back, and of the full solver. The exit code is 1
//! if an error exceeds a stated bound.

use crate::cli::LongrunArgs;
use crate::longrun::{self, Row, TICKS_PER_PERIOD, decades};
use toytop_host::Failure;
use toytop_host::Report;
use toytop_host::cli::Format;
use toytop_host::output::doc_markers;
use toytop_host::output::{self, Cell, Record};

const MARK: &str = "toytop-lab longrun: errors";

pub(super) fn run(arguments: &LongrunArgs) -> Result<Report, Failure> {
    if let Some(path) = &arguments.docs {
        // a missing place in the page is reported before the computation
        doc_markers::check(path, "--docs", MARK)?;
    }
    let lines = longrun::run(arguments.ticks)?;
    let head = format!(
        "toytop {}: the paper's cusp, {} ticks, some {TICKS_PER_PERIOD} a period; errors in rad.",
        env!("CARGO_PKG_VERSION"),
        arguments.ticks
    );
    let rows = rows(&lines, arguments.ticks);
    if let Some(path) = &arguments.docs {
        doc_markers::write(path, "--docs", MARK, &format!("{head}\n\n{}", doc_markers::table(&rows)))?;
    }
    let records: Vec<_> = lines.iter().flat_map(records).collect();
    let text = match arguments.format {
        Format::Table => format!("{head}\n{}", output::columns(rows, 1)),
        Format::Csv => output::csv(&records).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &records).map_err(Failure::Output)?,
    };
    let missed = lines.iter().any(|line| line.of_bound.is_some_and(|share| share > 1.0));
    Ok(Report { text, missed, ..Report::default() })
}

/// Row for each method, with a column for each power of ten of ticks.
fn rows(lines: &[Row], ticks: u64) -> Vec<Vec<String>> {
    let decades = decades(ticks);
    let mut header = vec!["error after ... ticks, rad".to_owned()];
    let count = |ticks: &u64| {
        if 10_u64.pow(ticks.ilog10()) == *ticks {
            format!("{:.0e}", *ticks as f64)
        } else {
            ticks.to_string()
        }
    };
    header.extend(decades.iter().map(count));
    header.extend(["10^6 there and back", "greatest error / bound"].map(str::to_owned));
    let show = |error: Option<f64>| error.map_or("-".to_owned(), |error| format!("{error:.0e}"));
    let row = |line: &Row| {
        let at = |ticks: &u64| line.errors.iter().find(|(at, _)| at == ticks).map(|(_, error)| *error);
        let mut row = vec![line.name.clone()];
        row.extend(decades.iter().map(|ticks| show(at(ticks))));
        row.push(show(line.back));
        row.push(line.of_bound.map_or("-".to_owned(), |share| format!("{share:.2}")));
        row
    };
    std::iter::once(header).chain(lines.iter().map(row)).collect()
}

fn records(line: &Row) -> Vec<Record> {
    let record = |&(ticks, error): &(u64, f64)| {
        Record(vec![
            ("who", Cell::Text(line.name.clone())),
            ("ticks", Cell::Count(ticks)),
            ("error_rad", Cell::Number(error)),
            ("left_there_and_back_rad", line.back.into()),
            ("greatest_share_of_bound", line.of_bound.into()),
        ])
    };
    line.errors.iter().map(record).collect()
}

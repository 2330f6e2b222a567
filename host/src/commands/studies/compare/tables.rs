//! Tables of a comparison.

use super::bounds::steps_per_period;
use super::{Row, Run, SAMPLES};
use crate::motion::Scalar;
use crate::output::{self, Column, Record, two_digits};

/// Names of the errors: of the orientation, 2 √(|Δα|² + |Δβ|²), rad; of u; of the tip in units of s; of h, l and n as recomputed from
/// α, β and their rates, in units of their natural scales.
pub const ERRORS: [&str; 6] =
    ["max_orientation_error_rad", "max_u_error", "max_tip_error_per_s", "h_drift", "l_drift", "n_drift"];

/// Record of a row, whose keys are those of CSV and JSON.
pub fn record(row: &Row) -> Record {
    let (errors, run) = row.measured.as_ref().map(|(errors, run)| (errors, run)).unzip();
    let mut record = Record::default()
        .with("motion", &*row.motion)
        .with("scalar", row.scalar.name())
        .with("method", row.method.name());
    for (i, name) in ERRORS.into_iter().enumerate() {
        record = record.with(name, errors.map(|errors| errors[i]));
    }
    record
        .with("steps", run.and_then(|run| run.steps))
        .with("table", run.and_then(|run| run.table).map(|(size, _)| by(size)))
        .with("wall_time_s", run.map(|run| run.call * run.calls() as f64))
        .with("bound_rad", row.bound)
        .with("verdict", row.verdict())
}

/// Table with one row for each run.
pub fn all(rows: &[Row], periods: u32) -> String {
    let names = ["motion", "scalar", "method"].into_iter().chain(ERRORS).chain(["size"]);
    let headings = ["motion", "type", "method", "angle", "u", "tip", "h", "l", "n", "steps"];
    let mut columns: Vec<Column<'_>> =
        names.zip(headings).map(|(name, heading)| (name, heading, two_digits as fn(f64) -> String)).collect();
    columns.extend([
        ("ns", "ns", (|ns| format!("{ns:.0}")) as fn(f64) -> String),
        ("bound_rad", "bound", |bound| format!("{bound:.0e}")),
        ("verdict", "result", two_digits),
    ]);
    let size = |run: &Run| run.table.map_or_else(|| run.calls().to_string(), |(size, _)| by(size));
    let line = |row: &Row| {
        let run = row.measured.as_ref().map(|(_, run)| run);
        record(row).with("size", run.map(size)).with("ns", run.map(|run| 1e9 * run.call))
    };
    format!(
        "{}\nThe core against the full 3-D equations: greatest differences at {SAMPLES} times in a period over {periods} periods.\n\
         angle: 2 sqrt(|d alpha|^2 + |d beta|^2) in rad, not to exceed the bound; tip: in units of s; h, l, n: as recomputed\n\
         from alpha, beta and their rates, against their constants, relative. Steps a period: {} in f64,\n\
         {} in f32; of an ephemeris the segments x terms of its table. ns: a step or a look-up, the median of five runs.\n",
        output::aligned(&rows.iter().map(line).collect::<Vec<_>>(), &columns),
        steps_per_period(Scalar::F64),
        steps_per_period(Scalar::F32),
    )
}

/// Table with one row for each motion: the error of each run, the greatest share of a bound, the cost, and whether all bounds are kept.
pub fn summary(rows: &[Row], periods: u32) -> String {
    let mut motions = rows.chunk_by(|a, b| a.motion == b.motion).peekable();
    let mut header = vec!["motion".to_owned()];
    let mut method = "";
    for row in motions.peek().into_iter().copied().flatten() {
        let scalar = row.scalar.name();
        let is_first = method != row.method.name();
        method = row.method.name();
        header.push(if is_first { format!("{method}: {scalar}") } else { scalar.to_owned() });
    }
    header.extend(["of bound", "ns", "result"].map(str::to_owned));
    format!(
        "{}\nThe core against the full 3-D equations, at {SAMPLES} times in a period over {periods} periods: greatest\n\
         error of the orientation, rad; greatest error as a share of its bound; ns: a look-up in the\n\
         ephemeris of the slowest type, the median of five runs on this machine. Every run: --all.\n",
        output::columns(std::iter::once(header).chain(motions.map(summary_line)).collect(), 1),
    )
}

fn summary_line(rows: &[Row]) -> Vec<String> {
    let mut cells = vec![rows[0].motion.clone()];
    let (mut share, mut slowest) = (0.0_f64, 0.0_f64);
    for row in rows {
        let error = row.error();
        cells.push(error.map_or("-".to_owned(), |error| format!("{error:.0e}")));
        share = share.max(error.zip(row.bound).map_or(0.0, |(error, bound)| error / bound));
        let look_up = row.measured.as_ref().filter(|(_, run)| run.table.is_some());
        slowest = slowest.max(look_up.map_or(0.0, |(_, run)| 1e9 * run.call));
    }
    let has = |verdict: &&str| rows.iter().any(|row| row.verdict() == *verdict);
    let worst = ["MISS", "no fit"].into_iter().find(has).unwrap_or("ok");
    cells.extend([format!("{share:.2}"), format!("{slowest:.0}"), worst.to_owned()]);
    cells
}

fn by([segments, terms]: [usize; 2]) -> String {
    format!("{segments}x{terms}")
}

//! The rows of `compare` as a table to read and as records.

use super::bounds::steps_per_period;
use super::run::{Effort, SAMPLES};
use super::{Measured, Row};
use crate::cli::Scalar;
use crate::output::{self, Cell, Record};

pub(super) fn records(rows: &[Row]) -> Vec<Record> {
    rows.iter().map(record).collect()
}

fn record(row: &Row) -> Record {
    let number = |value: fn(&Measured) -> f64| Cell::from(row.measured.as_ref().map(value));
    let (steps, table) = match row.measured.map(|measured| measured.effort) {
        Some(Effort::Steps(steps)) => (Cell::Count(steps), Cell::Absent),
        Some(Effort::Table { size, .. }) => (Cell::Absent, Cell::Text(by(size))),
        None => (Cell::Absent, Cell::Absent),
    };
    Record(vec![
        ("motion", Cell::Text(row.motion.clone())),
        ("scalar", Cell::Text(row.scalar.name().to_owned())),
        ("method", Cell::Text(row.method.name().to_owned())),
        ("max_orientation_error_rad", number(|measured| measured.errors.orientation)),
        ("max_u_error", number(|measured| measured.errors.u)),
        ("max_tip_error_per_s", number(|measured| measured.errors.tip)),
        ("h_drift", number(|measured| measured.errors.integrals[2])),
        ("l_drift", number(|measured| measured.errors.integrals[0])),
        ("n_drift", number(|measured| measured.errors.integrals[1])),
        ("steps", steps),
        ("table", table),
        ("wall_time_s", number(|measured| measured.wall.as_secs_f64())),
        ("bound_rad", Cell::Number(row.bound)),
        ("verdict", Cell::Text(row.verdict().to_owned())),
    ])
}

const HEADER: [&str; 13] =
    ["motion", "type", "method", "angle", "u", "tip", "h", "l", "n", "steps", "ns each", "bound", ""];

pub(super) fn table(rows: &[Row], periods: u32) -> String {
    let header = HEADER.iter().map(|&name| name.to_owned()).collect();
    let lines = std::iter::once(header).chain(rows.iter().map(line)).collect();
    format!(
        "{}\nThe core against the full 3-D equations: greatest differences at {SAMPLES} moments a period over {periods} periods.\n\
         angle: 2 sqrt(|d alpha|^2 + |d beta|^2) in rad, not to exceed the bound; tip: in units of s; h, l, n: as recomputed\n\
         from alpha, beta and their rates, against their constants, relative. Steps a period: {} in f64,\n\
         {} in other types; of an ephemeris the segments x terms of its table. Each: a step or a look-up.\n",
        output::columns(lines, 3),
        steps_per_period(Scalar::F64),
        steps_per_period(Scalar::F32),
    )
}

fn line(row: &Row) -> Vec<String> {
    let mut cells = vec![shortened(&row.motion), row.scalar.name().to_owned(), row.method.name().to_owned()];
    match &row.measured {
        Some(Measured { errors, effort, wall }) => {
            let [l, n, h] = errors.integrals;
            cells.extend([errors.orientation, errors.u, errors.tip, h, l, n].map(|x| format!("{x:.1e}")));
            cells.push(match effort {
                Effort::Steps(steps) => steps.to_string(),
                Effort::Table { size, .. } => by(*size),
            });
            cells.push(format!("{:.0}", 1e9 * wall.as_secs_f64() / effort.calls().max(1) as f64));
        }
        None => cells.extend(["-"; 8].map(str::to_owned)),
    }
    cells.extend([format!("{:.0e}", row.bound), row.verdict().to_owned()]);
    cells
}

fn by([segments, terms]: [usize; 2]) -> String {
    format!("{segments}x{terms}")
}

/// A name that keeps the table within 120 columns.
fn shortened(name: &str) -> String {
    const LONGEST: usize = 20;
    if name.chars().count() <= LONGEST {
        return name.to_owned();
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}

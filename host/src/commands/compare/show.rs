//! Rows of `compare` as a table and as records.

use super::bounds::{WORST, steps_per_period};
use super::{Measured, Row};
use crate::measure::run::{Effort, SAMPLES};
use crate::motion::Scalar;
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
    ["motion", "type", "method", "angle", "u", "tip", "h", "l", "n", "steps", "ns", "bound", "result"];

pub(super) fn table(rows: &[Row], periods: u32) -> String {
    let header = HEADER.iter().map(|&name| name.to_owned()).collect();
    let lines = std::iter::once(header).chain(rows.iter().map(line)).collect();
    format!(
        "{}\nThe core against the full 3-D equations: greatest differences at {SAMPLES} times in a period over {periods} periods.\n\
         angle: 2 sqrt(|d alpha|^2 + |d beta|^2) in rad, not to exceed the bound; tip: in units of s; h, l, n: as recomputed\n\
         from alpha, beta and their rates, against their constants, relative. Steps a period: {} in f64,\n\
         {} in other types; of an ephemeris the segments x terms of its table. ns: a step or a look-up.\n",
        output::columns(lines, 3),
        steps_per_period(Scalar::F64),
        steps_per_period(Scalar::F32),
    )
}

/// Table with one row for each motion: for each scalar the error that is nearest to its bound, the cost, and whether all bounds are kept.
pub(super) fn summary(rows: &[Row], periods: u32) -> String {
    let scalars: Vec<Scalar> =
        Scalar::ALL.into_iter().filter(|scalar| rows.iter().any(|row| row.scalar == *scalar)).collect();
    let names = scalars.iter().map(|scalar| scalar.name());
    let header = ["motion"].into_iter().chain(names).chain(["ns", "result"]).map(str::to_owned).collect();
    let motions = rows.chunk_by(|a, b| a.motion == b.motion).map(|runs| summary_line(runs, &scalars));
    let lines = std::iter::once(header).chain(motions).collect();
    format!(
        "{}\nThe core against the full 3-D equations, at {SAMPLES} times in a period over {periods} periods: greatest\n\
         error of the orientation / its bound, rad, by stepper or ephemeris, whichever is nearer to its\n\
         bound. ns: a look-up in the ephemeris of the slowest type, on this machine. Every run: --all.\n",
        output::columns(lines, 1),
    )
}

fn summary_line(runs: &[Row], scalars: &[Scalar]) -> Vec<String> {
    let name = runs.first().map(|row| shortened(&row.motion)).unwrap_or_default();
    let nearest = |scalar: &Scalar| {
        let of_scalar = runs.iter().filter(|row| row.scalar == *scalar && row.bound < WORST);
        let errors = of_scalar.filter_map(|row| Some((row.error()?, row.bound)));
        let nearest = errors.max_by(|(a, a_bound), (b, b_bound)| (a / a_bound).total_cmp(&(b / b_bound)));
        nearest.map_or_else(|| "-".to_owned(), |(error, bound)| format!("{error:.0e}/{bound:.0e}"))
    };
    let look_ups = runs.iter().filter_map(|row| match row.measured?.effort {
        Effort::Table { look_ups, .. } => {
            Some(1e9 * row.measured?.wall.as_secs_f64() / look_ups.max(1) as f64)
        }
        Effort::Steps(_) => None,
    });
    let slowest = look_ups.fold(0.0, f64::max);
    let verdict = match runs {
        _ if runs.iter().any(Row::missed) => "MISS",
        _ if runs.iter().any(|row| row.measured.is_none()) => "no fit",
        _ => "ok",
    };
    let mut cells = vec![name];
    cells.extend(scalars.iter().map(nearest));
    cells.extend([format!("{slowest:.0}"), verdict.to_owned()]);
    cells
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
    let bound = if row.bound < WORST { format!("{:.0e}", row.bound) } else { "-".to_owned() };
    cells.extend([bound, row.verdict().to_owned()]);
    cells
}

fn by([segments, terms]: [usize; 2]) -> String {
    format!("{segments}x{terms}")
}

/// Name short enough for a table of 120 columns.
fn shortened(name: &str) -> String {
    const LONGEST: usize = 20;
    if name.chars().count() <= LONGEST {
        return name.to_owned();
    }
    name.chars().take(LONGEST - 1).chain(['…']).collect()
}

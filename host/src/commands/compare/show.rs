//! Rows of `compare` as a table and as records.

use super::bounds::steps_per_period;
use super::measure::Errors;
use super::run::{Run, SAMPLES};
use super::{RUNS, Row};
use crate::commands::options::Method;
use crate::motion::Scalar;
use crate::output::{self, Column, Record, error};

pub(super) fn record(row: &Row) -> Record {
    let (errors, run) = row.measured.as_ref().map(|(errors, run)| (*errors, run)).unzip();
    let [l, n, h] = [0, 1, 2].map(|i| errors.map(|errors: Errors| errors.integrals[i]));
    Record::default()
        .with("motion", &*row.motion)
        .with("scalar", row.scalar.name())
        .with("method", row.method.name())
        .with("max_orientation_error_rad", errors.map(|errors| errors.orientation))
        .with("max_u_error", errors.map(|errors| errors.u))
        .with("max_tip_error_per_s", errors.map(|errors| errors.tip))
        .with("h_drift", h)
        .with("l_drift", l)
        .with("n_drift", n)
        .with("steps", run.and_then(|run| run.steps))
        .with("table", run.and_then(|run| run.table).map(|(size, _)| by(size)))
        .with("wall_time_s", run.map(|run| run.call * calls(run)))
        .with("bound_rad", row.bound)
        .with("verdict", row.verdict())
}

/// Number of steps or evaluations of a run.
fn calls(run: &Run) -> f64 {
    run.steps.unwrap_or(run.samples.len() as u64) as f64
}

pub(super) fn table(rows: &[Row], periods: u32) -> String {
    let columns: [Column<'_>; 13] = [
        ("motion", "motion", error),
        ("scalar", "type", error),
        ("method", "method", error),
        ("max_orientation_error_rad", "angle", error),
        ("max_u_error", "u", error),
        ("max_tip_error_per_s", "tip", error),
        ("h_drift", "h", error),
        ("l_drift", "l", error),
        ("n_drift", "n", error),
        ("size", "steps", error),
        ("ns", "ns", |ns| format!("{ns:.0}")),
        ("bound_rad", "bound", |bound| format!("{bound:.0e}")),
        ("verdict", "result", error),
    ];
    let line = |row: &Row| {
        let run = row.measured.as_ref().map(|(_, run)| run);
        let size = run.map(|run| run.table.map_or_else(|| calls(run).to_string(), |(size, _)| by(size)));
        record(row).with("size", size.as_deref()).with("ns", run.map(|run| 1e9 * run.call))
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
pub(super) fn summary(rows: &[Row], periods: u32) -> String {
    let runs: Vec<_> =
        RUNS.into_iter().filter(|run| rows.iter().any(|row| (row.method, row.scalar) == *run)).collect();
    let name = |(index, (method, scalar)): (usize, &(Method, Scalar))| {
        let first = index == 0 || runs[index - 1].0 != *method;
        if first { format!("{}: {}", method.name(), scalar.name()) } else { scalar.name().to_owned() }
    };
    let mut header = vec!["motion".to_owned()];
    header.extend(runs.iter().enumerate().map(name));
    header.extend(["of bound", "ns", "result"].map(str::to_owned));
    let motions = rows.chunk_by(|a, b| a.motion == b.motion).map(summary_line);
    format!(
        "{}\nThe core against the full 3-D equations, at {SAMPLES} times in a period over {periods} periods: greatest\n\
         error of the orientation, rad; greatest error as a share of its bound; ns: a look-up in the\n\
         ephemeris of the slowest type, the median of five runs on this machine. Every run: --all.\n",
        output::columns(std::iter::once(header).chain(motions).collect(), 1),
    )
}

fn summary_line(rows: &[Row]) -> Vec<String> {
    let mut cells = vec![rows[0].motion.clone()];
    let error = |row: &Row| {
        let errors = row.measured.as_ref().map(|(errors, _)| errors.orientation);
        errors.map_or("-".to_owned(), |error| format!("{error:.0e}"))
    };
    cells.extend(rows.iter().map(error));
    let share = rows.iter().filter_map(Row::error_and_bound).map(|[error, bound]| error / bound);
    let runs = rows.iter().filter_map(|row| row.measured.as_ref().map(|(_, run)| run));
    let slowest = runs.filter(|run| run.table.is_some()).map(|run| 1e9 * run.call).fold(0.0, f64::max);
    let verdicts: Vec<_> = rows.iter().map(Row::verdict).collect();
    let worst = ["MISS", "no fit"].into_iter().find(|verdict| verdicts.contains(verdict)).unwrap_or("ok");
    cells.extend([format!("{:.2}", share.fold(0.0, f64::max)), format!("{slowest:.0}"), worst.to_owned()]);
    cells
}

fn by([segments, terms]: [usize; 2]) -> String {
    format!("{segments}x{terms}")
}

//! `toytop compare`: errors of the core against the full 3-D equations, for each motion, each scalar and both propagators.

mod bounds;
mod propagation;

use crate::arguments::options::{Method, Scalars, scalars};
use crate::commands::warnings::warnings;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use bounds::{Verdict, bound, compared_time, steps_per_period};
use clap::Args;
use propagation::{Propagation, propagate};
use serde::Serialize;
use serde_json::json;
use std::iter::once;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::builtin;
use toytop_host::input::scenario::Scenario;
use toytop_host::motion::Scalar;
use toytop_host::motion::errors::Errors;
use toytop_host::motion::full_solver;
use toytop_host::motion::sample::MotionSample;
use toytop_host::motion::times::spread_times;
use toytop_host::output::{self, Format, or_dash, significant};
use toytop_model::equations::FullState;

/// Errors of the core against an integration of the full 3-D equations
///
/// The exit code is 1 if a bound is missed, or if the full solver cannot follow some of the motions, and 3 if it can follow none.
#[derive(Args)]
#[command(after_help = "Example: toytop compare host/scenarios/toy_top.toml --periods 100 --format csv")]
pub struct CompareArgs {
    /// Scenario files; without any, the built-in motions
    #[arg(value_name = "SCENARIO")]
    scenarios: Vec<PathBuf>,
    /// Time to compare over, nutation periods; for a motion without a period the unit is 2 pi sqrt((A/p + s)/g)
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    periods: u32,
    /// Scalar types of the core
    #[arg(long, value_name = "LIST", default_value = "all", value_parser = scalars)]
    scalar: Scalars,
    /// Form of the output. CSV and JSON have a row for each method and scalar
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Propagators of the core with their scalars; in fixed point there is no stepper.
const PROPAGATORS: [(Method, Scalar); 6] = [
    (Method::Stepper, Scalar::F64),
    (Method::Stepper, Scalar::F32),
    (Method::Table, Scalar::F64),
    (Method::Table, Scalar::F32),
    (Method::Table, Scalar::Q31),
    (Method::Table, Scalar::Q15),
];

/// Number of times in a period.
const TIMES_PER_PERIOD: u32 = 64;

/// Greatest errors of a propagator on a motion; `None` without a table. The names are the keys of JSON.
#[derive(Clone, Serialize)]
struct Comparison<'a> {
    motion: &'a str,
    scalar: &'static str,
    method: &'static str,
    max_orientation_error_rad: Option<f64>,
    max_u_error: Option<f64>,
    /// Error of the tip in units of s.
    max_tip_error_per_s: Option<f64>,
    h_drift: Option<f64>,
    l_drift: Option<f64>,
    n_drift: Option<f64>,
    /// Number of steps of a stepper.
    steps: Option<u64>,
    /// Segments and terms of a table.
    table: Option<String>,
    /// Time of a step or of a look-up.
    ns: Option<f64>,
    bound_rad: Option<f64>,
    verdict: Verdict,
}

pub fn run(arguments: &CompareArgs) -> Result<Report, Failure> {
    let scenarios = if arguments.scenarios.is_empty() {
        builtin::scenarios()
    } else {
        arguments.scenarios.iter().map(|path| Scenario::read(path)).collect::<Result<_, _>>()?
    };
    let (mut motions, mut notes, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    for scenario in &scenarios {
        match compare(scenario, arguments, &mut notes) {
            Ok(rows) => motions.push(rows),
            Err(failure) => failures.push(failure),
        }
    }
    let failures: Vec<_> = failures.iter().map(Failure::to_string).collect();
    if motions.is_empty() {
        return Err(Failure::method(failures.join("; ")));
    }
    let check_failed = !failures.is_empty();
    notes.extend(failures.into_iter().chain(warnings(&scenarios)));
    let rows = motions.concat();
    let table = || table(&motions, arguments.periods);
    let text = output::render(arguments.format, &json!({ "rows": rows }), &rows, table);
    let missed = rows.iter().any(|row| row.verdict == Verdict::Missed);
    Ok(Report { text, notes, check_failed: check_failed || missed })
}

/// Table with one row for each motion: error of each propagator, greatest fraction of a bound, time of the slowest look-up, and whether
/// all bounds are kept.
fn table(motions: &[Vec<Comparison<'_>>], periods: u32) -> String {
    let prefix = |row: &Comparison<'_>| if row.steps.is_some() { "step " } else { "" };
    let line = |rows: &Vec<Comparison<'_>>| {
        let greatest = |value: fn(&Comparison<'_>) -> Option<f64>| {
            or_dash(rows.iter().filter_map(value).reduce(f64::max), |x| significant(x, 1))
        };
        let errors = rows.iter().map(|row| or_dash(row.max_orientation_error_rad, |x| significant(x, 1)));
        let worst: &str = rows.iter().map(|row| row.verdict).max().unwrap_or_default().into();
        let summary = [
            greatest(|row| Some(row.max_orientation_error_rad? / row.bound_rad?)),
            greatest(|row| row.ns.filter(|_| row.table.is_some())),
            worst.to_owned(),
        ];
        let name = rows.first().map_or("", |row| row.motion).to_owned();
        once(name).chain(errors).chain(summary).collect::<Vec<_>>()
    };
    let propagators = motions.iter().take(1).flatten().map(|row| format!("{}{}", prefix(row), row.scalar));
    let header = once("motion".to_owned())
        .chain(propagators)
        .chain(["error / bound", "ns", "verdict"].map(str::to_owned));
    format!(
        "{}\nThe core against the full 3-D equations, {TIMES_PER_PERIOD} times in a period over {periods} periods.\n\
         Columns: greatest error of the orientation, 2 sqrt(|d alpha|^2 + |d beta|^2), rad. error / bound:\n\
         greatest ratio. ns: look-up, median of five parts. Steps a period: {} (f64), {} (f32). More: CSV.\n",
        TextTable::new(1, header, motions.iter().map(line)).aligned(),
        steps_per_period(Scalar::F64),
        steps_per_period(Scalar::F32),
    )
}

/// Comparisons of a motion, one for each propagator.
///
/// # Errors
/// [`Failure::method`]: the full solver cannot integrate that far.
fn compare<'a>(
    scenario: &'a Scenario,
    arguments: &CompareArgs,
    notes: &mut Vec<String>,
) -> Result<Vec<Comparison<'a>>, Failure> {
    let (motion, name, periods) = (&scenario.motion, &*scenario.name, arguments.periods);
    let (time, remark) = compared_time(motion, periods);
    notes.extend(remark.map(|remark| format!("{name}: {remark}")));
    let times = spread_times(time, TIMES_PER_PERIOD * periods);
    let mut solver_states = Vec::new();
    let mut rows = Vec::new();
    for (method, scalar) in PROPAGATORS {
        if !arguments.scalar.0.contains(&scalar) {
            continue;
        }
        let run = propagate((method, scalar), motion, &times, periods).unwrap_or_else(|failure| {
            notes.push(format!("{name} {}: {failure}", scalar.name()));
            Propagation::default()
        });
        let errors = greatest_errors(scenario, &run.samples, &times, &mut solver_states)?;
        let error = |value: fn(&Errors) -> f64| errors.as_ref().map(value);
        let bound_rad = bound(motion, periods, run.bound);
        rows.push(Comparison {
            motion: name,
            scalar: scalar.name(),
            method: method.name(),
            max_orientation_error_rad: error(|errors| errors.orientation),
            max_u_error: error(|errors| errors.u),
            max_tip_error_per_s: error(|errors| errors.tip),
            h_drift: error(|errors| errors.drift.h),
            l_drift: error(|errors| errors.drift.l),
            n_drift: error(|errors| errors.drift.n),
            steps: run.steps,
            table: run.table,
            ns: run.ns,
            bound_rad,
            verdict: Verdict::new(error(|errors| errors.orientation), bound_rad),
        });
    }
    Ok(rows)
}

/// Greatest errors of samples against the full solver. `None` without samples.
///
/// * `solver_states`: states of the solver at `times`, which most methods reach; computed here for the first of them
fn greatest_errors(
    scenario: &Scenario,
    samples: &[MotionSample],
    times: &[f64],
    solver_states: &mut Vec<FullState>,
) -> Result<Option<Errors>, Failure> {
    // in f32 the times that are reached are rounded
    let reached: Vec<f64> = samples.iter().map(|sample| sample.t).collect();
    let states = if reached == times { solver_states } else { &mut Vec::new() };
    if states.len() != reached.len() {
        *states = full_solver::states(scenario, &reached)?;
    }
    let error = |(sample, state): (&MotionSample, &FullState)| {
        Errors::between(&scenario.motion, sample, &state.orientation())
    };
    Ok(samples.iter().zip(&*states).map(error).reduce(Errors::greater))
}

//! `toytop compare`: errors of the core against the full 3-D equations, for each motion, each scalar and both propagators.

mod bounds;

use crate::commands::options::{Method, Scalars, scalars};
use crate::commands::warnings;
use bounds::{bound, bounds_of_builtin, horizon, steps_per_period};
use clap::Args;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::time::Instant;
use toytop::Motion;
use toytop::scalar::Real;
use toytop_host::input::builtin;
use toytop_host::input::scenario::Scenario;
use toytop_host::input::times::spread_times;
use toytop_host::motion::ephemeris::smallest_ephemeris;
use toytop_host::motion::errors::Errors;
use toytop_host::motion::full_equations;
use toytop_host::motion::sample::Sample;
use toytop_host::motion::stepper::TimedStepper;
use toytop_host::motion::{Scalar, period_or_natural_time};
use toytop_host::output::table::TextTable;
use toytop_host::output::{self, Format, short};
use toytop_host::truth::full_solver::FullState;
use toytop_host::{Failure, Report};

/// Errors of the core against an integration of the full 3-D equations
///
/// The exit code is 1 if a bound is missed.
#[derive(Args)]
#[command(after_help = "Example: toytop compare host/scenarios/toy_top.toml --periods 100 --format csv")]
pub struct CompareArgs {
    /// Scenario files; without any, the built-in motions are compared
    #[arg(value_name = "SCENARIO")]
    scenarios: Vec<PathBuf>,
    /// Nutation periods to compare over; for a motion without a period, natural times 2 pi sqrt((A/p + s)/g)
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    periods: u32,
    /// Scalar types of the core
    #[arg(long, value_name = "LIST", default_value = "all", value_parser = scalars)]
    scalar: Scalars,
    /// Form of the output. CSV and JSON have a row for each method and scalar, with all errors
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Propagators of the core with their scalars; in fixed point there is no stepper.
const PROPAGATORS: [(Method, Scalar); 6] = [
    (Method::Stepper, Scalar::F64),
    (Method::Stepper, Scalar::F32),
    (Method::Ephemeris, Scalar::F64),
    (Method::Ephemeris, Scalar::F32),
    (Method::Ephemeris, Scalar::Q31),
    (Method::Ephemeris, Scalar::Q15),
];

/// Samples in a period.
const SAMPLES: u32 = 64;

/// Verdict on an error beyond its bound.
const MISSED: &str = "MISS";

/// Name of an error in the records, and its value.
type ErrorColumn = (&'static str, fn(&Errors) -> f64);

/// Name of the error that has a bound.
const ORIENTATION: &str = "max_orientation_error_rad";

/// Names of the errors, with their values.
const ERRORS: [ErrorColumn; 6] = [
    (ORIENTATION, |errors| errors.orientation),
    ("max_u_error", |errors| errors.u),
    ("max_tip_error_per_s", |errors| errors.tip),
    ("h_drift", |errors| errors.drift.h),
    ("l_drift", |errors| errors.drift.l),
    ("n_drift", |errors| errors.drift.n),
];

pub fn run(arguments: &CompareArgs) -> Result<Report, Failure> {
    let scenarios = if arguments.scenarios.is_empty() {
        builtin::scenarios()
    } else {
        arguments.scenarios.iter().map(|path| Scenario::read(path)).collect::<Result<_, _>>()?
    };
    let (mut motions, mut notes) = (Vec::new(), Vec::new());
    for scenario in &scenarios {
        motions.push(records(scenario, arguments, &mut notes)?);
    }
    let table = || table(&motions, arguments.periods);
    let text = output::render(arguments.format, &json!({ "rows": motions.concat() }), table);
    notes.extend(warnings(&scenarios));
    let check_failed = motions.iter().flatten().any(|record| record["verdict"] == MISSED);
    Ok(Report { text, notes, check_failed })
}

/// Table with one row for each motion: error of each propagator, greatest fraction of a bound, time of the slowest look-up, and whether
/// all bounds are kept.
fn table(motions: &[Vec<Value>], periods: u32) -> String {
    let line = |records: &Vec<Value>| {
        let mut line = json!({ "motion": records[0]["motion"] });
        for record in records {
            let scalar = record["scalar"].as_str().unwrap_or_default();
            let prefix = if record["method"] == "stepper" { "step " } else { "" };
            line[format!("{prefix}{scalar}")] = record[ORIENTATION].clone();
        }
        let greatest =
            |value: fn(&Value) -> Option<f64>| records.iter().filter_map(value).fold(0.0, f64::max);
        let has = |verdict: &&str| records.iter().any(|record| record["verdict"] == **verdict);
        let worst = [MISSED, "no fit", "no bound"].into_iter().find(has).unwrap_or("ok");
        line["of bound"] =
            greatest(|record| Some(record[ORIENTATION].as_f64()? / record["bound_rad"].as_f64()?)).into();
        line["ns"] = greatest(|record| record["table"].as_str().and(record["ns"].as_f64())).into();
        line["result"] = worst.into();
        line
    };
    let lines: Vec<_> = motions.iter().map(line).collect();
    format!(
        "{}\nThe core against the full 3-D equations, {SAMPLES} times in a period over {periods} periods: greatest error of\n\
         the orientation, 2 sqrt(|d alpha|^2 + |d beta|^2), rad, by stepper and ephemeris, and its share\n\
         of its bound. ns: a look-up, median of five runs. Steps a period: {} (f64), {} (f32). More: CSV.\n",
        TextTable::of_all(&lines, |x| short(x, 1)).aligned(),
        steps_per_period(Scalar::F64),
        steps_per_period(Scalar::F32),
    )
}

/// Records of a motion, one for each propagator.
fn records(
    scenario: &Scenario,
    arguments: &CompareArgs,
    notes: &mut Vec<String>,
) -> Result<Vec<Value>, Failure> {
    let (motion, name, periods) = (&scenario.motion, &scenario.name, arguments.periods);
    let tighter = arguments.scenarios.is_empty().then(|| bounds_of_builtin(name)).flatten();
    let (time, remark) = horizon(motion, periods);
    notes.extend(remark.map(|remark| format!("{name}: {remark}")));
    let times = spread_times(time, SAMPLES * periods);
    let mut reference = Reference::default();
    let mut records = Vec::new();
    for (method, scalar) in PROPAGATORS {
        if !arguments.scalar.0.contains(&scalar) {
            continue;
        }
        let run = match (method, scalar) {
            (Method::Ephemeris, _) => run_ephemeris(scalar, motion, &times),
            (_, Scalar::F64) => Ok(run_stepper::<f64>(scalar, motion, &times)),
            _ => Ok(run_stepper::<f32>(scalar, motion, &times)),
        };
        let run = run.unwrap_or_else(|failure| {
            notes.push(format!("{name} {}: {failure}", scalar.name()));
            Run::default()
        });
        let errors = reference.errors(scenario, &run.samples)?;
        let bound = bound(motion, (method, scalar), periods, tighter, run.table_bound);
        let mut record = json!({ "motion": name, "scalar": scalar.name(), "method": method.name() });
        for (name, error) in ERRORS {
            record[name] = errors.as_ref().map(error).into();
        }
        record["steps"] = run.steps.into();
        record["table"] = run.table_size.map(|[segments, terms]| format!("{segments}x{terms}")).into();
        record["ns"] = run.call.map(|seconds| 1e9 * seconds).into();
        record["bound_rad"] = bound.into();
        record["verdict"] = match (errors, bound) {
            (None, _) => "no fit",
            (_, None) => "no bound",
            (Some(errors), Some(bound)) if errors.orientation <= bound => "ok",
            _ => MISSED,
        }
        .into();
        records.push(record);
    }
    Ok(records)
}

/// Run of the core through the times of a comparison; empty where no table is large enough.
#[derive(Default)]
struct Run {
    /// Samples in the order of the times.
    samples: Vec<Sample>,
    /// Number of steps of a stepper.
    steps: Option<u64>,
    /// Segments and terms of a table.
    table_size: Option<[usize; 2]>,
    /// Bound on the error of a table at the last time, rad.
    table_bound: Option<f64>,
    /// Median time of a step or of a look-up, s.
    call: Option<f64>,
}

/// Median time in five runs of a function that returns its number of calls, s a call.
fn median(mut run: impl FnMut() -> u64) -> f64 {
    let mut times = [(); 5].map(|()| {
        let started = Instant::now();
        let calls = run();
        started.elapsed().as_secs_f64() / calls.max(1) as f64
    });
    times.sort_by(f64::total_cmp);
    times[2]
}

/// Run of the stepper through the times.
fn run_stepper<R: Real>(scalar: Scalar, motion: &Motion, times: &[f64]) -> Run {
    let step = period_or_natural_time(motion) / f64::from(steps_per_period(scalar));
    let (mut samples, mut steps) = (Vec::new(), 0);
    let call = median(|| {
        let mut timed = TimedStepper::<R>::new(motion, step);
        let sample = |&t: &f64| {
            timed.reach(t, |_| ());
            timed.sample()
        };
        samples = times.iter().map(sample).collect();
        steps = timed.steps;
        steps
    });
    Run { samples, steps: Some(steps), call: Some(call), ..Run::default() }
}

/// Run of an ephemeris at the times.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough, or the motion is aperiodic and the scalar is not `f64`.
fn run_ephemeris(scalar: Scalar, motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    let table = smallest_ephemeris(scalar, motion)?;
    let mut samples = Vec::new();
    let call = median(|| {
        samples = times.iter().map(|&t| table.at(t)).collect();
        times.len() as u64
    });
    let last = times.last().copied().unwrap_or(0.0);
    let bound = table.error_bound().after(last * table.ticks_per_time());
    Ok(Run {
        samples,
        steps: None,
        table_size: Some(table.size()),
        table_bound: Some(bound),
        call: Some(call),
    })
}

/// States of the full solver, kept for the next run with the same times.
#[derive(Default)]
struct Reference {
    times: Vec<f64>,
    states: Vec<FullState>,
}

impl Reference {
    /// Greatest errors of samples, at the times that they have reached: an f32 step misses the requested one. `None` without samples.
    fn errors(&mut self, scenario: &Scenario, samples: &[Sample]) -> Result<Option<Errors>, Failure> {
        if samples.is_empty() {
            return Ok(None);
        }
        let times: Vec<f64> = samples.iter().map(|sample| sample.t).collect();
        if times != self.times {
            self.states = full_equations::states(scenario, &times)?;
            self.times = times;
        }
        let error = |(sample, state): (&Sample, &FullState)| {
            Errors::between(&scenario.motion, sample, &state.orientation())
        };
        Ok(samples.iter().zip(&self.states).map(error).reduce(Errors::greater))
    }
}

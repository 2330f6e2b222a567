//! `toytop compare`: errors of the core against the full 3-D equations, for each motion, each scalar and both propagators.

mod bounds;
mod run;

use super::options::{Method, ScalarChoice};
use super::{Report, warnings};
use crate::Failure;
use crate::input::builtin;
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use crate::motion::spread_times;
use crate::output::{self, Format};
use bounds::{bound, horizon, steps_per_period};
use clap::Args;
use run::{Reference, Run, SAMPLES, look_up, step_through};
use std::path::PathBuf;

/// Comparison of one motion in one scalar by one method.
struct Row {
    motion: String,
    scalar: Scalar,
    method: Method,
    /// Greatest errors and run; `None` where no table is large enough.
    measured: Option<([f64; 6], Run)>,
    /// Upper bound on the error of the orientation, rad.
    bound: Option<f64>,
}

impl Row {
    /// Greatest error of the orientation, rad, and its bound.
    fn error_and_bound(&self) -> [Option<f64>; 2] {
        [self.measured.as_ref().map(|(errors, _)| errors[0]), self.bound]
    }

    fn verdict(&self) -> &'static str {
        match self.error_and_bound() {
            [None, _] => "no fit",
            [_, None] => "no bound",
            [Some(error), Some(bound)] if error <= bound => "ok",
            _ => "MISS",
        }
    }
}

/// Propagators of the core with their scalars; in fixed point it has no stepper.
const RUNS: [(Method, Scalar); 6] = [
    (Method::Stepper, Scalar::F64),
    (Method::Stepper, Scalar::F32),
    (Method::Ephemeris, Scalar::F64),
    (Method::Ephemeris, Scalar::F32),
    (Method::Ephemeris, Scalar::Q31),
    (Method::Ephemeris, Scalar::Q15),
];

/// `toytop compare`
#[derive(Args)]
pub struct CompareArgs {
    /// Scenario files; without any, the built-in motions are compared
    #[arg(value_name = "SCENARIO")]
    scenarios: Vec<PathBuf>,
    /// Nutation periods to compare over (for a motion without a period: times of 2 pi sqrt((A/p + s)/g))
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    periods: u32,
    /// Scalar types of the core
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    scalar: Vec<ScalarChoice>,
    /// Print one row for each run of the built-in motions, not one for each motion. CSV and JSON always contain every run
    #[arg(long)]
    all: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &CompareArgs) -> Result<Report, Failure> {
    let built_in = arguments.scenarios.is_empty();
    let scenarios = if built_in {
        builtin::scenarios()
    } else {
        arguments.scenarios.iter().map(|path| Scenario::read(path)).collect::<Result<_, _>>()?
    };
    let (mut rows, mut remarks) = (Vec::new(), Vec::new());
    for scenario in &scenarios {
        rows.extend(of_motion(scenario, arguments, &mut remarks)?);
    }
    let records: Vec<_> = rows.iter().map(run::record).collect();
    let text = output::render(arguments.format, &output::list("rows", &records), || {
        let table = if built_in && !arguments.all { run::summary } else { run::table };
        table(&rows, arguments.periods)
    })?;
    remarks.extend(warnings(&scenarios));
    let missed = rows.iter().any(|row| row.verdict() == "MISS");
    let below = arguments.format == Format::Table;
    Ok(Report { text, missed, ..Report::default() }.with_remarks(remarks, below))
}

/// Rows of a motion.
fn of_motion(
    scenario: &Scenario,
    arguments: &CompareArgs,
    remarks: &mut Vec<String>,
) -> Result<Vec<Row>, Failure> {
    let (motion, name, periods) = (&scenario.motion, &scenario.name, arguments.periods);
    let own = arguments.scenarios.is_empty().then(|| builtin::own_bounds(scenario)).flatten();
    let span = horizon(motion, periods);
    remarks.extend(span.remark.iter().map(|remark| format!("{name}: {remark}")));
    let times = spread_times(span.time, SAMPLES * periods);
    let mut reference = Reference::default();
    let chosen = ScalarChoice::chosen(&arguments.scalar);
    let mut rows = Vec::new();
    for (method, scalar) in RUNS.into_iter().filter(|(_, scalar)| chosen.contains(scalar)) {
        let step = span.period / f64::from(steps_per_period(scalar));
        let run = match method {
            Method::Ephemeris => look_up(scalar, motion, &times),
            _ => Ok(step_through(scalar, motion, &times, step)),
        };
        let measured = match run {
            Ok(run) => Some((reference.errors(scenario, &run)?, run)),
            Err(failure) => {
                remarks.push(format!("{name} {}: {failure}", scalar.name()));
                None
            }
        };
        let table = measured.as_ref().and_then(|(_, run)| run.table).map(|(_, bound)| bound);
        let bound = bound(motion, (method, scalar), periods, own, table);
        rows.push(Row { motion: name.clone(), scalar, method, measured, bound });
    }
    Ok(rows)
}

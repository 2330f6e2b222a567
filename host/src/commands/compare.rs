//! `toytop compare`: errors of the core against the full 3-D equations, for each motion, each scalar and both propagators.

mod bounds;
mod measure;
mod show;

use super::{Report, unreal};
use crate::Failure;
use crate::cli::{CompareArgs, Format, Method, Scalar, ScalarChoice};
use crate::input::builtin;
use crate::input::scenario::Scenario;
use crate::measure::run::{Effort, Run, SAMPLES, look_up, sample_times, step_through};
use crate::output;
use bounds::{Span, WORST, bound, horizon, steps_per_period};
use measure::{Errors, Truth};
use std::time::Duration;

/// Comparison of one motion in one scalar by one method.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the motion.
    pub motion: String,
    /// Scalar of the core.
    pub scalar: Scalar,
    /// Propagator of the core.
    pub method: Method,
    /// Errors and cost; `None` where the method does not apply.
    measured: Option<Measured>,
    /// Upper bound on the error of the orientation, rad.
    bound: f64,
}

/// Errors and cost of a run.
#[derive(Clone, Copy, Debug)]
struct Measured {
    errors: Errors,
    effort: Effort,
    wall: Duration,
}

impl Row {
    /// Greatest error of the orientation, rad; `None` where the method does not apply.
    #[must_use]
    pub fn error(&self) -> Option<f64> {
        self.measured.map(|measured| measured.errors.orientation)
    }

    /// Whether the bound is missed; a NaN misses it.
    fn missed(&self) -> bool {
        let within = |measured: Measured| measured.errors.orientation <= self.bound;
        !self.measured.is_none_or(within)
    }

    fn verdict(&self) -> &'static str {
        match self.measured {
            None => "no fit",
            Some(_) if self.missed() => "MISS",
            // no error of an orientation is larger
            Some(_) if self.bound >= WORST => "no bound",
            Some(_) => "ok",
        }
    }
}

/// Propagators of the core.
const METHODS: [Method; 2] = [Method::Stepper, Method::Ephemeris];

/// Whether the core has the method in the scalar: in fixed point it has no stepper.
fn exists(method: Method, scalar: Scalar) -> bool {
    !(method == Method::Stepper && matches!(scalar, Scalar::Q31 | Scalar::Q15))
}

/// Result of a comparison.
#[derive(Debug)]
pub struct Compared {
    scenarios: Vec<Scenario>,
    /// Row for each motion, scalar and method.
    pub rows: Vec<Row>,
    remarks: Vec<String>,
}

pub(super) fn run(arguments: &CompareArgs) -> Result<Report, Failure> {
    let Compared { scenarios, rows, mut remarks } = rows(arguments)?;
    let below = arguments.format == Format::Table;
    let text = match arguments.format {
        Format::Table if arguments.scenarios.is_empty() && !arguments.all => {
            show::summary(&rows, arguments.periods)
        }
        Format::Table => show::table(&rows, arguments.periods),
        Format::Csv => output::csv(&show::records(&rows)).map_err(Failure::Output)?,
        Format::Json => output::json_list("rows", &show::records(&rows)).map_err(Failure::Output)?,
    };
    remarks.extend(unreal(&scenarios));
    let missed = rows.iter().any(Row::missed);
    Ok(Report { text, missed, ..Report::default() }.with_remarks(remarks, below))
}

/// Comparison of every motion in every scalar by every method.
///
/// # Errors
/// [`Failure::Input`]: a scenario cannot be read; [`Failure::Method`]: the full solver gave up.
pub fn rows(arguments: &CompareArgs) -> Result<Compared, Failure> {
    let built_in = arguments.scenarios.is_empty();
    let scenarios = if built_in {
        builtin::scenarios()?
    } else {
        arguments.scenarios.iter().map(|path| Scenario::read(path)).collect::<Result<_, _>>()?
    };
    let scalars = ScalarChoice::chosen(&arguments.scalar);
    let mut remarks = Vec::new();
    let mut rows = Vec::new();
    for scenario in &scenarios {
        let own = built_in.then(|| builtin::own_bounds(scenario)).flatten();
        let span = horizon(&scenario.motion, arguments.periods);
        remarks.extend(span.remark.iter().map(|remark| format!("{}: {remark}", scenario.name)));
        let times: Vec<f64> = sample_times(span.time, SAMPLES * arguments.periods).collect();
        let mut truth = Truth::default();
        for (method, &scalar) in METHODS.iter().flat_map(|&method| scalars.iter().map(move |s| (method, s))) {
            if !exists(method, scalar) {
                continue;
            }
            let measured = match follow(scenario, method, scalar, &times, &span) {
                Ok(run) => {
                    let errors = truth.measure(scenario, &run)?;
                    Some(Measured { errors, effort: run.effort, wall: run.wall })
                }
                Err(failure) => {
                    remarks.push(format!("{} {}: {failure}", scenario.name, scalar.name()));
                    None
                }
            };
            let bound = bound(&scenario.motion, (method, scalar), arguments.periods, own);
            rows.push(Row { motion: scenario.name.clone(), scalar, method, measured, bound });
        }
    }
    Ok(Compared { scenarios, rows, remarks })
}

/// Row of one run. It fails only where no table is large enough.
fn follow(
    scenario: &Scenario,
    method: Method,
    scalar: Scalar,
    times: &[f64],
    span: &Span,
) -> Result<Run, Failure> {
    let motion = &scenario.motion;
    let step = span.period / f64::from(steps_per_period(scalar));
    match method {
        Method::Ephemeris => look_up(scalar, motion, times),
        _ => step_through(scalar, motion, times, step),
    }
}

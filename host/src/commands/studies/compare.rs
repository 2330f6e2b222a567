//! `toytop compare`: errors of the core against the full 3-D equations, for each motion, each scalar and both propagators.

mod bounds;
mod tables;

use super::options::{Method, Scalars, scalars};
use super::{Report, warnings};
use crate::Failure;
use crate::input::builtin;
use crate::input::scenario::Scenario;
use crate::motion::ephemeris::{require_scalar, smallest_ephemeris};
use crate::motion::propagate::{Sample, TimedStepper, period};
use crate::motion::{Scalar, first_integrals, greater, natural_scales, spread_times, widened};
use crate::output::progress::Progress;
use crate::output::{self, Format};
use crate::truth::full_equations;
use crate::truth::full_equations::full_solver::FullState;
use bounds::{bound, horizon, steps_per_period};
use clap::Args;
use std::path::PathBuf;
use std::time::Instant;
use toytop::Motion;
use toytop::scalar::Real;
use toytop::su2::OrientationRate;

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
    #[arg(long, value_name = "LIST", default_value = "all", value_parser = scalars)]
    scalar: Scalars,
    /// Print one row for each run of the built-in motions, not one for each motion. CSV and JSON always contain every run
    #[arg(long)]
    all: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
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
    /// Greatest error of the orientation, rad.
    fn error(&self) -> Option<f64> {
        self.measured.as_ref().map(|(errors, _)| errors[0])
    }

    fn verdict(&self) -> &'static str {
        match (self.error(), self.bound) {
            (None, _) => "no fit",
            (_, None) => "no bound",
            (Some(error), Some(bound)) if error <= bound => "ok",
            _ => "MISS",
        }
    }
}

/// Run of the core through the times of a comparison.
struct Run {
    /// Samples in the order of the times, with the rates of α and β.
    samples: Vec<(Sample, OrientationRate<f64>)>,
    /// Number of steps of a stepper.
    steps: Option<u64>,
    /// Segments and terms of a table, and the bound on its error at the last time, rad.
    table: Option<([usize; 2], f64)>,
    /// Median time of a step or of an evaluation, s.
    call: f64,
}

impl Run {
    /// Number of steps or evaluations.
    fn calls(&self) -> u64 {
        self.steps.unwrap_or(self.samples.len() as u64)
    }
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
    let records: Vec<_> = rows.iter().map(tables::record).collect();
    let text = output::render(arguments.format, &output::list("rows", &records), || {
        let table = if built_in && !arguments.all { tables::summary } else { tables::all };
        table(&rows, arguments.periods)
    });
    remarks.extend(warnings(&scenarios));
    let missed = rows.iter().any(|row| row.verdict() == "MISS");
    let below = arguments.format == Format::Table;
    Ok(Report { text, missed, ..Report::default() }.with_remarks(remarks, below))
}

/// Samples in a period.
const SAMPLES: u32 = 64;

/// Rows of a motion.
fn of_motion(
    scenario: &Scenario,
    arguments: &CompareArgs,
    remarks: &mut Vec<String>,
) -> Result<Vec<Row>, Failure> {
    let (motion, name, periods) = (&scenario.motion, &scenario.name, arguments.periods);
    let own = arguments.scenarios.is_empty().then(|| bounds::own_bounds(&scenario.name)).flatten();
    let (time, remark) = horizon(motion, periods);
    remarks.extend(remark.map(|remark| format!("{name}: {remark}")));
    let times = spread_times(time, SAMPLES * periods);
    let mut reference = Reference::default();
    let Scalars(chosen) = &arguments.scalar;
    let mut rows = Vec::new();
    for (method, scalar) in RUNS.into_iter().filter(|(_, scalar)| chosen.contains(scalar)) {
        let run = match (method, scalar) {
            (Method::Ephemeris, _) => look_up(scalar, motion, &times),
            (_, Scalar::F64) => Ok(step_through::<f64>(scalar, motion, &times)),
            _ => Ok(step_through::<f32>(scalar, motion, &times)),
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

/// Median time of a call in five runs, each of which returns the number of its calls.
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
fn step_through<R: Real>(scalar: Scalar, motion: &Motion, times: &[f64]) -> Run {
    let step = period(motion) / f64::from(steps_per_period(scalar));
    let progress = Progress::new(0, "steps");
    let (mut samples, mut steps) = (Vec::new(), 0);
    let call = median(|| {
        let mut timed = TimedStepper::<R>::new(motion, step);
        let sample = |&t: &f64| {
            timed.reach(t, &progress);
            let rate = timed.last.attitude_state().rate;
            let [alpha, beta] = [rate.alpha, rate.beta].map(|z| widened(z, R::to_f64));
            (timed.sample(), OrientationRate { alpha, beta })
        };
        samples = times.iter().map(sample).collect();
        steps = timed.steps;
        steps
    });
    Run { samples, steps: Some(steps), table: None, call }
}

/// Run of an ephemeris at the times.
///
/// # Errors
/// [`Failure::Method`]: no table is large enough, or the motion is aperiodic and the scalar is not `f64`.
fn look_up(scalar: Scalar, motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    require_scalar(scalar, motion)?;
    let table = smallest_ephemeris(scalar, motion)?;
    let mut found = Vec::new();
    let call = median(|| {
        found = times.iter().map(|&t| table.at(t)).collect();
        times.len() as u64
    });
    let samples = found.iter().map(|now| (now.sample, now.rate)).collect();
    let last = times.last().copied().unwrap_or(0.0);
    let bound = table.error_bound().after(last * table.ticks_per_time());
    Ok(Run { samples, steps: None, table: Some((table.size(), bound)), call })
}

/// Cached full-solver states, reused for equal times.
#[derive(Default)]
struct Reference {
    times: Vec<f64>,
    states: Vec<FullState>,
}

impl Reference {
    /// Greatest errors of a run, by [`tables::ERRORS`], at the times that the run has reached, because an f32 step ends near the requested
    /// time, not at it.
    fn errors(&mut self, scenario: &Scenario, run: &Run) -> Result<[f64; 6], Failure> {
        let times: Vec<f64> = run.samples.iter().map(|(sample, _)| sample.t).collect();
        if times != self.times {
            self.states = full_equations::states(scenario, &times)?;
            self.times = times;
        }
        let (motion, constants) = (&scenario.motion, scenario.motion.first_integrals());
        let (top, scales) = (motion.top(), natural_scales(motion));
        let errors = |((sample, rate), state): (&(Sample, OrientationRate<f64>), &FullState)| {
            let (found, phi) = (sample.orientation(), state.orientation());
            // in f64 from α, β and their rates, so that l, n and h do not contain the rounding of a product
            let [l, n, h] = first_integrals(top, &found, rate.omega_fixed(&found));
            let tip = sample.tip.scaled(1.0 / top.tip_scale()) - (phi.alpha * phi.beta).scaled(2.0);
            [
                found.distance(&phi),
                (sample.u - (phi.alpha.norm_squared() - phi.beta.norm_squared())).abs(),
                tip.norm_squared().sqrt(),
                (h - constants.h).abs() / scales[2],
                (l - constants.l).abs() / scales[0],
                (n - constants.n).abs() / scales[1],
            ]
        };
        let greatest = |most: [f64; 6], now: [f64; 6]| std::array::from_fn(|i| greater(most[i], now[i]));
        Ok(run.samples.iter().zip(&self.states).map(errors).fold([0.0; 6], greatest))
    }
}

//! Runs of the core over a motion, by a stepper or by an ephemeris, their errors against the full solver, and tables of both.

use super::bounds::steps_per_period;
use super::{RUNS, Row};
use crate::Failure;
use crate::commands::options::Method;
use crate::full_equations::full_solver::FullState;
use crate::full_equations::solution;
use crate::input::scenario::Scenario;
use crate::motion::ephemeris::{require_scalar, smallest};
use crate::motion::propagate::{Sample, TimedStepper};
use crate::motion::{Scalar, greater, widened};
use crate::motion::{first_integrals, natural_scales};
use crate::output::progress::Progress;
use crate::output::{self, Column, Record, error};
use std::time::Instant;
use toytop::scalar::Real;
use toytop::su2::OrientationRate;
use toytop::{Motion, Top};

/// Samples and cost of a run.
pub struct Run {
    /// Samples in the order of the times, each with the first integrals l, n and h.
    samples: Vec<(Sample, [f64; 3])>,
    /// Number of steps of a stepper.
    pub steps: Option<u64>,
    /// Segments and terms of a table, and the bound on its error at the last time, rad.
    pub table: Option<([usize; 2], f64)>,
    /// Median time of a step or of an evaluation, s.
    pub call: f64,
}

impl Run {
    /// Number of steps or evaluations.
    pub fn calls(&self) -> u64 {
        self.steps.unwrap_or(self.samples.len() as u64)
    }
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

/// Samples in a period.
pub const SAMPLES: u32 = 64;

/// Run of the stepper through the times, in steps of `step`, s.
pub fn step_through(scalar: Scalar, motion: &Motion, times: &[f64], step: f64) -> Run {
    match scalar {
        Scalar::F64 => stepped::<f64>(motion, times, step),
        _ => stepped::<f32>(motion, times, step),
    }
}

fn stepped<R: Real>(motion: &Motion, times: &[f64], step: f64) -> Run {
    let progress = Progress::new(0, "steps");
    let (mut samples, mut steps) = (Vec::new(), 0);
    let call = median(|| {
        let mut timed = TimedStepper::<R>::new(motion, step);
        let sample = |&t: &f64| {
            timed.reach(t, &progress);
            let rate = timed.last.attitude_state().rate;
            let [alpha, beta] = [rate.alpha, rate.beta].map(|z| widened(z, R::to_f64));
            with_integrals(motion.top(), timed.sample(), &OrientationRate { alpha, beta })
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
pub fn look_up(scalar: Scalar, motion: &Motion, times: &[f64]) -> Result<Run, Failure> {
    require_scalar(scalar, motion)?;
    let table = smallest(scalar, motion)?;
    let mut found = Vec::new();
    let call = median(|| {
        found = times.iter().map(|&t| table.at(t)).collect();
        times.len() as u64
    });
    let samples = found.iter().map(|now| with_integrals(motion.top(), now.sample, &now.rate)).collect();
    let last = times.last().copied().unwrap_or(0.0);
    let bound = table.error_bound().after(last * table.ticks_per_time());
    Ok(Run { samples, steps: None, table: Some((table.size(), bound)), call })
}

/// Sample with l, n and h, recomputed in f64 from the core's α, β and their rates, so that they do not contain the rounding of a product.
fn with_integrals(top: &Top, sample: Sample, rate: &OrientationRate<f64>) -> (Sample, [f64; 3]) {
    let phi = sample.orientation();
    (sample, first_integrals(top, &phi, rate.omega_fixed(&phi)))
}

/// Names of the errors: of the orientation, 2 √(|Δα|² + |Δβ|²), rad; of u; of the tip in units of s; of h, l and n as recomputed from
/// α, β and their rates, in units of [`natural_scales`].
pub const ERRORS: [&str; 6] =
    ["max_orientation_error_rad", "max_u_error", "max_tip_error_per_s", "h_drift", "l_drift", "n_drift"];

/// States of the full solver at the times of the last run, which most other runs share.
#[derive(Default)]
pub struct Reference {
    times: Vec<f64>,
    states: Vec<FullState>,
}

impl Reference {
    /// Greatest errors of a run, by [`ERRORS`], at the times that the run has reached, because an f32 step ends near the requested
    /// time, not at it.
    pub fn errors(&mut self, scenario: &Scenario, run: &Run) -> Result<[f64; 6], Failure> {
        let times: Vec<f64> = run.samples.iter().map(|(sample, _)| sample.t).collect();
        if times != self.times {
            self.states = solution::states(scenario, &times)?;
            self.times = times;
        }
        let (motion, constants) = (&scenario.motion, scenario.motion.first_integrals());
        let (scales, tip_scale) = (natural_scales(motion), motion.top().tip_scale());
        let errors = |((sample, [l, n, h]), state): (&(Sample, [f64; 3]), &FullState)| {
            let phi = state.orientation();
            let tip = sample.tip.scaled(1.0 / tip_scale) - (phi.alpha * phi.beta).scaled(2.0);
            [
                sample.orientation().distance(&phi),
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

pub fn table(rows: &[Row], periods: u32) -> String {
    let mut columns: Vec<Column<'_>> =
        vec![("motion", "motion", error), ("scalar", "type", error), ("method", "method", error)];
    let errors = ERRORS.into_iter().zip(["angle", "u", "tip", "h", "l", "n"]);
    columns.extend(errors.map(|(name, heading)| (name, heading, error as fn(f64) -> String)));
    columns.extend([
        ("size", "steps", error as fn(f64) -> String),
        ("ns", "ns", |ns| format!("{ns:.0}")),
        ("bound_rad", "bound", |bound| format!("{bound:.0e}")),
        ("verdict", "result", error),
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
    let (mut share, mut slowest) = (0.0_f64, 0.0_f64);
    for row in rows {
        let [error, bound] = row.error_and_bound();
        cells.push(error.map_or("-".to_owned(), |error| format!("{error:.0e}")));
        share = share.max(error.zip(bound).map_or(0.0, |(error, bound)| error / bound));
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

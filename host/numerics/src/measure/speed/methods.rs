//! Time for the same samples by the full solver, by the Runge-Kutta method and by an ephemeris.

use super::Row;
use super::timing::{least, least_in_parts};
use crate::Failure;
use crate::full_equations::baseline::{EqualSteps, RungeKutta};
use crate::full_equations::full_solver::{FullSolver, FullState};
use crate::full_equations::solution::{self, phi};
use crate::input::scenario::{Scenario, Units};
use crate::output::progress::Progress;
use toytop::{
    EphemerisF64, Motion, Orientation, ParameterError, Sign, Signs, Start, Tick, Top, TopParameters,
};

/// Number of samples of a task.
pub const SAMPLES: u32 = 1000;
/// Number of periods over which the samples are spread.
pub const PERIODS: u32 = 100;
/// Greatest allowed error of the orientation, rad.
pub const ACCURACY: f64 = 1e-9;
/// Number of tasks that are timed here.
pub const TASKS: u64 = 6;
/// Number of parts in which a long task is timed.
const PARTS: usize = 50;
const SAMPLES_OF_PART: usize = SAMPLES as usize / PARTS;
/// Ticks in a second.
const HERTZ: u32 = 1024;
/// Least number of steps of the baseline between two samples.
const FEWEST_STEPS: u32 = 20;
const MOST_STEPS: u32 = 2560;

/// Motion of a toy top whose tip curve has cusps.
pub fn scenario() -> Result<Scenario, Failure> {
    let motion = || -> Result<Motion, ParameterError> {
        let top = Top::sliding(&TopParameters {
            transverse_inertia: 1.0,
            axial_inertia: 0.6,
            com_height: 1.0,
            mass_moment: 1.0,
            gravity: 1.0,
            ..TopParameters::default()
        })?;
        let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
        Motion::from_branch_points(&top, [0.7, 0.9, 1.85], signs, &Start::default())
    };
    let motion = motion().map_err(impossible)?;
    Ok(Scenario { name: "bench".to_owned(), motion, state: None, units: Units::None })
}

/// Failure for an error that cannot occur, because the motion is valid.
fn impossible(error: ParameterError) -> Failure {
    Failure::Input(format!("bench: {error}"))
}

/// Rows of all methods.
///
/// # Errors
/// [`Failure::Method`]: a method does not reach the samples.
pub fn run(scenario: &Scenario, progress: &mut Progress) -> Result<Vec<Row>, Failure> {
    let motion = &scenario.motion;
    let period = motion.period_advance().map_or(1.0, |averages| averages.period);
    // whole ticks whose times are exact in f64, so that all methods compute the same times
    let apart = (f64::from(PERIODS) * period / f64::from(SAMPLES) * f64::from(HERTZ)).round() as i64;
    let ticks: Vec<i64> = (1..=i64::from(SAMPLES)).map(|i| i * apart).collect();
    let times: Vec<f64> = ticks.iter().map(|&n| n as f64 / f64::from(HERTZ)).collect();
    let tick = Tick::hertz(HERTZ).map_err(impossible)?;
    let set_up = || EphemerisF64::new(motion, tick).map_err(|error| Failure::Method(error.to_string()));
    let (setting_up, ephemeris) = least(progress, set_up);
    let ephemeris = ephemeris?;
    let at = |t: &f64| ephemeris.at(*t);
    let (ticking, _) =
        least(progress, || ticks.iter().map(|&n| ephemeris.at_tick(n).orientation()).collect::<Vec<_>>());
    let (orienting, phis) = least(progress, || times.iter().map(|t| at(t).orientation()).collect::<Vec<_>>());
    let (turning, _) = least(progress, || {
        let attitude = |t: &f64| {
            let now = at(t);
            (now.orientation(), now.omega())
        };
        times.iter().map(attitude).collect::<Vec<_>>()
    });
    let truth = solution::states(scenario, &times)?;
    let error = |found: &[Orientation<f64>]| {
        let pairs = found.iter().zip(&truth);
        pairs.map(|(found, truth)| found.distance(&phi(truth))).fold(0.0, f64::max)
    };
    let solver_error = |states: &[FullState]| error(&states.iter().map(phi).collect::<Vec<_>>());

    let tighter = |tolerance: f64| (tolerance > 1e-15).then_some(0.1 * tolerance);
    let (tolerance, states) =
        least_effort(1e-6, tighter, |tolerance| solved(scenario, &times, tolerance), &solver_error)?;
    let solving = least_in_parts(
        progress,
        PARTS,
        || solver(scenario, tolerance),
        |solver, part| {
            for &t in times.iter().skip(part * SAMPLES_OF_PART).take(SAMPLES_OF_PART) {
                // the solver has reached this time before without an error
                let _ = std::hint::black_box(solver.advance_to(t));
            }
        },
    );
    let apart = apart as f64 / f64::from(HERTZ);
    let stepped = |steps: u32| Ok(samples(&mut baseline(scenario, apart, steps), steps, times.len()));
    let finer = |steps: u32| (steps < MOST_STEPS).then_some(2 * steps);
    let (steps, stepped) = least_effort(FEWEST_STEPS, finer, stepped, &solver_error)?;
    let stepping = least_in_parts(
        progress,
        PARTS,
        || baseline(scenario, apart, steps),
        |run, _| {
            std::hint::black_box(samples(run, steps, SAMPLES_OF_PART));
        },
    );
    let line = |what: &str, seconds: f64, error: f64| {
        let ratio = solving / seconds;
        let digits = if ratio < 1.0 { 2 } else { usize::from(ratio < 10.0) };
        let ratio = format!("{ratio:.digits$}");
        Row { what: what.to_owned(), seconds, error: Some(error), rest: vec![format!("{error:.1e}"), ratio] }
    };
    let solver = format!("full solver, tolerance {tolerance:.0e}: orientation and angular velocity");
    let stepped_line =
        format!("Runge-Kutta of the full equations, {} steps a period: the same", steps * SAMPLES / PERIODS);
    let error = error(&phis);
    Ok(vec![
        line(&solver, solving, solver_error(&states)),
        line(&stepped_line, stepping, solver_error(&stepped)),
        line("ephemeris f64, 48x11, at any time: the same", turning, error),
        line("ephemeris f64, 48x11, at any time: orientation", orienting, error),
        line("ephemeris f64, 48x11, at any tick: orientation", ticking, error),
        Row {
            what: "    its set-up, once".to_owned(),
            seconds: setting_up,
            error: None,
            rest: vec![String::new(); 2],
        },
    ])
}

/// First of the efforts that is accurate enough, with its states.
fn least_effort<E: Copy>(
    first: E,
    more: impl Fn(E) -> Option<E>,
    states_of: impl Fn(E) -> Result<Vec<FullState>, Failure>,
    error: &dyn Fn(&[FullState]) -> f64,
) -> Result<(E, Vec<FullState>), Failure> {
    let (mut effort, mut states) = (first, states_of(first)?);
    while error(&states) > ACCURACY {
        let Some(greater) = more(effort) else { break };
        (effort, states) = (greater, states_of(greater)?);
    }
    Ok((effort, states))
}

fn solved(scenario: &Scenario, times: &[f64], tolerance: f64) -> Result<Vec<FullState>, Failure> {
    let mut solver = solver(scenario, tolerance);
    let reach = |&t: &f64| solver.advance_to(t).map_err(|error| Failure::Method(error.to_string()));
    times.iter().map(reach).collect()
}

fn solver(scenario: &Scenario, tolerance: f64) -> FullSolver {
    let (top, state) = solution::start(scenario);
    FullSolver::new(top, state, tolerance)
}

/// Baseline with this many steps between two samples, whose distance is `apart`, s.
fn baseline(scenario: &Scenario, apart: f64, steps: u32) -> EqualSteps<RungeKutta> {
    let (top, state) = solution::start(scenario);
    EqualSteps::new(&top, &state, apart / f64::from(steps))
}

fn samples(run: &mut EqualSteps<RungeKutta>, steps: u32, count: usize) -> Vec<FullState> {
    let sample = |_| {
        (0..steps).for_each(|_| run.step());
        run.state()
    };
    (0..count).map(sample).collect()
}

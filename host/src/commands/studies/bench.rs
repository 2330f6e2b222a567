//! `toytop bench`: computing times of states, by the core and by other methods, on this machine with this build.

use super::Report;
use super::options::FormatArgs;
use crate::Failure;
use crate::input::builtin;
use crate::input::scenario::Scenario;
use crate::output::{self, Record, short};
use crate::truth::full_equations;
use crate::truth::full_equations::full_solver::{Equations, FullSolver, FullState};
use std::hint::black_box;
use std::time::Instant;
use toytop::scalar::Real;
use toytop::{
    EphemerisF32, EphemerisF64, EphemerisScalar, EphemerisView, Motion, Orientation, Stepper, Tick,
};

/// Name of the built-in motion that is timed.
const CURVE_WITH_CUSPS: &str = "figure 3 e3=1.85";
/// Number of states of a task, of steps of the Runge-Kutta method between two of them, and of ticks in a second.
const STATES: u32 = 1000;
const STEPS: u32 = 640;
const HERTZ: u32 = 1024;
/// Number of periods over which the states are spread.
const PERIODS: u32 = 100;
/// Tolerance of the full solver.
const TOLERANCE: f64 = 1e-12;
/// Number of runs of a task, of which the least time counts, because other processes can only make a run longer.
const RUNS: u32 = 5;

/// Least time of a task of this many states, divided by their number, and the result of the last run.
fn least<T>(states: u32, mut task: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let started = Instant::now();
        let result = black_box(task());
        (started.elapsed().as_secs_f64() / f64::from(states), result)
    };
    let first = timed();
    (1..RUNS).map(|_| timed()).fold(first, |best, run| (best.0.min(run.0), run.1))
}

pub fn run(arguments: &FormatArgs) -> Result<Report, Failure> {
    let figures = builtin::figures();
    let cusps = figures.iter().find(|scenario| scenario.name == CURVE_WITH_CUSPS);
    let rows = rows(cusps.ok_or_else(|| Failure::Tool("bench: no motion".into()))?)?;
    let table = || {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
        let columns: [output::Column<'_>; 4] = [
            ("what", "", short_seconds),
            ("seconds", "time of a state", short_seconds),
            ("error_rad", "error, rad", output::two_digits),
            ("seconds", "million a second", |seconds| short(1e-6 / seconds, 3)),
        ];
        format!(
            "{}\n{STATES} states over {PERIODS} periods of the paper's curve with cusps. Ticks given by their numbers do not depend\n\
             on each other, and the processor may overlap them; the next tick waits for the one before. Least of {RUNS} runs on one core of {cores}; {build}.\n",
            output::aligned(&rows, &columns),
        )
    };
    Ok(output::render(arguments.format, &output::list("rows", &rows), table)?.into())
}

/// Time with three digits and a unit.
fn short_seconds(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        x if x < 1e-6 => (1e9, "ns"),
        x if x < 1e-3 => (1e6, "µs"),
        x if x < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {unit}", short(scale * seconds, 3))
}

/// Task with the time of one state, s, and the greatest error of the orientation, rad.
fn row(what: &str, seconds: f64, error: Option<f64>) -> Record {
    Record::default().with("what", what).with("seconds", seconds).with("error_rad", error)
}

fn fail(error: impl std::fmt::Display) -> Failure {
    Failure::Method(format!("bench: {error}"))
}

/// Task that computes the states at places, times with their ticks. `begin` begins a run and returns the orientation at a place.
fn states<F: FnMut(f64, i64) -> Orientation<f64>>(
    what: &str,
    (places, truth): (&[(f64, i64)], &[FullState]),
    begin: impl Fn() -> F,
) -> Record {
    let (seconds, found) = least(STATES, || {
        let mut state = begin();
        places.iter().map(|&(t, n)| state(t, n)).collect::<Vec<_>>()
    });
    let errors = found.iter().zip(truth).map(|(found, truth)| found.distance(&truth.orientation()));
    row(what, seconds, Some(errors.fold(0.0, f64::max)))
}

fn rows(scenario: &Scenario) -> Result<Vec<Record>, Failure> {
    let motion = &scenario.motion;
    let period = motion.period_advance().map_or(1.0, |advance| advance.period);
    // whole ticks whose times are exact in f64, so that all methods compute the same times
    let apart = (f64::from(PERIODS) * period / f64::from(STATES) * f64::from(HERTZ)).round();
    let place = |i: u32| (f64::from(i) * (apart / f64::from(HERTZ)), i64::from(i) * apart as i64);
    let places: Vec<_> = (1..=STATES).map(place).collect();
    let truth = full_equations::states(scenario, &places.iter().map(|(t, _)| *t).collect::<Vec<_>>())?;
    let tick = Tick::hertz(HERTZ).map_err(fail)?;
    let (top, state) = full_equations::start(scenario);
    let (set_up, table) = least(1, || EphemerisF64::new(motion, tick));
    let table = table.map_err(fail)?;
    let single = EphemerisF32::new(motion, tick).map_err(fail)?;
    let of_states = (&*places, &*truth);
    let mut rows = vec![
        states(
            &format!("full solver, tolerance {TOLERANCE:.0e}: orientation and angular velocity"),
            of_states,
            || {
                let mut solver = FullSolver::new(top, state, TOLERANCE);
                move |t, _| solver.advance_to(t).map_or(Orientation::IDENTITY, |state| state.orientation())
            },
        ),
        states(
            &format!(
                "Runge-Kutta of the full equations, {} steps a period: the same",
                STEPS * STATES / PERIODS
            ),
            of_states,
            || {
                let (equations, step) = (Equations::of(&top, &state), places[0].0 / f64::from(STEPS));
                let mut y = equations.numbers(&state);
                move |_, _| {
                    (0..STEPS).for_each(|_| y = equations.runge_kutta(&y, step));
                    equations.state(&y).orientation()
                }
            },
        ),
        states("ephemeris f64, 48x11, at any time: the same", of_states, || {
            |t, _| {
                let now = table.at(t);
                black_box(now.omega());
                now.orientation()
            }
        }),
        states("ephemeris f64, 48x11, at any time: orientation", of_states, || {
            |t, _| table.at(t).orientation()
        }),
        states("ephemeris f64, 48x11, at any tick: orientation", of_states, || {
            |_, n| table.at_tick(n).orientation()
        }),
        row("ephemeris f64: its set-up, once", set_up, None),
    ];
    rows.extend(ephemeris("f32", &single));
    rows.extend(ephemeris("f64", &table));
    rows.extend([stepper::<f32>("f32", motion), stepper::<f64>("f64", motion)]);
    Ok(rows)
}

/// Ticks of a run: enough for the clock, and few enough for the cache.
const TICKS: u32 = 4096;
const FIRST: i64 = 1 << 40;

fn per_tick(what: &str, task: impl FnMut()) -> Record {
    row(what, least(TICKS, task).0, None)
}

fn ephemeris<R: EphemerisScalar>(name: &str, table: &EphemerisView<R>) -> [Record; 3] {
    let name = format!("ephemeris {name}, {}x{}", table.capacity(), R::TERMS);
    let mut out = vec![Orientation::<R>::IDENTITY; TICKS as usize];
    let batch = per_tick(&format!("{name}: in a batch"), || {
        table.fill(black_box(FIRST), &mut out);
        black_box(&mut out);
    });
    let next = per_tick(&format!("{name}: the next tick"), || {
        let mut cursor = table.cursor(black_box(FIRST));
        (0..TICKS).for_each(|_| {
            black_box(cursor.next().orientation());
        });
    });
    let any = per_tick(&format!("{name}: any tick"), || {
        (0..i64::from(TICKS)).for_each(|n| {
            black_box(table.at_tick(black_box(FIRST + n)).orientation());
        });
    });
    [batch, next, any]
}

fn stepper<R: Real>(name: &str, motion: &Motion) -> Record {
    let mut stepper = Stepper::<R>::new(motion);
    let step = R::from_f64(1e-3);
    per_tick(&format!("stepper {name}: a step"), || {
        (0..TICKS).for_each(|_| {
            stepper.step(step);
            black_box(stepper.orientation());
        });
    })
}

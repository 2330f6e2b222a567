//! `toytop timings`: computing times of a state, by the core and by other methods, on this machine with this build.

use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use serde::Serialize;
use serde_json::json;
use std::hint::black_box;
use std::time::Instant;
use toytop::scalar::Real;
use toytop::{Motion, Stepper, Table, TableF32, TableF64, TableScalar, Tick};
use toytop_host::Failure;
use toytop_host::input::builtin;
use toytop_host::motion::full_solver::{FullSolver, initial_state};
use toytop_host::output::{self, Format, significant};
use toytop_model::equations::Equations;

/// Name of the built-in motion that is timed.
const CURVE_WITH_CUSPS: &str = "figure 3 e3=1.85";
/// Number of states of a task: enough for the clock, and few enough for the cache.
const STATES: u32 = 4096;
/// Number of steps of the Runge-Kutta method in a nutation period.
const STEPS_A_PERIOD: u32 = 6400;
/// Number of states in a nutation period.
const STATES_A_PERIOD: u32 = 10;
/// Tick of the first state of a table.
const FIRST_TICK: i64 = 1 << 40;
/// Tolerance of the full solver.
const TOLERANCE: f64 = 1e-12;
/// Number of runs of a task, of which the least time counts, because other processes can only make a run longer.
const RUNS: u32 = 5;

/// Time of a task. The names are the keys of JSON.
#[derive(Serialize)]
struct TimedTask {
    /// Task.
    what: String,
    /// Least time of a state, s.
    seconds: f64,
}

/// Time of a task that computes this many states.
fn time(what: impl Into<String>, states: u32, mut task: impl FnMut()) -> TimedTask {
    let run = |_| {
        let started = Instant::now();
        task();
        started.elapsed().as_secs_f64() / f64::from(states)
    };
    TimedTask { what: what.into(), seconds: (0..RUNS).map(run).fold(f64::INFINITY, f64::min) }
}

/// Computing times on this machine: table, stepper, full solver
#[derive(Args)]
#[command(alias = "bench", after_help = "Example: toytop timings --format json")]
pub struct TimingsArgs {
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &TimingsArgs) -> Result<Report, Failure> {
    let rows = rows();
    let table = || {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
        let line = |task: &TimedTask| {
            [task.what.clone(), short_seconds(task.seconds), significant(1e-6 / task.seconds, 3)]
        };
        let header = ["", "time of a state", "million a second"];
        format!(
            "{}\nThe paper's curve with cusps. Any ticks are independent, so that the processor overlaps them; the next tick waits for\n\
             the one before. Least of {RUNS} runs on one core of {cores}; {build}.\n",
            TextTable::new(1, header, rows.iter().map(line)).aligned(),
        )
    };
    Ok(output::render(arguments.format, &json!({ "rows": rows }), &rows, table).into())
}

/// Time with three digits and a unit.
fn short_seconds(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        x if x < 1e-6 => (1e9, "ns"),
        x if x < 1e-3 => (1e6, "µs"),
        x if x < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{} {unit}", significant(scale * seconds, 3))
}

/// Rows of all tasks.
fn rows() -> Vec<TimedTask> {
    let mut figures = builtin::figures().into_iter();
    let scenario = figures.find(|scenario| scenario.name == CURVE_WITH_CUSPS).expect("a built-in motion");
    let motion = &scenario.motion;
    let period = motion.advance().map_or(1.0, |advance| advance.period);
    let apart = period / f64::from(STATES_A_PERIOD);
    let times = |states: u32| (1..=states).map(move |i| f64::from(i) * apart);
    let (top, state) = (motion.top(), initial_state(&scenario));
    let tick = Tick::hertz(1024).expect("a rate");
    let double = TableF64::new(motion, tick).expect("a table");
    let single = TableF32::new(motion, tick).expect("a table");
    let solver = FullSolver::new(top, state, TOLERANCE).expect("a solver");
    let full = time(format!("full solver, tolerance {TOLERANCE:.0e}"), STATES / 8, || {
        let mut solver = solver.clone();
        times(STATES / 8).for_each(|t| drop(black_box(solver.advance_to(t))));
    });
    let runge_kutta = time(
        format!("Runge-Kutta of the full equations, {STEPS_A_PERIOD} steps a period"),
        STATES / 8,
        || {
            let equations = Equations::new(top, &state);
            let (mut y, step) = (equations.vector(&state), period / f64::from(STEPS_A_PERIOD));
            for _ in 0..STATES / 8 {
                (0..STEPS_A_PERIOD / STATES_A_PERIOD).for_each(|_| y = equations.runge_kutta(&y, step));
                black_box(equations.state(&y));
            }
        },
    );
    let set_up = time("table f64: its set-up, once", 1, || {
        drop(black_box(TableF64::new(black_box(motion), tick)));
    });
    let any_time = time("table f64: any time, with the angular velocity", STATES, || {
        times(STATES).for_each(|t| {
            let now = double.at(t);
            black_box((now.orientation(), now.omega()));
        });
    });
    let mut rows = vec![full, runge_kutta, set_up, any_time];
    rows.extend(time_table("f32", &single));
    rows.extend(time_table("f64", &double));
    rows.extend([time_stepper::<f32>("f32", motion), time_stepper::<f64>("f64", motion)]);
    rows
}

/// Rows of a table.
fn time_table<R: TableScalar>(scalar: &str, table: &Table<R>) -> [TimedTask; 2] {
    let next = time(format!("table {scalar}: the next tick"), STATES, || {
        let mut cursor = table.cursor(black_box(FIRST_TICK));
        (0..STATES).for_each(|_| {
            black_box(cursor.next(table).orientation());
        });
    });
    let any = time(format!("table {scalar}: any tick"), STATES, || {
        (0..i64::from(STATES)).for_each(|n| {
            black_box(table.at_tick(black_box(FIRST_TICK + n)).orientation());
        });
    });
    [next, any]
}

/// Row of a stepper.
fn time_stepper<R: Real>(scalar: &str, motion: &Motion) -> TimedTask {
    let mut stepper = Stepper::<R>::new(motion);
    let step = R::from_f64(1e-3);
    time(format!("stepper {scalar}: a step"), STATES, || {
        (0..STATES).for_each(|_| {
            stepper.step(step);
            black_box(stepper.orientation());
        });
    })
}

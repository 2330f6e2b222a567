//! Number of instructions of one call of each kind, counted by valgrind, which does not depend on how busy the machine is.

// the macros of gungraun write public items without documentation
#![allow(missing_docs, unreachable_pub)]

use fixed::types::{I2F14, I2F30};
use gungraun::{library_benchmark, library_benchmark_group, main};
use std::hint::black_box;
use toytop::scalar::Real;
use toytop::{
    Ephemeris, EphemerisScalar, Motion, Orientation, ParameterError, Release, State, Stepper, Tick, Top,
    TopParameters,
};
use toytop_host::full_equations::baseline::{EqualSteps, RungeKutta};
use toytop_host::full_equations::full_solver::FullSolver;
use toytop_host::full_equations::solution;
use toytop_host::measure::benchmark::{Benchmark, NUMBERS};

/// Number of ticks in a batch.
const TICKS: usize = 1024;
/// First tick of a batch.
const FIRST: i64 = 1 << 40;

// Each function prepares a call and returns it. Only the call is counted, not the drop of its result.

fn launch() -> impl FnOnce() -> Result<Motion, ParameterError> {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 3.0e-5,
        axial_inertia: 2.0e-5,
        com_height: 0.03,
        mass: 0.05,
        gravity: 9.81,
        ..TopParameters::default()
    })
    .expect("a top");
    let state = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).expect("a state");
    move || Motion::launch(black_box(&top), black_box(&state))
}

fn motion() -> Motion {
    NUMBERS.motion().expect("a motion")
}

fn tick() -> Tick {
    Tick::hertz(1024).expect("a tick")
}

fn table<R: EphemerisScalar, const S: usize>() -> Box<Ephemeris<R, S>> {
    Box::new(Ephemeris::new(&motion(), tick()).expect("a table that fits"))
}

fn any_tick<R: EphemerisScalar, const S: usize>() -> impl FnOnce() -> (Orientation<R>, Box<Ephemeris<R, S>>) {
    let table = table();
    move || (black_box(&table).at_tick(black_box(FIRST)).orientation(), table)
}

fn batch<R: EphemerisScalar, const S: usize>() -> impl FnOnce() -> (Vec<Orientation<R>>, Box<Ephemeris<R, S>>)
{
    let table = table();
    let mut out = vec![table.at_tick(0).orientation(); TICKS];
    move || {
        black_box(&table).fill(black_box(FIRST), &mut out);
        (out, table)
    }
}

fn stepper<R: Real>() -> impl FnOnce() -> Stepper<R> {
    let mut stepper = Stepper::<R>::new(&motion());
    move || {
        stepper.step(black_box(R::from_f64(1.0 / 1024.0)));
        stepper
    }
}

/// Call that integrates the full equations over a sixteenth of a period.
fn full_solver() -> impl FnOnce() -> FullSolver {
    let benchmark = Benchmark::new().expect("a benchmark");
    let (top, state) = solution::start(benchmark.scenario());
    let mut solver = FullSolver::new(top, state, 1e-9);
    move || {
        solver.advance_to(black_box(benchmark.apart())).expect("the motion of the benchmark");
        solver
    }
}

fn runge_kutta() -> impl FnOnce() -> EqualSteps<RungeKutta> {
    let (top, state) = solution::start(Benchmark::new().expect("a benchmark").scenario());
    let mut steps = EqualSteps::new(&top, &state, 1.0 / 1024.0);
    move || {
        steps.step();
        steps
    }
}

#[library_benchmark]
#[bench::launch(launch())]
#[bench::any_tick_f32_25x5(any_tick::<f32, 25>())]
#[bench::any_tick_f64_48x11(any_tick::<f64, 48>())]
#[bench::any_tick_q31_64x5(any_tick::<I2F30, 64>())]
#[bench::any_tick_q15_32x4(any_tick::<I2F14, 32>())]
#[bench::batch_of_1024_f32(batch::<f32, 25>())]
#[bench::batch_of_1024_f64(batch::<f64, 48>())]
#[bench::stepper_f32(stepper::<f32>())]
#[bench::stepper_f64(stepper::<f64>())]
#[bench::full_solver_1e_9_to_the_next_moment(full_solver())]
#[bench::rk4_one_step(runge_kutta())]
fn call<T, C: FnOnce() -> T>(call: C) -> T {
    call()
}

library_benchmark_group!(name = one, benchmarks = [call]);

main!(library_benchmark_groups = one);

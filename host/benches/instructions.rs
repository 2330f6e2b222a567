//! Instructions of one call each, counted by valgrind: the same numbers however busy the machine is.

// the macros of gungraun write public items without documentation
#![allow(missing_docs, unreachable_pub)]

use fixed::types::{I2F14, I2F30};
use gungraun::{library_benchmark, library_benchmark_group, main};
use std::hint::black_box;
use toytop::real::Real;
use toytop::{
    Ephemeris, FixedStepper, Heaviness, LaunchError, Motion, Phi, Release, State, Stepper, Tabular, Tick, Top,
};
use toytop_host::baseline::{EqualSteps, RungeKutta};
use toytop_host::full_solver::FullSolver;
use toytop_host::race::{NUMBERS, Race};
use toytop_host::truth;

/// Of a batch.
const TICKS: usize = 1024;
/// The first of them.
const FIRST: i64 = 1 << 40;

// Each sets up what a call needs and returns the call, which alone is counted; what it returns is dropped behind it.

fn launch() -> impl FnOnce() -> Result<Motion, LaunchError> {
    let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81).expect("a top");
    let state = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).expect("a state");
    move || Motion::launch(black_box(&top), black_box(&state))
}

fn motion() -> Motion {
    NUMBERS.motion().expect("a motion")
}

fn tick() -> Tick {
    Tick::hertz(1024).expect("a tick")
}

fn table<R: Tabular, const S: usize, const T: usize>() -> Box<Ephemeris<R, S, T>> {
    Box::new(Ephemeris::new(&motion(), tick()).expect("a table that fits"))
}

fn any_tick<R: Tabular, const S: usize, const T: usize>() -> impl FnOnce() -> (Phi<R>, Box<Ephemeris<R, S, T>>)
{
    let table = table();
    move || (black_box(&table).at_tick(black_box(FIRST)).phi(), table)
}

fn batch<R: Tabular, const S: usize, const T: usize>()
-> impl FnOnce() -> (Vec<Phi<R>>, Box<Ephemeris<R, S, T>>) {
    let table = table();
    let mut out = vec![table.at_tick(0).phi(); TICKS];
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

fn fixed_stepper() -> impl FnOnce() -> FixedStepper<32, 8> {
    let mut stepper = FixedStepper::new(&motion(), tick()).expect("it fits");
    move || {
        stepper.step();
        stepper
    }
}

/// A sixteenth of a period.
fn full_solver() -> impl FnOnce() -> FullSolver {
    let race = Race::new().expect("a race");
    let (top, state) = truth::start(race.scenario());
    let mut solver = FullSolver::new(top, state, 1e-9);
    move || {
        solver.advance_to(black_box(race.apart())).expect("the motion of the race");
        solver
    }
}

fn runge_kutta() -> impl FnOnce() -> EqualSteps<RungeKutta> {
    let (top, state) = truth::start(Race::new().expect("a race").scenario());
    let mut steps = EqualSteps::new(&top, &state, 1.0 / 1024.0);
    move || {
        steps.step();
        steps
    }
}

#[library_benchmark]
#[bench::launch(launch())]
#[bench::any_tick_f32_25x5(any_tick::<f32, 25, 5>())]
#[bench::any_tick_f64_48x11(any_tick::<f64, 48, 11>())]
#[bench::any_tick_q31_64x5(any_tick::<I2F30, 64, 5>())]
#[bench::any_tick_q15_32x4(any_tick::<I2F14, 32, 4>())]
#[bench::batch_of_1024_f32(batch::<f32, 25, 5>())]
#[bench::batch_of_1024_f64(batch::<f64, 48, 11>())]
#[bench::stepper_f32(stepper::<f32>())]
#[bench::stepper_f64(stepper::<f64>())]
#[bench::stepper_q31(fixed_stepper())]
#[bench::full_solver_1e_9_to_the_next_moment(full_solver())]
#[bench::rk4_one_step(runge_kutta())]
fn call<T, C: FnOnce() -> T>(call: C) -> T {
    call()
}

library_benchmark_group!(name = one, benchmarks = [call]);

main!(library_benchmark_groups = one);

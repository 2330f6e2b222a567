//! Cost of each call on a chip: the calls of core, and those of the baselines.
//!
//! Every call is a function with a symbol, `bench_...`, which `toytop budget` looks for in QEMU's trace. A call starts
//! from a tick number, a cursor or a state and ends when α, β, u and c are in memory, `bench_omega_...` when α, β and
//! the angular velocity in the body frame are, `bench_omega_fixed_...` in the fixed frame. The program prints the costs that a trace does not show, in one line per
//! call, `NAME stack BYTES ram BYTES`; with the feature `dwt`, on a board, also `cycles COUNT`.

#![no_std]
#![no_main]

/// Functions with a symbol each, by which `toytop budget` finds them.
macro_rules! symbols {
    ($($(#[$doc:meta])* fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)? $body:block)*) => {$(
        $(#[$doc])*
        #[inline(never)]
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name($($argument: $type),*) $(-> $result)? $body
    )*};
}

mod baselines;
mod calls;
mod full_equations;

use core::hint::black_box;
use core::mem::size_of_val;

use calls::{Measured, Memory, Output, Reader};
use full_equations::{Constants, Point};
use semihosting::process;
use toytop::scalar::{Float, Real};
use toytop::{
    Motion, Orientation, Phase, State, Stepper, TableF32, TableF64, TableQ15, TableQ31, Tick, Workspace,
};
use toytop_cost::entry;
use toytop_cost::meter::Meter;

/// Number of calls of each kind, of which the costliest counts.
const CALLS: usize = 8;
/// Distance of the ticks of two calls: a prime, so that the ticks are in segments of every kind.
const STRIDE: i64 = 1_000_003;

#[entry]
fn main() -> ! {
    let mut meter = Meter::start();
    let measured = Measured::default();

    launch(&mut meter, "bench_launch", &measured, calls::bench_launch);
    let mut out = Output::default();
    meter.measure("bench_new", size_of::<Memory<25>>(), 1, |_| {
        assert!(calls::bench_new(black_box(&measured), &mut out), "the motion fits");
    });
    black_box(out);
    launch(&mut meter, "bench_launch_slow", &Measured::slow(), calls::bench_launch_slow);
    launch(&mut meter, "bench_launch_falling", &Measured::falling(), calls::bench_launch_falling);
    in_static(&mut meter, &measured);
    let motion = measured.motion().expect("a possible top");
    let tick = Tick::hertz(calls::TICK_RATE).expect("positive");
    let double = TableF64::new(&motion, tick).expect("the motion fits");
    let single = TableF32::new(&motion, tick).expect("the motion fits");

    any_tick(&mut meter, "bench_ephemeris_f32", &single, calls::bench_ephemeris_f32);
    any_tick(&mut meter, "bench_ephemeris_f64", &double, calls::bench_ephemeris_f64);
    any_tick(&mut meter, "bench_omega_f32", &single, calls::bench_omega_f32);
    any_tick(&mut meter, "bench_omega_fixed_f32", &single, calls::bench_omega_fixed_f32);
    let reader = Reader { cursor: single.cursor(STRIDE), table: &single };
    next_tick(&mut meter, "bench_cursor_f32", reader, calls::bench_cursor_f32);
    let reader = Reader { cursor: double.cursor(STRIDE), table: &double };
    next_tick(&mut meter, "bench_cursor_f64", reader, calls::bench_cursor_f64);
    fixed_point(&mut meter, &motion, tick);
    stepper(&mut meter, &motion, "bench_stepper_f32", calls::bench_stepper_f32);
    stepper(&mut meter, &motion, "bench_stepper_f64", calls::bench_stepper_f64);
    let state = measured.state().expect("a possible release");
    let start = (&motion, &state);
    runge_kutta(&mut meter, "bench_rk4_f32", start, &single, baselines::bench_rk4_f32);
    runge_kutta(&mut meter, "bench_multicalc_rk4_f32", start, &single, baselines::bench_multicalc_rk4_f32);
    runge_kutta(&mut meter, "bench_rk4_f64", start, &single, baselines::bench_rk4_f64);
    sines(&mut meter);
    process::exit(0)
}

/// Measures a set-up with its own memory.
#[inline(never)] // its table must not stay on the stack
fn launch<const SEGMENTS: usize>(
    meter: &mut Meter,
    name: &str,
    measured: &Measured,
    call: extern "C" fn(&mut Memory<SEGMENTS>, &Measured) -> bool,
) {
    let mut memory = Memory::new();
    meter.measure(name, size_of_val(&memory), 1, |_| {
        assert!(call(&mut memory, black_box(measured)), "the motion fits");
    });
}

/// Set-up in static memory: the workspace counts as memory that is kept, and not as stack.
#[inline(never)] // their memory must not stay on the stack
fn in_static(meter: &mut Meter, measured: &Measured) {
    let top = measured.top().expect("a possible top");
    let input = (top, measured.state().expect("a possible state"));
    let (mut workspace, mut table) = (Workspace::new(), Memory::<25>::new());
    let ram = size_of_val(&workspace) + size_of_val(&table);
    meter.measure("bench_launch_in_static", ram, 1, |_| {
        assert!(
            calls::bench_launch_in_static(&mut workspace, &mut table, black_box(&input)),
            "the motion fits"
        );
    });
}

/// Measures a call at distant ticks of a table.
fn any_tick<T, O: Default>(meter: &mut Meter, name: &str, table: &T, call: extern "C" fn(&T, i64, &mut O)) {
    let mut out = O::default();
    meter.measure(name, size_of_val(table), CALLS, |number| {
        call(table, black_box(number as i64 * STRIDE), &mut out);
    });
    black_box(out);
}

/// Measures a call at consecutive ticks of a table.
fn next_tick<R, T, O: Default>(
    meter: &mut Meter,
    name: &str,
    mut reader: Reader<'_, R, T>,
    call: extern "C" fn(&mut Reader<'_, R, T>, &mut O),
) {
    let mut out = O::default();
    let ram = size_of_val(reader.table) + size_of_val(&reader);
    meter.measure(name, ram, CALLS, |_| call(&mut reader, &mut out));
    black_box(out);
}

fn fixed_point(meter: &mut Meter, motion: &Motion, tick: Tick) {
    let long = TableQ31::new(motion, tick).expect("the motion fits");
    let reader = || Reader { cursor: long.cursor(STRIDE), table: &long };
    any_tick(meter, "bench_ephemeris_q31", &long, calls::bench_ephemeris_q31);
    any_tick(meter, "bench_omega_q31", &long, calls::bench_omega_q31);
    next_tick(meter, "bench_cursor_q31", reader(), calls::bench_cursor_q31);
    next_tick(meter, "bench_tip_q31", reader(), calls::bench_tip_q31);
    let short = TableQ15::new(motion, tick).expect("the motion fits");
    any_tick(meter, "bench_ephemeris_q15", &short, calls::bench_ephemeris_q15);
    let reader = Reader { cursor: short.cursor(STRIDE), table: &short };
    next_tick(meter, "bench_cursor_q15", reader, calls::bench_cursor_q15);
}

fn stepper<R: Real + Default>(
    meter: &mut Meter,
    motion: &Motion,
    name: &str,
    call: extern "C" fn(&mut Stepper<R>, &mut Output<R>),
) {
    let (mut stepper, mut out) = (Stepper::<R>::new(motion), Output::default());
    meter.measure(name, size_of_val(&stepper), CALLS, |_| call(&mut stepper, &mut out));
    black_box(out);
}

fn runge_kutta<R: Float + Default>(
    meter: &mut Meter,
    name: &str,
    (motion, state): (&Motion, &State),
    truth: &TableF32,
    call: extern "C" fn(&Constants<R>, &mut Point<R>, &mut Output<R>),
) {
    let constants = Constants::of(motion, calls::TICK_RATE);
    let (mut point, mut out) = (full_equations::start(motion, state), Output::default());
    let ram = size_of_val(&constants) + size_of_val(&point);
    meter.measure(name, ram, CALLS, |_| call(&constants, &mut point, &mut out));
    same_motion(&out, truth);
}

/// Measures sines of angles within one turn, because the baselines take longer for large angles.
fn sines(meter: &mut Meter) {
    // computed before, so that their stack is not measured
    let turns: [Phase; CALLS] =
        black_box(core::array::from_fn(|call| Phase::from_turns(call as f64 * 0.119)));
    let angles: [f64; CALLS] = black_box(core::array::from_fn(|call| call as f64 * 0.75));
    let single = black_box(angles.map(|angle| angle as f32));
    sine(meter, "bench_sincos_ours_f32", turns.each_ref(), baselines::bench_sincos_ours_f32);
    sine(meter, "bench_sincos_libm_f32", single, baselines::bench_sincos_libm_f32);
    sine(meter, "bench_sincos_micromath_f32", single, baselines::bench_sincos_micromath_f32);
    sine(meter, "bench_sincos_ours_f64", turns.each_ref(), baselines::bench_sincos_ours_f64);
    sine(meter, "bench_sincos_libm_f64", angles, baselines::bench_sincos_libm_f64);
}

fn sine<A: Copy, O: Default>(
    meter: &mut Meter,
    name: &str,
    angles: [A; CALLS],
    call: extern "C" fn(A, &mut O),
) {
    let mut out = O::default();
    meter.measure(name, 0, CALLS, |number| call(angles[number], &mut out));
    black_box(out);
}

/// Asserts that a baseline has the orientation and tip of the table after the same number of ticks.
fn same_motion<R: Float>(out: &Output<R>, truth: &TableF32) {
    let sample = truth.at_tick(CALLS as i64);
    let (orientation, u, tip) = (sample.orientation(), sample.u(), sample.tip_over_s());
    let near = |found: R, there: f32| (found.to_f64() - f64::from(there)).abs() < 1e-5;
    let Orientation { alpha, beta } = out.orientation;
    assert!(
        near(alpha.re, orientation.alpha.re) && near(beta.im, orientation.beta.im),
        "not the same motion"
    );
    assert!(near(out.u, u) && near(out.c.re, tip.re) && near(out.c.im, tip.im), "not the same tip");
}

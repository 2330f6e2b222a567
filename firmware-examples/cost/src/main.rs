//! Cost of each call on a chip: the calls of core, and those of the baselines.
//!
//! Every call is a function with a symbol, `bench_...`, which `toytop budget` looks for in QEMU's trace. A call starts
//! from a tick number, a cursor or a state and ends when α, β, u and c are in memory, `bench_omega_...` when α, β and
//! the angular velocity in the body frame are. The program prints the costs that a trace does not show, in one line per
//! call, `NAME stack BYTES ram BYTES`; with the feature `dwt`, on a board, also `cycles COUNT`.

#![no_std]
#![no_main]

mod baselines;
mod calls;
mod full_equations;
mod measure;
mod start;

use core::hint::black_box;
use core::mem::size_of_val;

use calls::{Measured, Memory, Output, Rates, Reader, Stepping};
use fixed::types::I2F30;
use full_equations::{Constants, start};
use measure::Meter;
use semihosting::process;
use toytop::scalar::{Float, Real};
use toytop::{
    EphemerisF32, EphemerisF64, EphemerisQ15, EphemerisQ31, Motion, Orientation, Phase, Pose, Tick, Workspace,
};

use start::entry;

/// Number of calls of each kind, of which the costliest counts.
const CALLS: usize = 8;
/// Distance of the ticks of two calls: a prime, so that the ticks are in segments of every kind.
const STRIDE: i64 = 1_000_003;

#[entry]
fn main() -> ! {
    let mut meter = Meter::new();
    let measured = Measured::default();

    let mut memory = Memory::<25>::new();
    meter.measure("bench_launch", size_of_val(&memory), 1, |_| {
        assert!(calls::bench_launch(&mut memory, black_box(&measured)), "the motion fits");
    });
    let mut out = Output::default();
    meter.measure("bench_new", size_of_val(&memory), 1, |_| {
        assert!(calls::bench_new(black_box(&measured), &mut out), "the motion fits");
    });
    black_box(out);
    other_launches(&mut meter);
    in_slices(&mut meter, &measured);
    let motion = measured.motion().expect("a possible top");
    let tick = Tick::hertz(calls::TICK_RATE).expect("positive");
    let double = EphemerisF64::new(&motion, tick).expect("the motion fits");
    let single = EphemerisF32::new(&motion, tick).expect("the motion fits");

    ephemerides(&mut meter, &single, &double);
    fixed_point(&mut meter, &motion, tick);
    stepper(&mut meter, &motion, "bench_stepper_f32", calls::bench_stepper_f32);
    stepper(&mut meter, &motion, "bench_stepper_f64", calls::bench_stepper_f64);
    runge_kutta(&mut meter, &measured, &motion, &single);
    sines(&mut meter);
    process::exit(0)
}

/// Set-ups that cost more than that of a fast top.
#[inline(never)] // its table must not stay on the stack
fn other_launches(meter: &mut Meter) {
    let (slow, falling) = (Measured::slow(), Measured::falling());
    let mut table = Memory::<64>::new();
    meter.measure("bench_launch_slow", size_of_val(&table), 1, |_| {
        assert!(calls::bench_launch_slow(&mut table, black_box(&slow)), "the motion fits");
    });
    let mut table = Memory::<128>::new();
    meter.measure("bench_launch_falling", size_of_val(&table), 1, |_| {
        assert!(calls::bench_launch_falling(&mut table, black_box(&falling)), "the motion fits");
    });
}

/// Set-up in slices: the set-up counts as memory that is kept, and not as stack.
#[inline(never)] // their memory must not stay on the stack
fn in_slices(meter: &mut Meter, measured: &Measured) {
    let top = measured.top().expect("a possible top");
    let input = (top, measured.state().expect("a possible state"));
    let (mut workspace, mut table) = (Workspace::new(), Memory::<25>::new());
    let ram = size_of_val(&workspace) + size_of_val(&table);
    meter.measure("bench_slices", ram, 1, |_| {
        assert!(calls::bench_slices(&mut workspace, &mut table, black_box(&input)), "the motion fits");
    });
}

fn ephemerides(meter: &mut Meter, single: &EphemerisF32, double: &EphemerisF64) {
    let tick = |call: usize| black_box(call as i64 * STRIDE);
    let (mut out, mut wide) = (Output::default(), Output::default());
    meter.measure("bench_ephemeris_f32", size_of_val(single), CALLS, |call| {
        calls::bench_ephemeris_f32(single, tick(call), &mut out);
    });
    meter.measure("bench_ephemeris_f64", size_of_val(double), CALLS, |call| {
        calls::bench_ephemeris_f64(double, tick(call), &mut wide);
    });
    let mut rates = Rates::ZERO;
    meter.measure("bench_omega_f32", size_of_val(single), CALLS, |call| {
        calls::bench_omega_f32(single, tick(call), &mut rates);
    });
    meter.measure("bench_omega_fixed_f32", size_of_val(single), CALLS, |call| {
        calls::bench_omega_fixed_f32(single, tick(call), &mut rates);
    });
    black_box((rates.orientation, rates.omega));
    let mut reader = Reader { cursor: single.cursor(STRIDE), table: single };
    let ram = size_of_val(single) + size_of_val(&reader);
    meter.measure("bench_cursor_f32", ram, CALLS, |_| calls::bench_cursor_f32(&mut reader, &mut out));
    let mut reader = Reader { cursor: double.cursor(STRIDE), table: double };
    let ram = size_of_val(double) + size_of_val(&reader);
    meter.measure("bench_cursor_f64", ram, CALLS, |_| calls::bench_cursor_f64(&mut reader, &mut wide));
    black_box((out, wide));
}

fn fixed_point(meter: &mut Meter, motion: &Motion, tick: Tick) {
    let at = |call: usize| black_box(call as i64 * STRIDE);
    let (mut long, mut short) = (Output::default(), Output::default());
    let ephemeris = EphemerisQ31::new(motion, tick).expect("the motion fits");
    let ram = size_of_val(&ephemeris);
    meter.measure("bench_ephemeris_q31", ram, CALLS, |call| {
        calls::bench_ephemeris_q31(&ephemeris, at(call), &mut long);
    });
    let mut rates = Rates::ZERO;
    meter.measure("bench_omega_q31", ram, CALLS, |call| {
        calls::bench_omega_q31(&ephemeris, at(call), &mut rates);
    });
    black_box((rates.orientation, rates.omega));
    let mut reader = Reader { cursor: ephemeris.cursor(STRIDE), table: &ephemeris };
    let ram = ram + size_of_val(&reader);
    meter.measure("bench_cursor_q31", ram, CALLS, |_| calls::bench_cursor_q31(&mut reader, &mut long));
    let mut metres = (Orientation::IDENTITY, toytop::Complex::new(0.0, 0.0));
    meter.measure("bench_tip_q31", ram, CALLS, |_| {
        calls::bench_tip_q31(&mut reader, &mut metres);
    });
    black_box(metres);
    let ephemeris = EphemerisQ15::new(motion, tick).expect("the motion fits");
    let ram = size_of_val(&ephemeris);
    meter.measure("bench_ephemeris_q15", ram, CALLS, |call| {
        calls::bench_ephemeris_q15(&ephemeris, at(call), &mut short);
    });
    let mut reader = Reader { cursor: ephemeris.cursor(STRIDE), table: &ephemeris };
    let ram = ram + size_of_val(&reader);
    meter.measure("bench_cursor_q15", ram, CALLS, |_| calls::bench_cursor_q15(&mut reader, &mut short));
    black_box((long, short));
}

fn stepper<R: Real + Default>(
    meter: &mut Meter,
    motion: &Motion,
    name: &str,
    call: extern "C" fn(&mut Stepping<R>, &mut Output<R>),
) {
    let (mut stepping, mut out) = (Stepping::<R>::new(motion), Output::default());
    meter.measure(name, size_of_val(&stepping), CALLS, |_| call(&mut stepping, &mut out));
    black_box(out);
}

fn runge_kutta(meter: &mut Meter, measured: &Measured, motion: &Motion, truth: &EphemerisF32) {
    let state = measured.state().expect("a possible release");
    let constants = Constants::<f32>::of(motion, calls::TICK_RATE);
    let (mut point, mut out) = (start(motion, &state), Output::default());
    let ram = size_of_val(&constants) + size_of_val(&point);
    meter.measure("bench_rk4_f32", ram, CALLS, |_| {
        baselines::bench_rk4_f32(&constants, &mut point, &mut out);
    });
    same_motion(&out, truth);
    let mut point = start(motion, &state);
    meter.measure("bench_multicalc_rk4_f32", ram, CALLS, |_| {
        baselines::bench_multicalc_rk4_f32(&constants, &mut point, &mut out);
    });
    same_motion(&out, truth);
    let constants = Constants::<f64>::of(motion, calls::TICK_RATE);
    let (mut point, mut wide) = (start(motion, &state), Output::default());
    let ram = size_of_val(&constants) + size_of_val(&point);
    meter.measure("bench_rk4_f64", ram, CALLS, |_| {
        baselines::bench_rk4_f64(&constants, &mut point, &mut wide);
    });
    same_motion(&wide, truth);
}

/// Measures sines of angles within one turn, because the baselines take longer for large angles.
fn sines(meter: &mut Meter) {
    // computed before, so that their stack is not measured
    let turns: [Phase; CALLS] =
        black_box(core::array::from_fn(|call| Phase::from_turns(call as f64 * 0.119)));
    let angles: [f64; CALLS] = black_box(core::array::from_fn(|call| call as f64 * 0.75));
    let single = black_box(angles.map(|angle| angle as f32));
    let (mut pair, mut wide) = ([0.0; 2], [0.0; 2]);
    meter.measure("bench_sincos_ours_f32", 0, CALLS, |call| {
        baselines::bench_sincos_ours_f32(&turns[call], &mut pair);
    });
    let mut fixed = [I2F30::ZERO; 2];
    meter.measure("bench_sincos_ours_q31", 0, CALLS, |call| {
        baselines::bench_sincos_ours_q31(&turns[call], &mut fixed);
    });
    meter.measure("bench_sincos_libm_f32", 0, CALLS, |call| {
        baselines::bench_sincos_libm_f32(single[call], &mut pair);
    });
    meter.measure("bench_sincos_micromath_f32", 0, CALLS, |call| {
        baselines::bench_sincos_micromath_f32(single[call], &mut pair);
    });
    meter.measure("bench_sincos_ours_f64", 0, CALLS, |call| {
        baselines::bench_sincos_ours_f64(&turns[call], &mut wide);
    });
    meter.measure("bench_sincos_libm_f64", 0, CALLS, |call| {
        baselines::bench_sincos_libm_f64(angles[call], &mut wide);
    });
    black_box((pair, fixed, wide));
}

/// Asserts that a baseline has the orientation and tip of the ephemeris after the same number of ticks.
fn same_motion<R: Float>(out: &Output<R>, truth: &EphemerisF32) {
    let Pose { orientation, u, tip } = truth.at_tick(CALLS as i64).pose();
    let near = |found: R, there: f32| (found.to_f64() - f64::from(there)).abs() < 1e-5;
    let Orientation { alpha, beta } = out.orientation;
    assert!(
        near(alpha.re, orientation.alpha.re) && near(beta.im, orientation.beta.im),
        "not the same motion"
    );
    assert!(near(out.u, u) && near(out.c.re, tip.re) && near(out.c.im, tip.im), "not the same tip");
}

//! Times of a tick: by stepper, by cursor, at any tick, at any time, in a batch, in floating and fixed point.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use fixed::types::{I2F14, I2F30};
use std::hint::black_box;
use toytop::scalar::Real;
use toytop::{Ephemeris, EphemerisScalar, Motion, Stepper, Tick};
use toytop_host::measure::benchmark::NUMBERS;

/// Number of ticks in a batch: enough for the clock, and few enough for the cache.
const TICKS: usize = 4096;
/// First tick of a batch.
const FIRST: i64 = 1 << 40;

fn ephemeris<R: EphemerisScalar, const SEGMENTS: usize>(c: &mut Criterion, name: &str, motion: &Motion) {
    let tick = Tick::hertz(1024).expect("a tick");
    let table = Ephemeris::<R, SEGMENTS>::new(motion, tick).expect("a table that fits");
    let mut group = c.benchmark_group(format!("ephemeris {name}, {SEGMENTS}x{}", R::TERMS));
    let mut n = FIRST;
    let mut cursor = table.cursor(FIRST);
    group.bench_function("next tick", |b| b.iter(|| cursor.next(&table).orientation()));
    group.bench_function("next tick, and its tip", |b| b.iter(|| cursor.next(&table).orientation_and_tip()));
    let mut next = || {
        n += 1;
        black_box(n)
    };
    group.bench_function("any tick", |b| b.iter(|| table.at_tick(next()).orientation()));
    group.bench_function("any tick, with rates", |b| b.iter(|| table.at_tick(next()).attitude_state()));
    let mut t = 0.0;
    let mut later = || {
        t += 0.37;
        black_box(t)
    };
    group.bench_function("any time", |b| b.iter(|| table.at(later()).orientation()));
    group.throughput(Throughput::Elements(TICKS as u64));
    let mut out = vec![table.at_tick(FIRST).orientation(); TICKS];
    group.bench_function("batch", |b| b.iter(|| table.fill(black_box(FIRST), black_box(&mut out))));
    group.finish();
}

fn stepper<R: Real>(c: &mut Criterion, name: &str, motion: &Motion) {
    let dt = R::from_f64(1.0 / 1024.0);
    let mut group = c.benchmark_group(format!("stepper {name}"));
    group.throughput(Throughput::Elements(TICKS as u64));
    let go = |stepper: &mut Stepper<R>| {
        for _ in 0..TICKS {
            stepper.step(dt);
            black_box(stepper.orientation());
        }
    };
    let start = || Stepper::<R>::new(motion);
    group.bench_function("steps", |b| b.iter_batched_ref(start, go, BatchSize::SmallInput));
    group.finish();
}

fn ticks(c: &mut Criterion) {
    let motion = NUMBERS.motion().expect("a motion");
    ephemeris::<f32, 25>(c, "f32", &motion);
    ephemeris::<f64, 48>(c, "f64", &motion);
    ephemeris::<I2F30, 64>(c, "q31", &motion);
    ephemeris::<I2F14, 32>(c, "q15", &motion);
    stepper::<f32>(c, "f32", &motion);
    stepper::<f64>(c, "f64", &motion);
}

criterion_group!(benches, ticks);
criterion_main!(benches);

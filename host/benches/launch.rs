//! What a throw costs, once: the motion, its period, the tables.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use toytop::{Ephemeris, EphemerisF32, EphemerisF64, Heaviness, Motion, Release, State, Stepper, Tick, Top};
use toytop_host::race::NUMBERS;

fn launch(c: &mut Criterion) {
    let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81).expect("a top");
    let state = State::release(&Release { tilt: 0.35, spin: 150.0, ..Release::default() }).expect("a state");
    let motion = NUMBERS.motion().expect("a motion");
    let tick = Tick::hertz(1024).expect("a tick");
    let mut group = c.benchmark_group("launch");
    group.bench_function("motion from a state", |b| b.iter(|| Motion::launch(black_box(&top), &state)));
    group.bench_function("motion from branch points", |b| b.iter(|| black_box(&NUMBERS).motion()));
    group.bench_function("averages", |b| b.iter(|| black_box(&motion).averages()));
    group.bench_function("stepper f64", |b| b.iter(|| Stepper::<f64>::new(black_box(&motion))));
    group.bench_function("ephemeris f32, 25x5", |b| b.iter(|| EphemerisF32::new(black_box(&motion), tick)));
    let fewer =
        |b: &mut criterion::Bencher<'_>| b.iter(|| Ephemeris::<f64, 32, 11>::new(black_box(&motion), tick));
    group.bench_function("ephemeris f64, 32x11", fewer);
    group.bench_function("ephemeris f64, 48x11", |b| b.iter(|| EphemerisF64::new(black_box(&motion), tick)));
    group.finish();
}

criterion_group!(benches, launch);
criterion_main!(benches);

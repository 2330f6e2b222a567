//! Times of a launch: the motion, its period, the tables.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use toytop::{
    Ephemeris, EphemerisF32, EphemerisF64, Motion, Release, State, Stepper, Tick, Top, TopParameters,
};
use toytop_host::measure::benchmark::NUMBERS;

fn launch(c: &mut Criterion) {
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
    let motion = NUMBERS.motion().expect("a motion");
    let tick = Tick::hertz(1024).expect("a tick");
    let mut group = c.benchmark_group("launch");
    group.bench_function("motion from a state", |b| b.iter(|| Motion::launch(black_box(&top), &state)));
    group.bench_function("motion from branch points", |b| b.iter(|| black_box(&NUMBERS).motion()));
    group.bench_function("averages", |b| b.iter(|| black_box(&motion).period_advance()));
    group.bench_function("stepper f64", |b| b.iter(|| Stepper::<f64>::new(black_box(&motion))));
    group.bench_function("ephemeris f32, 25x5", |b| b.iter(|| EphemerisF32::new(black_box(&motion), tick)));
    let fewer =
        |b: &mut criterion::Bencher<'_>| b.iter(|| Ephemeris::<f64, 32>::new(black_box(&motion), tick));
    group.bench_function("ephemeris f64, 32x11", fewer);
    group.bench_function("ephemeris f64, 48x11", |b| b.iter(|| EphemerisF64::new(black_box(&motion), tick)));
    group.finish();
}

criterion_group!(benches, launch);
criterion_main!(benches);

//! Cost of a fit: a second of samples of a telephone's sensors at 1 kHz, from the samples to the launch, and a camera's.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use toytop::fit::{Fit, Measurement, Sensor};
use toytop::scalar::Real;
use toytop::{Motion, Release, State, Top, TopParameters};
use toytop_host::fit::sensors::{Body, Sensors};
use toytop_host::fit::simulated::{Recording, measurements};

fn run<F: Real>(top: &Top, sensors: &[&dyn Sensor<F>], samples: &[Measurement]) -> bool {
    let mut fit = Fit::new(top, sensors, &[]).expect("few sensors");
    fit.run(black_box(samples).iter().copied()).expect("finite samples").converged()
}

fn fits(c: &mut Criterion) {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 3e-5,
        axial_inertia: 2e-5,
        com_height: 0.03,
        mass: 0.05,
        gravity: 9.81,
        ..TopParameters::default()
    })
    .expect("a top");
    let release = Release { tilt: 0.35, spin: 150.0, precession: 2.0, nutation: 0.5, ..Release::default() };
    let state = State::release(&release).expect("a state");
    let motion = Motion::launch(&top, &state).expect("a motion");
    let sensors = Sensors::telephone(Body { tip_scale: top.tip_scale(), com: [0.0; 3] });
    let recording = Recording { hertz: 1000.0, count: 1000, seed: 7 };
    let samples = measurements(&motion, &sensors, &recording).expect("a periodic motion");
    let double: Vec<&dyn Sensor> =
        sensors.instruments.iter().map(|one| &*one.sensor as &dyn Sensor).collect();
    assert!(run(&top, &double, &samples), "the fit converges");
    let mut group = c.benchmark_group("fit of 1000 samples");
    group.bench_function("telephone, f64", |b| b.iter(|| run(&top, &double, &samples)));
    group.finish();
}

criterion_group!(benches, fits);
criterion_main!(benches);

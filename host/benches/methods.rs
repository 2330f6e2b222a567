//! Time of every method for 10 nutation periods with an orientation at 16 times in each. Tolerances and step sizes are those that give an
//! error of some 1e-9 rad, or the largest that are useful for a method; the errors are printed first.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::time::Duration;
use toytop_host::measure::benchmark::{Benchmark, Method, SAMPLES};

const PERIODS: u64 = 10;

const METHODS: [Method; 8] = [
    Method::EphemerisF64,
    Method::StepperF64(8),
    Method::FullSolver(1e-9),
    Method::RungeKutta(256),
    Method::Multicalc(256),
    Method::Exponential(256),
    Method::EphemerisF32,
    Method::StepperF32(16),
];

fn compared(c: &mut Criterion) {
    let benchmark = Benchmark::new().expect("a benchmark");
    let samples: Vec<u64> = (1..=PERIODS * u64::from(SAMPLES)).collect();
    let truth = benchmark.truth(&samples);
    let mut group = c.benchmark_group("methods, 160 orientations over 10 periods");
    group.throughput(Throughput::Elements(samples.len() as u64));
    for method in METHODS {
        let (errors, _) = benchmark.errors(method, &samples, &truth).expect("errors");
        let worst = errors.into_iter().fold(0.0, f64::max);
        let name = format!("{}, {}", method.name(), method.effort());
        println!("{name}: greatest error {worst:.1e} rad");
        // the time does not contain the set-up
        let timed = |runs: u64| -> Duration {
            (0..runs).map(|_| benchmark.run(method, &samples).map_or(Duration::ZERO, |(_, time)| time)).sum()
        };
        group.bench_function(name, |b| b.iter_custom(timed));
    }
    group.finish();
}

criterion_group!(benches, compared);
criterion_main!(benches);

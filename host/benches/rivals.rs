//! The same work by everybody: 10 nutation periods, an orientation at 16 moments in each. The efforts are those that reach
//! some 1e-9 rad there, or the least of which a method is worth its name; the errors are printed first.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::time::Duration;
use toytop_host::race::{Entrant, MOMENTS, Race};

const PERIODS: u64 = 10;

const ENTRANTS: [Entrant; 8] = [
    Entrant::EphemerisF64,
    Entrant::StepperF64(8),
    Entrant::FullSolver(1e-9),
    Entrant::RungeKutta(256),
    Entrant::Multicalc(256),
    Entrant::Exponential(256),
    Entrant::EphemerisF32,
    Entrant::StepperF32(16),
];

fn rivals(c: &mut Criterion) {
    let race = Race::new().expect("a race");
    let moments: Vec<u64> = (1..=PERIODS * u64::from(MOMENTS)).collect();
    let truth = race.truth(&moments);
    let mut group = c.benchmark_group("rivals, 160 orientations over 10 periods");
    group.throughput(Throughput::Elements(moments.len() as u64));
    for entrant in ENTRANTS {
        let (errors, _) = race.errors(entrant, &moments, &truth).expect("errors");
        let worst = errors.into_iter().fold(0.0, f64::max);
        let name = format!("{}, {}", entrant.name(), entrant.effort());
        println!("{name}: greatest error {worst:.1e} rad");
        // set-up is not in the time
        let timed = |runs: u64| -> Duration {
            (0..runs).map(|_| race.run(entrant, &moments).map_or(Duration::ZERO, |(_, time)| time)).sum()
        };
        group.bench_function(name, |b| b.iter_custom(timed));
    }
    group.finish();
}

criterion_group!(benches, rivals);
criterion_main!(benches);

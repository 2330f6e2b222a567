//! Error of the orientation against time, of the core and of other methods.

use super::chart::{Chart, Curve};
use crate::Failure;
use crate::measure::benchmark::{Benchmark, Method, SAMPLES};
use crate::output::progress::Progress;
use kuva::render::render::Scene;

pub(super) const METHODS: [Method; 7] = [
    Method::EphemerisF64,
    Method::StepperF64(64),
    Method::FullSolver(1e-15),
    Method::RungeKutta(64),
    Method::Exponential(64),
    Method::EphemerisF32,
    Method::StepperF32(64),
];

/// Numbers of periods after which the errors are computed, over one period each.
const PERIODS: [u64; 13] = [1, 2, 4, 8, 16, 32, 64, 128, 256, 400, 512, 800, 1000];

/// Numbers of periods, each with the greatest error in the next period, rad.
pub fn measured(benchmark: &Benchmark, method: Method) -> Result<Vec<[f64; 2]>, Failure> {
    let per_period = u64::from(SAMPLES);
    let samples: Vec<u64> = PERIODS.iter().flat_map(|n| (n - 1) * per_period + 1..=n * per_period).collect();
    let (errors, _) = benchmark.errors(method, &samples, &benchmark.truth(&samples))?;
    let worst = errors.chunks(SAMPLES as usize).map(|part| part.iter().copied().fold(0.0, f64::max));
    Ok(PERIODS
        .iter()
        .map(|&n| n as f64 * f64::from(SAMPLES) * benchmark.share())
        .zip(worst)
        .map(|(n, error)| [n, error])
        .collect())
}

pub(super) fn picture(progress: &mut Progress) -> Result<Scene, Failure> {
    let benchmark = Benchmark::new()?;
    let mut lines = Vec::new();
    for method in METHODS {
        let points = measured(&benchmark, method)?;
        lines.push(Curve { name: format!("{}, {}", method.name(), method.effort()), points, marked: true });
        progress.add(1);
    }
    let chart = Chart {
        title: "Error against time: s = A = p = 1, C = 0.6, e = 0.7, 0.9, 1.85",
        labels: ["nutation periods", "error of the orientation, rad"],
        powers: [true; 2],
    };
    Ok(chart.draw(&lines))
}

//! Error after 1000 periods against computing time for a period, for every method with several tolerances or step sizes.

use super::{Table, words};
use serde_json::Value;
use std::path::Path;
use toytop_host::Failure;
use toytop_host::measure::benchmark::{Benchmark, Method, SAMPLES};
use toytop_host::output::progress::Progress;
use toytop_host::pictures::figures::{Chart, Curve, Picture, measured_errors};

const PERIODS: u64 = 1000;

/// Result of one method with one tolerance or step size.
pub(super) struct Point {
    name: String,
    effort: String,
    /// Greatest error in the last period, rad.
    error: f64,
    /// Computing time for a period, s.
    time: f64,
}

fn methods() -> Vec<Method> {
    let mut all = vec![Method::EphemerisF64, Method::EphemerisF32];
    all.extend([2, 4, 8, 16, 32, 64, 128].map(Method::StepperF64));
    all.extend([2, 8, 32].map(Method::StepperF32));
    all.extend([1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15].map(Method::FullSolver));
    all.extend([4, 16, 64, 128].map(Method::RungeKutta));
    all.extend([4, 16, 64, 128].map(Method::Multicalc));
    all.extend([16, 64, 128].map(Method::Exponential));
    all
}

pub(super) fn measured(benchmark: &Benchmark, others: Vec<Point>) -> Result<Vec<Point>, Failure> {
    const RUNS: usize = 2;
    let per_period = u64::from(SAMPLES);
    let samples: Vec<u64> = (1..=PERIODS * per_period).collect();
    let last = samples.len() - SAMPLES as usize;
    let truth = benchmark.truth(&samples[last..]);
    let methods = methods();
    let mut progress = Progress::new(methods.len() as u64, "runs");
    let mut points = Vec::new();
    for method in methods {
        let mut time = f64::INFINITY;
        let mut error = 0.0;
        for _ in 0..RUNS {
            let (phis, taken) = benchmark.run(method, &samples)?;
            let errors = phis[last..].iter().zip(&truth).map(|(phi, truth)| phi.distance(truth));
            error = errors.fold(0.0, f64::max);
            time = taken.as_secs_f64().min(time);
        }
        let (name, effort) = (method.name().to_owned(), method.effort());
        points.push(Point { name, effort, error, time: time / PERIODS as f64 });
        progress.add(1);
    }
    points.extend(others);
    Ok(points)
}

/// Results of other programs, from JSON: `{"rows":[{"name":..,"effort":..,"error_rad":..,"us_per_period":..}]}`.
pub(super) fn others(text: &str, path: &Path) -> Result<Vec<Point>, Failure> {
    let refused = || {
        Failure::Input(format!(
            "--others: {}: must be {{\"rows\":[{{\"name\", \"effort\", \"error_rad\", \"us_per_period\"}}]}}",
            path.display()
        ))
    };
    let json: Value = serde_json::from_str(text).map_err(|_| refused())?;
    let point = |row: &Value| {
        let text = |key: &str| row[key].as_str().map(str::to_owned);
        let number = |key: &str| row[key].as_f64();
        Some(Point {
            name: text("name")?,
            effort: text("effort")?,
            error: number("error_rad")?,
            time: 1e-6 * number("us_per_period")?,
        })
    };
    json["rows"].as_array().and_then(|rows| rows.iter().map(point).collect()).ok_or_else(refused)
}

pub(super) fn table(points: &[Point]) -> Table {
    let row = |point: &Point| {
        vec![
            point.name.clone(),
            point.effort.clone(),
            format!("{:.1e}", point.error),
            format!("{:.2}", 1e6 * point.time),
        ]
    };
    let header = words(["", "effort", "error after 1000 periods, rad", "time a period, µs"]);
    Table { header, rows: points.iter().map(row).collect() }
}

pub(super) fn picture(points: &[Point]) -> Picture {
    let mut lines: Vec<Curve> = Vec::new();
    for point in points {
        let place = [1e6 * point.time, point.error];
        match lines.iter_mut().find(|line| line.name == point.name) {
            Some(line) => line.points.push(place),
            None => lines.push(Curve { name: point.name.clone(), points: vec![place], marked: true }),
        }
    }
    let chart = Chart {
        title: "16 orientations a period, for 1000 periods",
        labels: ["time a period, µs (this machine)", "error after 1000 periods, rad"],
        powers: [true; 2],
    };
    Picture::new("work_precision", "Work and precision", chart.draw(&lines))
}

/// Errors after 1, 8, 64 and 512 periods, which do not depend on the machine.
pub(super) fn against_time() -> Result<Table, Failure> {
    const SHOWN: [f64; 4] = [1.0, 8.0, 64.0, 512.0];
    let benchmark = Benchmark::new()?;
    let mut rows = Vec::new();
    for method in [
        Method::EphemerisF64,
        Method::EphemerisF32,
        Method::StepperF64(64),
        Method::StepperF32(64),
        Method::FullSolver(1e-15),
        Method::RungeKutta(64),
        Method::Exponential(64),
    ] {
        let errors = measured_errors(&benchmark, method)?;
        let shown = errors.iter().filter(|[periods, _]| SHOWN.contains(&periods.round()));
        let mut row = vec![format!("{}, {}", method.name(), method.effort())];
        row.extend(shown.map(|[_, error]| format!("{error:.0e}")));
        rows.push(row);
    }
    let header = words(["error after ... nutation periods, rad", "1", "8", "64", "512"]);
    Ok(Table { header, rows })
}

//! Work-precision picture: greatest error against work, a line for each method.

use super::chart::{Chart, Curve};
use kuva::render::render::Scene;

/// Picture of methods, each with its name and its runs \[work, error\], whose work is counted in this unit.
pub(crate) fn work_precision(scenario: &str, unit: &str, methods: Vec<(String, Vec<[f64; 2]>)>) -> Scene {
    let line = |(name, mut points): (String, Vec<[f64; 2]>)| {
        points.sort_by(|[a, _], [b, _]| a.total_cmp(b));
        Curve { name, points, marked: true }
    };
    let chart = Chart {
        title: &format!("Work and precision: {scenario}"),
        labels: [unit, "greatest error of the orientation, rad"],
        powers: [true; 2],
    };
    let lines: Vec<_> = methods.into_iter().map(line).collect();
    chart.draw(&lines)
}

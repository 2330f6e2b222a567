//! Work-precision picture: greatest error against work, a line for each method.

use crate::pictures::figures::{Chart, Curve, Picture};

/// Name of a method and its runs, \[work, error\].
pub(crate) type MethodRuns = (String, Vec<[f64; 2]>);

/// Picture of runs whose work is counted in this unit.
#[must_use]
pub(crate) fn work_precision(scenario: &str, unit: &str, methods: Vec<MethodRuns>) -> Picture {
    let line = |(name, mut points): MethodRuns| {
        points.sort_by(|[a, _], [b, _]| a.total_cmp(b));
        Curve { name, points, marked: true }
    };
    let chart = Chart {
        title: &format!("Work and precision: {scenario}"),
        labels: [unit, "greatest error of the orientation, rad"],
        powers: [true; 2],
    };
    let lines: Vec<_> = methods.into_iter().map(line).collect();
    Picture::new("work_precision", "Error against work", chart.draw(&lines))
}

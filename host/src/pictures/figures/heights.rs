//! Cosine of the tilt, u, against time.

use super::chart::{Chart, Curve};
use crate::Failure;
use crate::input::builtin;
use crate::motion::Scalar;
use crate::motion::ephemeris::smallest;
use kuva::render::render::Scene;

/// Time of the picture: two of the longest periods.
const TIME: f64 = 16.0;
const POINTS: u32 = 800;

pub(super) fn picture() -> Result<Scene, Failure> {
    let [_, third] =
        builtin::figures().map_err(|error| Failure::Input(format!("built-in motions: {error}")))?;
    let mut lines = Vec::new();
    for scenario in &third {
        let table = smallest(Scalar::F64, &scenario.motion)?;
        let point = |i: u32| {
            let t = TIME * f64::from(i) / f64::from(POINTS);
            [t, table.at(t).sample.u]
        };
        let name = format!("e₃ = {}", scenario.motion.branch_points().e3);
        lines.push(Curve { name, points: (0..=POINTS).map(point).collect(), marked: false });
    }
    let chart = Chart {
        title: "Nutation of figure 3: u swings between e₁ = 0.7 and e₂ = 0.9",
        labels: ["t in units of √(s/g)", "u = cos(tilt)"],
        powers: [false; 2],
    };
    Ok(chart.draw(&lines))
}

//! Chart of curves over logarithmic axes. (The logarithmic axes of kuva have no ticks below 1e-10.)

use super::drawing::{frame, label_above};
use crate::input::axis::ends;
use kuva::plot::LinePlot;
use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::render::layout::TickFormat;
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, render_multiple};
use std::sync::Arc;

/// Curve of a chart, with a mark at every point.
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Points \[x, y\]; those with a number that is not above 0 are left out.
    pub points: Vec<[f64; 2]>,
    /// Whether a line joins the points.
    pub is_line: bool,
}

/// Colours of the curves, which colour-blind readers can distinguish (the palette of Okabe and Ito).
const COLORS: [&str; 9] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999933", "#882255"];

/// Marks that distinguish the curves without their colours.
const MARKS: [MarkerShape; 5] = [
    MarkerShape::Circle,
    MarkerShape::Square,
    MarkerShape::Triangle,
    MarkerShape::Diamond,
    MarkerShape::TriangleDown,
];

/// Chart with a title, the labels of x and y, and the names of the curves in a legend. Its axes end at whole powers of ten.
pub fn draw(title: &str, labels: [&str; 2], curves: &[Curve]) -> Scene {
    let mut plots: Vec<Plot> = Vec::new();
    let mut all = Vec::new();
    let looks = COLORS.into_iter().cycle().zip(MARKS.into_iter().cycle());
    for (curve, (color, mark)) in curves.iter().zip(looks) {
        let shown = curve.points.iter().filter(|[x, y]| *x > 0.0 && *y > 0.0);
        let points: Vec<(f64, f64)> = shown.map(|[x, y]| (x.log10(), y.log10())).collect();
        all.extend(points.iter().copied());
        if curve.is_line {
            let line = LinePlot::new().with_data(points.clone());
            plots.push(line.with_color(color).with_stroke_width(1.8).into());
        }
        let dots = ScatterPlot::new().with_data(points).with_color(color).with_size(4.5);
        plots.push(dots.with_marker(mark).with_legend(&*curve.name).into());
    }
    let [x, y] = [ends(all.iter().map(|(x, _)| *x)), ends(all.iter().map(|(_, y)| *y))];
    let [x, y] = [whole(x), whole([y[0] - 0.1, y[1] + 0.1])];
    let power = || TickFormat::Custom(Arc::new(power_of_ten));
    let layout = frame(&plots, title, labels[0], [x, y])
        .with_width(920.0)
        .with_height(520.0)
        .with_force_margins_y(84.0, 62.0)
        .with_x_tick_step(1.0)
        .with_x_tick_format(power())
        .with_y_tick_step(if y[1] - y[0] > 9.0 { 2.0 } else { 1.0 })
        .with_y_tick_format(power());
    let mut scene = render_multiple(plots, layout);
    label_above(&mut scene, labels[1], [16.0, 66.0]);
    scene
}

/// Next whole numbers below and above; a number that is almost whole counts as whole.
fn whole([low, high]: [f64; 2]) -> [f64; 2] {
    const NEARLY: f64 = 2e-3;
    [(low + NEARLY).floor(), (high - NEARLY).ceil()]
}

/// Power of ten as text, such as 10⁻⁹.
fn power_of_ten(exponent: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    let digits: String = format!("{exponent:.0}").chars().map(raised).collect();
    format!("10{digits}")
}

//! Chart of curves over linear or logarithmic axes. (The logarithmic axes of kuva have no ticks below 1e-10.)

use super::{frame, label_above};
use crate::arguments::values::least_and_greatest;
use kuva::plot::LinePlot;
use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::render::layout::TickFormat;
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, render_multiple};
use std::sync::Arc;

/// Curve of a chart.
pub struct Curve {
    /// Name in the legend.
    name: String,
    /// Points \[x, y\].
    pub points: Vec<[f64; 2]>,
    /// Whether there is a line through the points.
    is_line: bool,
    /// Whether every point has a mark.
    is_marked: bool,
}

impl Curve {
    /// Line through points.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), points, is_line: true, is_marked: false }
    }

    /// Line through points with marks.
    pub fn marked(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { is_marked: true, ..Self::line(name, points) }
    }

    /// Marks without a line.
    pub fn dots(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { is_line: false, ..Self::marked(name, points) }
    }
}

/// Chart with the names of its curves in a legend.
pub struct Chart<'a> {
    /// Title above the axes.
    pub title: &'a str,
    /// Labels of x and y.
    pub labels: [&'a str; 2],
    /// Whether both axes are logarithmic; numbers that are not above 0 are then left out.
    pub logarithmic: bool,
}

/// Colours of the curves, which colour-blind readers can distinguish (the palette of Okabe and Ito).
pub const COLORS: [&str; 9] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999933", "#882255"];

/// Marks that distinguish the curves without their colours.
const MARKS: [MarkerShape; 5] = [
    MarkerShape::Circle,
    MarkerShape::Square,
    MarkerShape::Triangle,
    MarkerShape::Diamond,
    MarkerShape::TriangleDown,
];

impl Chart<'_> {
    /// Draws curves over linear axes.
    pub fn draw_linear(title: &str, labels: [&str; 2], curves: &[Curve]) -> Scene {
        Chart { title, labels, logarithmic: false }.draw(curves)
    }

    /// Draws the curves. A logarithmic axis ends at whole powers of ten; another one of y has a margin.
    pub fn draw(&self, curves: &[Curve]) -> Scene {
        let mut plots: Vec<Plot> = Vec::new();
        let mut all = Vec::new();
        let looks = COLORS.into_iter().cycle().zip(MARKS.into_iter().cycle());
        for (curve, (color, mark)) in curves.iter().zip(looks) {
            let coordinates = |[x, y]: &[f64; 2]| match self.logarithmic {
                true => (x.log10(), y.log10()),
                false => (*x, *y),
            };
            let points = curve.points.iter().map(coordinates);
            let points: Vec<_> = points.filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
            all.extend(points.iter().copied());
            if curve.is_line {
                let line = LinePlot::new().with_data(points.clone()).with_color(color).with_stroke_width(1.8);
                plots.push(if curve.is_marked { line } else { line.with_legend(&*curve.name) }.into());
            }
            if curve.is_marked {
                let dots = ScatterPlot::new().with_data(points).with_color(color).with_size(4.5);
                plots.push(dots.with_marker(mark).with_legend(&*curve.name).into());
            }
        }
        let [mut x, mut y] = [
            least_and_greatest(all.iter().map(|(x, _)| *x)),
            least_and_greatest(all.iter().map(|(_, y)| *y)),
        ];
        let height = y[1] - y[0];
        let margin = match self.logarithmic {
            true => 0.1,
            false if height > 1e-9 * y[1].abs() => 0.06 * height,
            // a curve that is constant to rounding is drawn in the middle
            false => 1.0,
        };
        y = [y[0] - margin, y[1] + margin];
        if self.logarithmic {
            (x, y) = (whole(x), whole(y));
        }
        let mut layout = frame(&plots, self.title, self.labels[0], [x, y])
            .with_width(920.0)
            .with_height(520.0)
            .with_force_margins_y(84.0, 62.0);
        if self.logarithmic {
            let power = TickFormat::Custom(Arc::new(power_of_ten));
            let step = if y[1] - y[0] > 9.0 { 2.0 } else { 1.0 };
            layout = layout.with_x_tick_step(1.0).with_x_tick_format(power.clone());
            layout = layout.with_y_tick_step(step).with_y_tick_format(power);
        }
        let mut scene = render_multiple(plots, layout);
        label_above(&mut scene, self.labels[1], [16.0, 66.0]);
        scene
    }
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

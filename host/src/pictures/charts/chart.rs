//! Chart of curves over linear or logarithmic axes. (The logarithmic axes of kuva have no ticks below 1e-10.)

use crate::input::axis::ends;
use crate::pictures::drawing::text;
use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::plot::{LegendPosition, LinePlot};
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, TextAnchor, render_multiple};
use std::sync::Arc;

/// Curve of a chart.
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Points \[x, y\].
    pub points: Vec<[f64; 2]>,
    /// Width of the line through the points; 0 for none.
    pub width: f64,
    /// Whether every point has a mark.
    pub marked: bool,
}

impl Curve {
    /// Line through points.
    pub fn line(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), points, width: 1.8, marked: false }
    }

    /// Line through points with marks.
    pub fn marked(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { marked: true, ..Self::line(name, points) }
    }
}

/// Chart with the names of its curves in a legend.
pub struct Chart<'a> {
    /// Title above the axes.
    pub title: &'a str,
    /// Labels of x and y.
    pub labels: [&'a str; 2],
    /// Whether the axes of x and of y are logarithmic; numbers that are not above 0 are then left out.
    pub powers: [bool; 2],
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

/// Size of the chart, and margins above and below its frame, pixels.
const SIZE: [f64; 2] = [920.0, 520.0];
const ABOVE: f64 = 84.0;
const BELOW: f64 = 62.0;

impl Chart<'_> {
    /// Chart of these curves.
    pub fn draw(&self, curves: &[Curve]) -> Scene {
        let mut plots: Vec<Plot> = Vec::new();
        let mut all = Vec::new();
        let mut marks = MARKS.into_iter().cycle();
        for (curve, color) in curves.iter().zip(COLORS.into_iter().cycle()) {
            let place = |&[x, y]: &[f64; 2]| Some((place(x, self.powers[0])?, place(y, self.powers[1])?));
            let points: Vec<(f64, f64)> = curve.points.iter().filter_map(place).collect();
            all.extend(points.iter().copied());
            let line = LinePlot::new().with_data(points.clone()).with_color(color);
            let line = line.with_stroke_width(curve.width);
            match marks.next().filter(|_| curve.marked) {
                Some(mark) => {
                    let dots = ScatterPlot::new().with_data(points).with_color(color).with_size(4.5);
                    plots.extend([line.into(), dots.with_marker(mark).with_legend(&*curve.name).into()]);
                }
                None => plots.push(line.with_legend(&*curve.name).into()),
            }
        }
        let layout = self.layout(&plots, &all);
        let mut scene = render_multiple(plots, layout);
        // horizontal text above the axis, because rotated text is not sharp in the raster picture
        text(&mut scene, self.labels[1], [16.0, 66.0], 14, TextAnchor::Start, "black");
        scene
    }

    /// Axes with whole powers of ten at their ends, or with the range of the points and a margin above and below.
    fn layout(&self, plots: &[Plot], points: &[(f64, f64)]) -> Layout {
        let [x, y] = [ends(points.iter().map(|(x, _)| *x)), ends(points.iter().map(|(_, y)| *y))];
        let x = if self.powers[0] { whole(x) } else { x };
        // a curve that is constant to rounding is drawn in the middle
        let margin = if y[1] - y[0] > 1e-9 * y[1].abs() { 0.06 * (y[1] - y[0]) } else { 1.0 };
        let margin = if self.powers[1] { 0.1 } else { margin };
        let y = [y[0] - margin, y[1] + margin];
        let y = if self.powers[1] { whole(y) } else { y };
        let mut layout = Layout::auto_from_plots(plots)
            .with_width(SIZE[0])
            .with_height(SIZE[1])
            .with_title(self.title)
            .with_title_size(18)
            .with_x_label(self.labels[0])
            .with_force_margins_y(ABOVE, BELOW)
            .with_box_axes()
            .with_legend_position(LegendPosition::OutsideRightTop)
            .with_legend_box(false)
            .with_x_axis_min(x[0])
            .with_x_axis_max(x[1])
            .with_y_axis_min(y[0])
            .with_y_axis_max(y[1]);
        let power = || TickFormat::Custom(Arc::new(power_of_ten));
        if self.powers[0] {
            layout = layout.with_x_tick_step(1.0).with_x_tick_format(power());
        }
        if self.powers[1] {
            let step = if y[1] - y[0] > 9.0 { 2.0 } else { 1.0 };
            layout = layout.with_y_tick_step(step).with_y_tick_format(power());
        }
        layout
    }
}

fn place(x: f64, power: bool) -> Option<f64> {
    if power { (x > 0.0).then(|| x.log10()) } else { Some(x) }
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

//! Chart of curves over linear or logarithmic axes. (The logarithmic axes of kuva have no ticks below 1e-10.)

use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::plot::{LegendPosition, LinePlot};
use kuva::render::color::Color;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use std::sync::Arc;

/// Curve of a chart.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Points \[x, y\].
    pub points: Vec<[f64; 2]>,
    /// Whether every point has a mark.
    pub marked: bool,
}

/// Chart with the names of its curves at their right ends, or in a legend if several curves end elsewhere.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Title above the axes.
    pub title: &'a str,
    /// Labels of x and y.
    pub labels: [&'a str; 2],
    /// Whether the axes of x and of y are logarithmic; numbers that are not above 0 are then left out.
    pub powers: [bool; 2],
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

/// Size of the chart, and margins of its frame, pixels.
const SIZE: [f64; 2] = [920.0, 520.0];
const LEFT: f64 = 78.0;
const ABOVE: f64 = 84.0;
const BELOW: f64 = 62.0;

impl Chart<'_> {
    /// Chart of these curves.
    #[must_use]
    pub fn draw(&self, lines: &[Curve]) -> Scene {
        let places = |line: &Curve| -> Vec<(f64, f64)> {
            let place = |&[x, y]: &[f64; 2]| Some((place(x, self.powers[0])?, place(y, self.powers[1])?));
            line.points.iter().filter_map(place).collect()
        };
        let curves: Vec<Vec<(f64, f64)>> = lines.iter().map(places).collect();
        let [x_range, y_range] = self.ranges(&curves.concat());
        let ends = ends_of(&curves, x_range);
        let mut plots: Vec<Plot> = Vec::new();
        for (i, (line, points)) in lines.iter().zip(&curves).enumerate() {
            let color = COLORS[i % COLORS.len()];
            let name = if ends.is_some() { "" } else { &*line.name };
            let mut drawn =
                LinePlot::new().with_data(points.clone()).with_color(color).with_stroke_width(1.8);
            if line.marked {
                let mut marks = ScatterPlot::new().with_data(points.clone()).with_color(color).with_size(4.5);
                marks = marks.with_marker(MARKS[i % MARKS.len()]);
                if !name.is_empty() {
                    marks = marks.with_legend(name);
                }
                plots.extend([drawn.into(), marks.into()]);
            } else {
                if !name.is_empty() {
                    drawn = drawn.with_legend(name);
                }
                plots.push(drawn.into());
            }
        }
        let mut layout = self.layout(&plots, [x_range, y_range]);
        let right = 24.0
            + WIDTH_OF_LETTER * lines.iter().map(|line| line.name.chars().count()).max().unwrap_or(0) as f64;
        if ends.is_some() {
            layout = layout.with_force_margins(LEFT, right);
        }
        let mut scene = render_multiple(plots, layout);
        // horizontal text above the axis, because rotated text is not sharp in the raster picture
        scene.add(text(self.labels[1], [16.0, 66.0], 14, "black"));
        if let Some(ends) = ends {
            let frame = [SIZE[0] - LEFT - right, SIZE[1] - ABOVE - BELOW];
            let pixels = |(x, y): (f64, f64)| {
                let share = |at: f64, [low, high]: [f64; 2]| (at - low) / (high - low);
                [LEFT + frame[0] * share(x, x_range), ABOVE + frame[1] * (1.0 - share(y, y_range))]
            };
            name_ends(&mut scene, lines, &ends.into_iter().map(pixels).collect::<Vec<_>>(), SIZE[0] - right);
        }
        scene
    }

    /// Ends of both axes: whole powers of ten, or the range of the points with a margin above and below.
    fn ranges(&self, points: &[(f64, f64)]) -> [[f64; 2]; 2] {
        let [x, y] = [ends(points.iter().map(|(x, _)| *x)), ends(points.iter().map(|(_, y)| *y))];
        // a curve that is constant to rounding is drawn in the middle
        let margin = if y[1] - y[0] > 1e-9 * y[1].abs() { 0.06 * (y[1] - y[0]) } else { 1.0 };
        [
            if self.powers[0] { whole(x) } else { x },
            // with a margin for the marks
            if self.powers[1] { whole([y[0] - 0.1, y[1] + 0.1]) } else { [y[0] - margin, y[1] + margin] },
        ]
    }

    fn layout(&self, plots: &[Plot], [x, y]: [[f64; 2]; 2]) -> Layout {
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

/// Last points of the curves, if at most one of them does not end at the right edge, where the names are written.
fn ends_of(curves: &[Vec<(f64, f64)>], [low, high]: [f64; 2]) -> Option<Vec<(f64, f64)>> {
    let ends: Option<Vec<_>> = curves.iter().map(|points| points.last().copied()).collect();
    let inside = |ends: &[(f64, f64)]| ends.iter().filter(|(x, _)| *x < high - 0.02 * (high - low)).count();
    ends.filter(|ends| inside(ends) <= 1)
}

/// Upper bound on the mean width of a letter, pixels.
const WIDTH_OF_LETTER: f64 = 7.4;
/// Least vertical distance of two names, pixels.
const LINE: f64 = 16.0;

/// Adds the names of the curves beside their ends, given in pixels: right of the frame in the order of the ends,
/// without overlap. A curve that ends inside the frame has its name there.
fn name_ends(scene: &mut Scene, lines: &[Curve], ends: &[[f64; 2]], edge: f64) {
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by(|&a, &b| ends[a][1].total_cmp(&ends[b][1]));
    let (outside, inside): (Vec<usize>, Vec<usize>) =
        order.into_iter().partition(|&i| ends[i][0] > edge - 0.02 * SIZE[0]);
    for i in inside {
        scene.add(text(&lines[i].name, [ends[i][0] + 9.0, ends[i][1] + 17.0], 13, "#222222"));
    }
    let mut heights: Vec<f64> = outside.iter().map(|&i| ends[i][1]).collect();
    spread(&mut heights);
    for (&i, y) in outside.iter().zip(heights) {
        let [end_x, end_y] = ends[i];
        scene.add(Primitive::Line {
            x1: end_x,
            y1: end_y,
            x2: edge + 13.0,
            y2: y,
            stroke: Color::from(COLORS[i % COLORS.len()]),
            stroke_width: 1.0,
            stroke_dasharray: None,
        });
        scene.add(text(&lines[i].name, [edge + 17.0, y + 4.5], 13, "#222222"));
    }
}

/// Increases the distances of ordered vertical positions to at least [`LINE`]; the middle of each group of moved
/// positions is kept.
fn spread(heights: &mut [f64]) {
    for _ in 0..100 {
        for i in 1..heights.len() {
            let overlap = LINE - (heights[i] - heights[i - 1]);
            if overlap > 0.0 {
                heights[i - 1] -= 0.5 * overlap;
                heights[i] += 0.5 * overlap;
            }
        }
    }
}

fn text(content: &str, [x, y]: [f64; 2], size: u32, color: &str) -> Primitive {
    let (content, color) = (content.to_owned(), Some(Color::from(color)));
    Primitive::Text { x, y, content, size, anchor: TextAnchor::Start, rotate: None, bold: false, color }
}

fn place(x: f64, power: bool) -> Option<f64> {
    if power { (x > 0.0).then(|| x.log10()) } else { Some(x) }
}

fn ends(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// Next whole numbers below and above; a number that is almost whole counts as whole.
fn whole([low, high]: [f64; 2]) -> [f64; 2] {
    const NEARLY: f64 = 2e-3;
    [(low + NEARLY).floor(), (high - NEARLY).ceil()]
}

/// Power of ten as text, such as 10⁻⁹.
pub fn power_of_ten(exponent: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised =
        |c: char| c.to_digit(10).and_then(|digit| DIGITS.get(digit as usize)).copied().unwrap_or('⁻');
    let exponent = exponent.round() as i64;
    std::iter::once("10".to_owned()).chain([exponent.to_string().chars().map(raised).collect()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_order_and_a_lines_distance() {
        let mut heights = [100.0, 101.0, 101.0, 140.0, 300.0];
        spread(&mut heights);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > LINE - 0.01), "{heights:?}");
        assert_eq!(heights[4], 300.0);
        assert!((heights[..4].iter().sum::<f64>() - 442.0).abs() < 1e-9, "{heights:?}");
    }
}

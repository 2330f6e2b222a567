//! Chart of curves over linear or logarithmic axes. (The logarithmic axes of kuva have no ticks below 1e-10.)

use super::ends::{End, name_ends, width_outside};
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
pub(crate) const COLORS: [&str; 9] =
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
pub(super) const LEFT: f64 = 78.0;
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
        let points = curves.concat();
        let short = self.powers[0] && is_short(ends(points.iter().map(|(x, _)| *x)));
        let [mut x_range, y_range] = self.ranges(&points);
        if !self.powers[0] {
            let marked = lines.iter().zip(&curves).filter(|(line, _)| line.marked);
            x_range = with_room_for_marks(x_range, marked.flat_map(|(_, points)| points).map(|(x, _)| *x));
        }
        let ends = ends_of(&curves, x_range);
        let mut plots: Vec<Plot> = Vec::new();
        for (i, (line, points)) in lines.iter().zip(&curves).enumerate() {
            let color = COLORS[i % COLORS.len()];
            let name = if ends.is_some() { "" } else { &*line.name };
            // an axis with a short range has the ticks of kuva's own logarithmic axis
            let points: Vec<_> =
                points.iter().map(|&(x, y)| (if short { 10_f64.powf(x) } else { x }, y)).collect();
            let mut drawn =
                LinePlot::new().with_data(points.clone()).with_color(color).with_stroke_width(1.8);
            if line.marked {
                let mut marks = ScatterPlot::new().with_data(points).with_color(color).with_size(4.5);
                let marked_before = lines[..i].iter().filter(|line| line.marked).count();
                marks = marks.with_marker(MARKS[marked_before % MARKS.len()]);
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
        let mut layout = self.layout(&plots, [x_range, y_range], short);
        let right = 24.0 + ends.as_ref().map_or(0.0, |ends| width_outside(lines, ends));
        if ends.is_some() {
            layout = layout.with_force_margins(LEFT, right);
        }
        let mut scene = render_multiple(plots, layout);
        // horizontal text above the axis, because rotated text is not sharp in the raster picture
        scene.add(text(self.labels[1], [16.0, 66.0], 14, "black"));
        if let Some(ends) = ends {
            let frame = [SIZE[0] - LEFT - right, SIZE[1] - ABOVE - BELOW];
            let share = |at: f64, [low, high]: [f64; 2]| (at - low) / (high - low);
            let pixels = |[x, y]: [f64; 2]| {
                [LEFT + frame[0] * share(x, x_range), ABOVE + frame[1] * (1.0 - share(y, y_range))]
            };
            let ends: Vec<_> = ends.into_iter().map(|end| End { place: pixels(end.place), ..end }).collect();
            let points: Vec<Vec<_>> =
                curves.iter().map(|points| points.iter().map(|&(x, y)| pixels([x, y])).collect()).collect();
            name_ends(&mut scene, lines, &ends, &points, SIZE[0] - right);
        }
        scene
    }

    /// Ends of both axes: whole powers of ten, or the range of the points with a margin above and below.
    fn ranges(&self, points: &[(f64, f64)]) -> [[f64; 2]; 2] {
        let [x, y] = [ends(points.iter().map(|(x, _)| *x)), ends(points.iter().map(|(_, y)| *y))];
        // a curve that is constant to rounding is drawn in the middle
        let margin = if y[1] - y[0] > 1e-9 * y[1].abs() { 0.06 * (y[1] - y[0]) } else { 1.0 };
        [
            if self.powers[0] { short_or_whole(x) } else { x },
            // with a margin for the marks
            if self.powers[1] { whole([y[0] - 0.1, y[1] + 0.1]) } else { [y[0] - margin, y[1] + margin] },
        ]
    }

    fn layout(&self, plots: &[Plot], [x, y]: [[f64; 2]; 2], short: bool) -> Layout {
        let x = if short { x.map(|x| 10_f64.powf(x)) } else { x };
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
        if short {
            layout = layout.with_log_x().with_x_tick_format(TickFormat::Custom(Arc::new(brief)));
        } else if self.powers[0] {
            layout = layout.with_x_tick_step(1.0).with_x_tick_format(power());
        }
        if self.powers[1] {
            let step = if y[1] - y[0] > 9.0 { 2.0 } else { 1.0 };
            layout = layout.with_y_tick_step(step).with_y_tick_format(power());
        }
        layout
    }
}

/// Range of an axis with a margin at each end at which there is a mark, half of which would otherwise be outside the frame.
fn with_room_for_marks([low, high]: [f64; 2], marks: impl Iterator<Item = f64>) -> [f64; 2] {
    let room = 0.02 * (high - low);
    marks.fold([low, high], |[from, until], x| [from.min(x - room), until.max(x + room)])
}

/// Last points of the curves, each with whether it is inside the frame; `None` if more than one is, because names are written at
/// the right edge.
fn ends_of(curves: &[Vec<(f64, f64)>], [low, high]: [f64; 2]) -> Option<Vec<End>> {
    let end = |points: &Vec<(f64, f64)>| {
        let &(x, y) = points.last()?;
        Some(End { place: [x, y], inside: x < high - 0.02 * (high - low) })
    };
    let ends: Option<Vec<_>> = curves.iter().map(end).collect();
    ends.filter(|ends| ends.iter().filter(|end| end.inside).count() <= 1)
}

pub(super) fn text(content: &str, [x, y]: [f64; 2], size: u32, color: &str) -> Primitive {
    let (content, color) = (content.to_owned(), Some(Color::from(color)));
    Primitive::Text { x, y, content, size, anchor: TextAnchor::Start, rotate: None, bold: false, color }
}

fn place(x: f64, power: bool) -> Option<f64> {
    if power { (x > 0.0).then(|| x.log10()) } else { Some(x) }
}

fn ends(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// Number of a tick with one significant digit.
fn brief(x: f64) -> String {
    crate::output::short(x, 1)
}

/// Range in powers of ten from which an axis has whole powers of ten at its ends and its ticks.
const SHORT: f64 = 2.0;

/// Whether a range in powers of ten is short; below 1e-9 a short axis would have no ticks.
fn is_short([low, high]: [f64; 2]) -> bool {
    high - low < SHORT && low > -9.0
}

/// Ends of a logarithmic axis in powers of ten: the next of 1, 2 and 5 times a power of ten where its range is short, otherwise whole
/// numbers.
fn short_or_whole(ends: [f64; 2]) -> [f64; 2] {
    if !is_short(ends) {
        return whole(ends);
    }
    const STEPS: [f64; 4] = [1.0, 2.0, 5.0, 10.0];
    let next = |x: f64, above: bool| {
        let steps = STEPS.map(|step| x.floor() + step.log10());
        let beyond = |step: &f64| if above { *step >= x } else { *step <= x };
        let found = if above { steps.into_iter().find(beyond) } else { steps.into_iter().rev().find(beyond) };
        found.unwrap_or(x)
    };
    [next(ends[0] - 0.02, false), next(ends[1] + 0.02, true)]
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
    fn a_mark_at_an_end_of_an_axis_has_room() {
        assert_eq!(with_room_for_marks([0.0, 100.0], [0.0, 50.0].into_iter()), [-2.0, 100.0]);
        assert_eq!(with_room_for_marks([0.0, 100.0], [99.0].into_iter()), [0.0, 101.0]);
        assert_eq!(with_room_for_marks([0.0, 100.0], [3.0, 97.0].into_iter()), [0.0, 100.0]);
    }

    #[test]
    fn a_short_axis_ends_near_its_points() {
        let ends = |low: f64, high: f64| {
            short_or_whole([low.log10(), high.log10()]).map(|x| (1e4 * 10_f64.powf(x)).round() / 1e4)
        };
        assert_eq!(ends(9.6, 78.0), [5.0, 100.0]);
        assert_eq!(ends(11.0, 19.0), [10.0, 20.0]);
        assert_eq!(ends(0.21, 0.49), [0.2, 1.0]);
        assert_eq!(ends(9.6, 960.1), [1.0, 1000.0]);
        assert_eq!(short_or_whole([-10.5, -10.2]), [-11.0, -10.0]);
    }
}

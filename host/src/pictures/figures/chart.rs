//! Lines over axes that count powers of ten, if wanted. (kuva's own logarithmic axes have no ticks below 1e-10.)

use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::plot::{LegendPosition, LinePlot};
use kuva::render::color::Color;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use std::sync::Arc;

/// One line of a chart.
#[derive(Clone, Debug)]
pub struct Curve {
    /// For the legend.
    pub name: String,
    /// Points \[x, y\].
    pub points: Vec<[f64; 2]>,
    /// With a mark on every point.
    pub marked: bool,
}

/// A chart with a legend on its right.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Title above the axes.
    pub title: &'a str,
    /// Labels of x and y.
    pub labels: [&'a str; 2],
    /// Whether x, and y, are powers of ten; numbers that are not above 0 are left out.
    pub powers: [bool; 2],
}

/// Apart from each other also to the colour-blind (Okabe and Ito's).
const COLORS: [&str; 9] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999933", "#882255"];

/// Marks that tell the curves apart without their colours.
const MARKS: [MarkerShape; 5] = [
    MarkerShape::Circle,
    MarkerShape::Square,
    MarkerShape::Triangle,
    MarkerShape::Diamond,
    MarkerShape::TriangleDown,
];

impl Chart<'_> {
    /// Chart of these curves.
    #[must_use]
    pub fn draw(&self, lines: &[Curve]) -> Scene {
        let places = |line: &Curve| -> Vec<(f64, f64)> {
            line.points
                .iter()
                .filter_map(|&[x, y]| Some((place(x, self.powers[0])?, place(y, self.powers[1])?)))
                .collect()
        };
        let mut plots: Vec<Plot> = Vec::new();
        for (i, line) in lines.iter().enumerate() {
            let color = COLORS[i % COLORS.len()];
            let points = places(line);
            let drawn = LinePlot::new().with_data(points.clone()).with_color(color).with_stroke_width(1.8);
            if line.marked {
                let marks = ScatterPlot::new().with_data(points).with_color(color).with_size(4.5);
                let marks = marks.with_marker(MARKS[i % MARKS.len()]).with_legend(&*line.name);
                plots.extend([drawn.into(), marks.into()]);
            } else {
                plots.push(drawn.with_legend(&*line.name).into());
            }
        }
        let [x_label, y_label] = self.labels;
        let mut layout = Layout::auto_from_plots(&plots)
            .with_width(920.0)
            .with_height(520.0)
            .with_title(self.title)
            .with_title_size(18)
            .with_x_label(x_label)
            .with_force_margins_y(84.0, 62.0)
            .with_box_axes()
            .with_legend_position(LegendPosition::OutsideRightTop)
            .with_legend_box(false);
        let all: Vec<(f64, f64)> = lines.iter().flat_map(places).collect();
        let power = || TickFormat::Custom(Arc::new(power_of_ten));
        let [x_ends, y_ends] = [ends(all.iter().map(|(x, _)| *x)), ends(all.iter().map(|(_, y)| *y))];
        if self.powers[0] {
            layout = layout.with_x_tick_step(1.0).with_x_tick_format(power());
        }
        let [low, high] = if self.powers[0] { whole(x_ends) } else { x_ends };
        layout = layout.with_x_axis_min(low).with_x_axis_max(high);
        if self.powers[1] {
            // with room for the marks
            let [low, high] = whole([y_ends[0] - 0.1, y_ends[1] + 0.1]);
            let step = if high - low > 9.0 { 2.0 } else { 1.0 };
            let layout_of_powers = layout.with_y_axis_min(low).with_y_axis_max(high).with_y_tick_step(step);
            layout = layout_of_powers.with_y_tick_format(power());
        }
        let mut scene = render_multiple(plots, layout);
        // upright, above its axis: turned text is smeared in the raster
        let (anchor, color) = (TextAnchor::Start, Some(Color::from("black")));
        let content = y_label.to_owned();
        scene.add(Primitive::Text {
            x: 16.0,
            y: 66.0,
            content,
            size: 14,
            anchor,
            rotate: None,
            bold: false,
            color,
        });
        scene
    }
}

fn place(x: f64, power: bool) -> Option<f64> {
    if power { (x > 0.0).then(|| x.log10()) } else { Some(x) }
}

fn ends(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// The whole numbers around them; what is all but whole counts as such.
fn whole([low, high]: [f64; 2]) -> [f64; 2] {
    const NEARLY: f64 = 2e-3;
    [(low + NEARLY).floor(), (high - NEARLY).ceil()]
}

/// 10⁻⁹.
pub fn power_of_ten(exponent: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised =
        |c: char| c.to_digit(10).and_then(|digit| DIGITS.get(digit as usize)).copied().unwrap_or('⁻');
    let exponent = exponent.round() as i64;
    std::iter::once("10".to_owned()).chain([exponent.to_string().chars().map(raised).collect()]).collect()
}

//! Picture of error against cost: a point for every scalar and chip. The error does not depend on the chip, so the points of a scalar lie
//! on a horizontal line, which has the name of the scalar.

use crate::Failure;
use crate::budget::{Costs, PLOTTED};
use crate::measure::accuracy::Accuracy;
use crate::motion::Scalar;
use crate::pictures::figures::{Picture, power_of_ten};
use kuva::plot::LinePlot;
use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::render::color::Color;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, TextAnchor, render_multiple};
use std::sync::Arc;

/// Colour and shape for each chip; the colours can be distinguished by colour-blind readers.
const MARKS: [(&str, MarkerShape); PLOTTED.len()] = [
    ("#d55e00", MarkerShape::Circle),
    ("#0072b2", MarkerShape::Square),
    ("#009e73", MarkerShape::Triangle),
    ("#cc79a7", MarkerShape::Diamond),
    ("#000000", MarkerShape::TriangleDown),
];

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 560.0;
/// Margins on the left, on the right, above and below, in pixels.
const MARGINS: [f64; 4] = [70.0, 230.0, 96.0, 62.0];
/// Vertical position of the legend, in pixels: between the points of q31 and those of f64.
const LEGEND: f64 = 300.0;
const LEVEL: &str = "#c8c8c8";
const REMARK: &str = "#555555";

/// Picture of all scalars.
///
/// # Errors
/// The failures of [`Costs::known`].
pub fn picture(all: &[Accuracy]) -> Result<Picture, Failure> {
    let costs = Costs::known()?;
    // positions in powers of ten
    let point = |accuracy: &Accuracy, chip| {
        let cost = costs.next_tick(accuracy.scalar, chip)?;
        Some(((cost as f64).log10(), accuracy.all().angle.log10()))
    };
    let points: Vec<Vec<(f64, f64)>> = PLOTTED
        .iter()
        .map(|chip| all.iter().filter_map(|accuracy| point(accuracy, chip)).collect())
        .collect();
    let ends = |numbers: Vec<f64>| {
        numbers
            .into_iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let [left, right] = ends(points.iter().flatten().map(|(cost, _)| *cost).collect());
    let [low, high] = ends(all.iter().map(|accuracy| accuracy.all().angle.log10()).collect());
    // whole powers of ten, with space for the marks
    let [left, right, low, high] = [left.floor(), right.ceil(), (low - 0.2).floor(), (high + 0.2).ceil()];

    let mut plots: Vec<Plot> = Vec::new();
    for accuracy in all {
        let level = accuracy.all().angle.log10();
        plots.push(
            LinePlot::new()
                .with_data([(left, level), (right, level)])
                .with_color(LEVEL)
                .with_stroke_width(1.0)
                .into(),
        );
    }
    for ((chip, (color, shape)), points) in PLOTTED.iter().zip(MARKS).zip(&points) {
        let unit = if chip.cycles { "cycles" } else { "instructions" };
        let marks =
            ScatterPlot::new().with_data(points.clone()).with_color(color).with_marker(shape).with_size(5.5);
        plots.push(marks.with_legend(format!("{}, {unit}", chip.chip.core)).into());
    }
    let power = || TickFormat::Custom(Arc::new(power_of_ten));
    let [margin_left, margin_right, above, below] = MARGINS;
    let layout = Layout::auto_from_plots(&plots)
        .with_width(WIDTH)
        .with_height(HEIGHT)
        .with_force_margins(margin_left, margin_right)
        .with_force_margins_y(above, below)
        .with_title("What an orientation costs, and how exact it is: five scalars on five chips")
        .with_title_size(18)
        .with_x_label("cost of the next tick: modelled cycles, or instructions executed")
        .with_x_axis_min(left)
        .with_x_axis_max(right)
        .with_x_tick_step(1.0)
        .with_x_tick_format(power())
        .with_y_axis_min(low)
        .with_y_axis_max(high)
        .with_y_tick_step(2.0)
        .with_y_tick_format(power())
        .with_show_grid(false)
        .with_box_axes()
        .with_legend_at(margin_left + 0.36 * (WIDTH - margin_left - margin_right), LEGEND)
        .with_legend_box(false);
    let mut scene = render_multiple(plots, layout);
    let mut text = |content: String, [x, y]: [f64; 2], size: u32, anchor, color: &str| {
        let (rotate, bold, color) = (None, false, Some(Color::from(color)));
        scene.add(Primitive::Text { x, y, content, size, anchor, rotate, bold, color });
    };
    // horizontal text above the axis, because rotated text is not sharp in the raster picture
    let head = "greatest error of the orientation over ticks 1 to 2⁴⁰, rad";
    text(head.to_owned(), [14.0, above - 30.0], 14, TextAnchor::Start, "black");
    let better = "down: more exact; left: faster";
    text(better.to_owned(), [14.0, above - 12.0], 12, TextAnchor::Start, REMARK);
    for accuracy in all {
        let share = (accuracy.all().angle.log10() - low) / (high - low);
        let y = above + (1.0 - share) * (HEIGHT - above - below);
        let place = [WIDTH - margin_right + 8.0, y + 4.0];
        let label = format!("{}: {:.0e} rad", label(accuracy.scalar), accuracy.all().angle);
        text(label, place, 13, TextAnchor::Start, "black");
    }
    Ok(Picture::new("accuracy", "Accuracy against cost", scene))
}

fn label(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::F64 => "f64",
        Scalar::F32 => "f32",
        Scalar::Q31 => "q31, 32-bit integers",
        Scalar::Q15 => "q15, 16-bit integers",
        Scalar::Micromath => "f32, micromath's sines",
    }
}

//! Picture of a curve, for a white page.

use super::curve::Curve;
use super::drawing::{BOUND, CAPTION, CURVE, START, text};
use super::span::Span;
use crate::input::scenario::{Scenario, Units};
use kuva::plot::scatter::ScatterPlot;
use kuva::plot::{LegendPosition, LinePlot, LineStyle};
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, TextAnchor, render_multiple};
use std::f64::consts::PI;
use toytop::Support;

/// Sizes of the layout in pixels: side of the square for the curve, and margins around it.
const SIDE: f64 = 560.0;
const LEFT: f64 = 72.0;
const RIGHT: f64 = 20.0;
const ABOVE: f64 = 92.0;
const BELOW: f64 = 58.0;

/// Draws the curve over a span of time; the lines of the caption are below the title.
pub fn draw(scenario: &Scenario, span: &Span, caption: &[String]) -> Scene {
    let curve = &Curve::over(&scenario.motion, span);
    let s = scenario.motion.top().tip_scale();
    // in mm, or in units of s where the scenario names no units
    let (name, unit, scale) = match (scenario.motion.top().support(), scenario.units) {
        (Support::Sliding, Units::Si) => ("tip", ", mm", 1e-3),
        (Support::Sliding, Units::None) => ("tip", " in units of s", s),
        (Support::Fixed | Support::Free, _) => ("axis", " of the axis (length 1)", 1.0),
    };
    let extent = extent(curve, scale);
    let plots = lines(curve, scale, extent, name);
    let layout = Layout::auto_from_plots(&plots)
        .with_x_axis_min(-extent)
        .with_x_axis_max(extent)
        .with_y_axis_min(-extent)
        .with_y_axis_max(extent)
        .with_equal_aspect()
        .with_box_axes()
        .with_show_grid(false)
        .with_width(LEFT + SIDE + RIGHT)
        .with_height(ABOVE + SIDE + BELOW)
        .with_force_margins(LEFT, RIGHT)
        .with_force_margins_y(ABOVE, BELOW)
        .with_title(&*scenario.name)
        .with_x_label(format!("x{unit}"))
        .with_legend_position(LegendPosition::InsideTopRight)
        .with_legend_box(false);
    let mut scene = render_multiple(plots, layout);
    let middle = LEFT + 0.5 * SIDE;
    let mut caption_at = |content: &str, [x, y]: [f64; 2], size: u32| {
        text(&mut scene, content, [x, y], size, TextAnchor::Middle, CAPTION);
    };
    for (line, y) in caption.iter().zip([51.0, 67.0]) {
        caption_at(line, [middle, y], 12);
    }
    if curve.circles.is_empty() {
        let rests = format!("The axis is vertical for ever: the {name} rests.");
        caption_at(&rests, [middle, ABOVE + 0.5 * SIDE + 30.0], 14);
    }
    let [from, until] = span.ends_as_text();
    let shown = format!("t = {from} to {until}{}", scenario.units.name(" s"));
    caption_at(&shown, [LEFT + 0.88 * SIDE, ABOVE + SIDE + BELOW - 12.0], 12);
    text(&mut scene, &format!("y{unit}"), [12.0, ABOVE - 8.0], 14, TextAnchor::Start, "black");
    scene
}

/// Head of an arrow on the curve, near its start; none where the curve is a point.
fn arrow(curve: &Curve, scale: f64, extent: f64) -> Option<Plot> {
    let size = 0.035 * extent;
    let places: Vec<[f64; 2]> = curve.points.iter().map(|point| point.map(|x| x / scale)).collect();
    let first = places.first()?;
    let away = |place: &[f64; 2]| (place[0] - first[0]).hypot(place[1] - first[1]) > 2.5 * size;
    let tip = places.iter().position(away)?;
    let ([x, y], [from_x, from_y]) = (places[tip], places[tip - 1]);
    let angle = (y - from_y).atan2(x - from_x);
    let arm = |turn: f64| (x + size * (angle + turn).cos(), y + size * (angle + turn).sin());
    let head = LinePlot::new().with_color(START).with_stroke_width(1.7);
    Some(head.with_data([arm(2.7), (x, y), arm(-2.7)]).into())
}

/// Circles, then the curve, then its start, each drawn over the one before; lengths in units of `scale`.
fn lines(curve: &Curve, scale: f64, extent: f64, name: &str) -> Vec<Plot> {
    // rounded, so that the last bits of a table do not change the picture
    let unit = 10_f64.powf(extent.log10().floor() - 5.0);
    let rounded = |x: f64| (x / scale / unit).round() * unit;
    let place = |&[x, y]: &[f64; 2]| (rounded(x), rounded(y));
    let mut plots: Vec<Plot> = Vec::new();
    for (circle, style) in curve.circles.iter().zip(STYLES) {
        let corner = |i: u32| {
            let (sin, cos) = (2.0 * PI * f64::from(i) / f64::from(CORNERS)).sin_cos();
            (circle.radius / scale * cos, circle.radius / scale * sin)
        };
        let line = LinePlot::new().with_color(BOUND).with_stroke_width(1.1).with_line_style(style);
        plots.push(line.with_data((0..=CORNERS).map(corner)).with_legend(circle.bound.to_string()).into());
    }
    let tip = LinePlot::new().with_color(CURVE).with_stroke_width(1.7).with_legend(name);
    plots.push(tip.with_data(curve.points.iter().map(place)).into());
    let start_name = if curve.circles.is_empty() { "start" } else { "start, direction" };
    let start = ScatterPlot::new().with_color(START).with_size(4.0).with_legend(start_name);
    plots.push(start.with_data(curve.points.first().map(place)).into());
    plots.extend(arrow(curve, scale, extent));
    plots
}

/// Corners of a circle.
const CORNERS: u32 = 720;

/// Styles of the circles.
const STYLES: [LineStyle; 3] = [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted];

/// Half the width of the picture, which contains all points, circles and a margin, in units of `scale`.
fn extent(curve: &Curve, scale: f64) -> f64 {
    let points = curve.points.iter().map(|[x, y]| x.hypot(*y));
    let largest = curve.circles.iter().map(|circle| circle.radius).chain(points).fold(0.0, f64::max);
    1.18 * if largest > 0.0 { largest / scale } else { 1.0 }
}

//! Curve of the tip, or of the axis if the tip is held, between its bounding circles.

use crate::drawing::{ACCENT_COLOR, BOUND_COLOR, CAPTION_COLOR, CURVE_COLOR, frame, label_above, text};
use kuva::plot::scatter::ScatterPlot;
use kuva::plot::{LegendPosition, LinePlot, LineStyle};
use kuva::render::plots::Plot;
use kuva::render::render::{Scene, TextAnchor, render_multiple};
use std::f64::consts::PI;
use toytop::{Sign, Support};
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::output::significant;
use toytop_host::pictures::MotionSpan;
use toytop_host::pictures::curve::TipCurve;
use toytop_model::constants::Unit::Si;
use toytop_model::constants::tip_class;

/// Sizes of the layout in pixels: side of the square for the curve, and margins around it.
const SIDE: f64 = 560.0;
const LEFT: f64 = 72.0;
const RIGHT: f64 = 20.0;
const ABOVE: f64 = 92.0;
const BELOW: f64 = 58.0;

/// Draws the curve over a span of time.
pub fn draw(scenario: &Scenario, span: &MotionSpan) -> Scene {
    let mut curve = TipCurve::over(span);
    let s = scenario.motion.top().tip_scale();
    // in mm, or in units of s where the scenario names no units
    let (name, unit, scale) = match (scenario.motion.top().support(), scenario.units) {
        (Support::Sliding, Units::Si) => ("tip", ", mm", 1e-3),
        (Support::Sliding, Units::Unnamed) => ("tip", " in units of s", s),
        (Support::Fixed | Support::Free, _) => ("axis", " of the axis (length 1)", 1.0),
    };
    curve.points.iter_mut().flatten().for_each(|x| *x /= scale);
    curve.circles.iter_mut().for_each(|(radius, _)| *radius /= scale);
    let extent = extent(&curve);
    let plots = lines(&curve, extent, name);
    let layout = frame(&plots, &scenario.name, &format!("x{unit}"), [[-extent, extent]; 2])
        .with_equal_aspect()
        .with_show_grid(false)
        .with_width(LEFT + SIDE + RIGHT)
        .with_height(ABOVE + SIDE + BELOW)
        .with_force_margins(LEFT, RIGHT)
        .with_force_margins_y(ABOVE, BELOW)
        .with_legend_position(LegendPosition::InsideTopRight);
    let mut scene = render_multiple(plots, layout);
    let middle = LEFT + 0.5 * SIDE;
    let mut caption_at = |content: &str, place: [f64; 2], size: u32| {
        text(&mut scene, content, place, size, TextAnchor::Middle, CAPTION_COLOR);
    };
    let view = ": seen from above, the end of a unit vector along the axis";
    for (line, y) in caption(scenario, span, view).iter().zip([51.0, 67.0]) {
        caption_at(line, [middle, y], 12);
    }
    if curve.circles.is_empty() {
        let rests = format!("The axis is vertical for ever: the {name} rests.");
        caption_at(&rests, [middle, ABOVE + 0.5 * SIDE + 30.0], 14);
    }
    let [from, until] = span.ends_as_text();
    let shown = format!("t = {from} to {until}{}", scenario.units.name(Si(" s")));
    caption_at(&shown, [LEFT + 0.88 * SIDE, ABOVE + SIDE + BELOW - 12.0], 12);
    label_above(&mut scene, &format!("y{unit}"), [12.0, ABOVE - 8.0]);
    scene
}

/// Caption of the curve of the tip or the axis, two lines: its class and numbers of the scenario; for a held tip, `view` states what is drawn.
pub fn caption(scenario: &Scenario, span: &MotionSpan, view: &str) -> [String; 2] {
    let motion = &scenario.motion;
    let (top, e, signs) = (motion.top(), motion.branch_points(), motion.signs());
    let class = tip_class(motion.tip_class()).replace('_', " ");
    let periods = span.periods.map(|periods| format!(", {periods} periods")).unwrap_or_default();
    let shown = |e: f64| if e.is_finite() { significant(e, 4) } else { "∞".to_owned() };
    let [e1, e2, e3] = [e.e1, e.e2, e.e3].map(shown);
    // (l + n)² and (l - n)² are proportional to these
    let vanishes = [e.one_plus_e1 * (1.0 + e.e2), (1.0 - e.e1) * e.one_minus_e2 * e.e3_minus_one];
    let sign = |sign: Sign, vanishes: f64| match sign {
        _ if vanishes == 0.0 => '=',
        Sign::Plus => '>',
        Sign::Minus => '<',
    };
    let (plus, minus) = (sign(signs.l_plus_n, vanishes[0]), sign(signs.l_minus_n, vanishes[1]));
    let ratio = format!("C/A = {}", significant(top.axial_inertia() / top.transverse_inertia(), 4));
    let roots = format!("{class}{periods}: e₁ = {e1}, e₂ = {e2}, e₃ = {e3}");
    let signs = format!("l + n {plus} 0, l - n {minus} 0");
    let support = match top.support() {
        Support::Sliding => {
            let slenderness = top.transverse_inertia() / (top.mass_moment() * top.com_height());
            return [roots, format!("{signs}, A/(ps) = {}, {ratio}", significant(slenderness, 4))];
        }
        Support::Free => "free body",
        Support::Fixed => "tip held",
    };
    [format!("{roots}, {ratio}"), format!("{signs}, {support}{view}")]
}

/// Head of an arrow on the curve, near its start; none where the curve is a point.
fn arrow(points: &[[f64; 2]], extent: f64) -> Option<Plot> {
    let size = 0.035 * extent;
    let first = points.first()?;
    let away = |place: &[f64; 2]| (place[0] - first[0]).hypot(place[1] - first[1]) > 2.5 * size;
    let tip = points.iter().position(away)?;
    let ([x, y], [from_x, from_y]) = (points[tip], points[tip - 1]);
    let angle = (y - from_y).atan2(x - from_x);
    let arm = |turn: f64| (x + size * (angle + turn).cos(), y + size * (angle + turn).sin());
    let head = LinePlot::new().with_color(ACCENT_COLOR).with_stroke_width(1.7);
    Some(head.with_data([arm(2.7), (x, y), arm(-2.7)]).into())
}

/// Circles, then the curve, then its start, each drawn over the one before.
fn lines(curve: &TipCurve, extent: f64, name: &str) -> Vec<Plot> {
    // rounded, so that the last bits of a table do not change the picture
    let unit = 10_f64.powf(extent.log10().floor() - 5.0);
    let rounded = |x: f64| (x / unit).round() * unit;
    let place = |&[x, y]: &[f64; 2]| (rounded(x), rounded(y));
    let mut plots: Vec<Plot> = Vec::new();
    for ((radius, limit), style) in curve.circles.iter().zip(STYLES) {
        let corner = |i: u32| {
            let (sin, cos) = (2.0 * PI * f64::from(i) / f64::from(CORNERS)).sin_cos();
            (radius * cos, radius * sin)
        };
        let line = LinePlot::new().with_color(BOUND_COLOR).with_stroke_width(1.1).with_line_style(style);
        plots.push(line.with_data((0..=CORNERS).map(corner)).with_legend(limit.to_string()).into());
    }
    let tip = LinePlot::new().with_color(CURVE_COLOR).with_stroke_width(1.7).with_legend(name);
    plots.push(tip.with_data(curve.points.iter().map(place)).into());
    let start_name = if curve.circles.is_empty() { "start" } else { "start, direction" };
    let start = ScatterPlot::new().with_color(ACCENT_COLOR).with_size(4.0).with_legend(start_name);
    plots.push(start.with_data(curve.points.first().map(place)).into());
    plots.extend(arrow(&curve.points, extent));
    plots
}

/// Corners of a circle.
const CORNERS: u32 = 720;

/// Styles of the circles.
const STYLES: [LineStyle; 3] = [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted];

/// Half the width of the picture, which contains all points, circles and a margin.
fn extent(curve: &TipCurve) -> f64 {
    let points = curve.points.iter().map(|[x, y]| x.hypot(*y));
    let largest = curve.circles.iter().map(|(radius, _)| *radius).chain(points).fold(0.0, f64::max);
    1.18 * if largest > 0.0 { largest } else { 1.0 }
}

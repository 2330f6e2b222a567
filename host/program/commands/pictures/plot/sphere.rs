//! Curve of the axis on the unit sphere.

use super::tip::caption;
use crate::drawing::camera::{Camera, circle};
use crate::drawing::{ACCENT_COLOR, BOUND_COLOR, CAPTION_COLOR, CURVE_COLOR, disc, line, text};
use kuva::render::render::{Scene, TextAnchor};
use toytop_host::input::scenario::Scenario;
use toytop_host::pictures::MotionSpan;
use toytop_host::pictures::curve::TiltLimit;
use toytop_model::constants::Unit::Si;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 700.0;
const MIDDLE: [f64; 2] = [320.0, 385.0];
const RADIUS: f64 = 265.0;
/// Horizontal position at which the names of the parallels begin, pixels.
const LABELS: f64 = 572.0;

/// Draws the curve of the axis over a span of time.
pub fn draw(scenario: &Scenario, span: &MotionSpan) -> Scene {
    let mut scene = Scene::new(WIDTH, HEIGHT);
    let picture = &mut scene;
    let camera = Camera::new(-1.05, 0.42, MIDDLE, RADIUS);
    let middle = TextAnchor::Middle;
    let title = format!("{}: the axis on the unit sphere", scenario.name);
    text(picture, &title, [MIDDLE[0], 34.0], 18, middle, "black");
    for (line, y) in caption(scenario, span, "").iter().zip([58.0, 76.0]) {
        text(picture, line, [MIDDLE[0], y], 12, middle, CAPTION_COLOR);
    }
    disc(picture, MIDDLE.into(), RADIUS, "#fbfbfb", Some(BOUND_COLOR));
    camera.line_on_sphere(picture, &circle(1.0, 0.0), ["#c4c4c4", "#e6e6e6"], 1.0);
    camera.line(picture, &[[0.0, 0.0, 1.0], [0.0, 0.0, 1.12]], BOUND_COLOR, 1.2);
    let (x, y) = camera.project([0.0, 0.0, 1.15]);
    text(picture, "up", [x, y - 2.0], 12, middle, CAPTION_COLOR);
    let e2 = scenario.motion.branch_points().e2;
    let (_, highest) = camera.project([0.0, 0.0, e2]);
    for limit in TiltLimit::all(&scenario.motion) {
        camera.line_on_sphere(picture, &circle(limit.sine, limit.u), ["#6a6a6a", "#cfcfcf"], 1.2);
        // beside the sphere, with a line from the right end of the parallel
        let (x, y) = camera.project([0.0, 0.0, limit.u]);
        let label = if limit.u < e2 { y.max(highest + 18.0) } else { y };
        let ends = [(x + RADIUS * limit.sine + 3.0, y), (LABELS - 6.0, label - 4.0)];
        line(picture, ends.into(), "#cfcfcf", 1.0);
        text(picture, &limit.to_string(), [LABELS, label], 12, TextAnchor::Start, "#333333");
    }
    let points: Vec<_> = span.times_of_curve().map(|t| span.at(t).orientation.axis()).collect();
    camera.line_on_sphere(picture, &points, [CURVE_COLOR, "#b4c6dd"], 1.8);
    disc(picture, camera.project(points[0]), 4.5, ACCENT_COLOR, None);
    let [from, until] = span.ends_as_text();
    let unit = scenario.units.name(Si(" s"));
    let shown = format!("dot: t = {from}; line: until t = {until}{unit}; pale: behind");
    text(picture, &shown, [MIDDLE[0], HEIGHT - 16.0], 12, middle, CAPTION_COLOR);
    scene
}

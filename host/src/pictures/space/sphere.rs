//! Curve of the axis on the unit sphere.

use super::camera::{Camera, circle};
use crate::input::scenario::Scenario;
use crate::pictures::curve::Bound;
use crate::pictures::drawing::{BOUND, CAPTION, CURVE, START, disc, line, text};
use crate::pictures::span::Span;
use kuva::render::render::{Scene, TextAnchor};

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 700.0;
const MIDDLE: [f64; 2] = [320.0, 385.0];
const RADIUS: f64 = 265.0;
/// Horizontal position at which the names of the parallels begin, pixels.
const LABELS: f64 = 572.0;

/// Draws the curve of the axis over a span of time; the lines of the caption are below the title.
pub fn draw(scenario: &Scenario, span: &Span, caption: &[String]) -> Scene {
    let mut scene = Scene::new(WIDTH, HEIGHT);
    let picture = &mut scene;
    let camera = Camera::new(-1.05, 0.42, MIDDLE, RADIUS);
    let middle = TextAnchor::Middle;
    let title = format!("{}: the axis on the unit sphere", scenario.name);
    text(picture, &title, [MIDDLE[0], 34.0], 18, middle, "black");
    for (line, y) in caption.iter().zip([58.0, 76.0]) {
        text(picture, line, [MIDDLE[0], y], 12, middle, CAPTION);
    }
    disc(picture, MIDDLE.into(), RADIUS, "#fbfbfb", Some(BOUND));
    camera.line_on_sphere(picture, &circle(1.0, 0.0), ["#c4c4c4", "#e6e6e6"], 1.0);
    camera.line(picture, &[[0.0, 0.0, 1.0], [0.0, 0.0, 1.12]], BOUND, 1.2);
    let (x, y) = camera.place([0.0, 0.0, 1.15]);
    text(picture, "up", [x, y - 2.0], 12, middle, CAPTION);
    let (_, highest) = camera.place([0.0, 0.0, scenario.motion.branch_points().e2]);
    for bound in Bound::of(&scenario.motion) {
        let radius = (1.0 - bound.u * bound.u).max(0.0).sqrt();
        camera.line_on_sphere(picture, &circle(radius, bound.u), ["#6a6a6a", "#cfcfcf"], 1.2);
        // beside the sphere, with a line from the right end of the parallel
        let (x, y) = camera.place([0.0, 0.0, bound.u]);
        let label = if bound.place == "lowest" { y.max(highest + 18.0) } else { y };
        let ends = [(x + RADIUS * radius + 3.0, y), (LABELS - 6.0, label - 4.0)];
        line(picture, ends.into(), "#cfcfcf", 1.0);
        text(picture, &bound.to_string(), [LABELS, label], 12, TextAnchor::Start, "#333333");
    }
    let points: Vec<_> = span.times_of_curve().map(|t| span.at(t).orientation().axis()).collect();
    camera.line_on_sphere(picture, &points, [CURVE, "#b4c6dd"], 1.8);
    disc(picture, camera.place(points[0]), 4.5, START, None);
    let [from, until] = span.ends_as_text();
    let unit = scenario.units.name(" s");
    let shown = format!("dot: t = {from}; line: until t = {until}{unit}; pale: behind");
    text(picture, &shown, [MIDDLE[0], HEIGHT - 16.0], 12, middle, CAPTION);
    scene
}

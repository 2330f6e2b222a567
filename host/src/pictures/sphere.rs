//! Curve of the axis on the unit sphere.

use super::camera::{Camera, circle, text};
use super::plot::{Bound, Place};
use super::span::{Span, ends_as_text};
use crate::input::scenario::Scenario;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor};

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 700.0;
const MIDDLE: [f64; 2] = [320.0, 385.0];
const RADIUS: f64 = 265.0;
/// Horizontal position at which the names of the parallels begin, pixels.
const LABELS: f64 = 572.0;
/// Least number of points of the curve, and least number in a cycle of the motion.
const POINTS: u64 = 6000;
const PER_CYCLE: u64 = 64;

/// Draws the curve of the axis over a span of time; the lines of the caption are below the title.
#[must_use]
pub(crate) fn draw(scenario: &Scenario, span: &Span, caption: &[String]) -> Scene {
    let mut scene = Scene::new(WIDTH, HEIGHT);
    let camera = Camera::new(-1.05, 0.42, MIDDLE, RADIUS);
    let (motion, units) = (&scenario.motion, scenario.units);
    let middle = TextAnchor::Middle;
    text(
        &mut scene,
        &format!("{}: the axis on the unit sphere", scenario.name),
        [MIDDLE[0], 34.0],
        18,
        middle,
        "black",
    );
    for (line, y) in caption.iter().zip([58.0, 76.0]) {
        text(&mut scene, line, [MIDDLE[0], y], 12, middle, "#555555");
    }
    scene.add(Primitive::Circle {
        cx: MIDDLE[0],
        cy: MIDDLE[1],
        r: RADIUS,
        fill: Color::from("#fbfbfb"),
        fill_opacity: None,
        stroke: Some(Color::from("#8a8a8a")),
        stroke_width: Some(1.0),
    });
    camera.line_on_sphere(&mut scene, &circle(1.0, 0.0), ["#c4c4c4", "#e6e6e6"], 1.0);
    camera.line(&mut scene, &[[0.0, 0.0, 1.0], [0.0, 0.0, 1.12]], "#8a8a8a", 1.2);
    let (x, y) = camera.place([0.0, 0.0, 1.15]);
    text(&mut scene, "up", [x, y - 2.0], 12, middle, "#555555");
    let e = motion.branch_points();
    let (_, e2_y) = camera.place([0.0, 0.0, e.e2]);
    for bound in Bound::of(motion) {
        let u = bound.u;
        let parallel = circle((1.0 - u * u).max(0.0).sqrt(), u);
        camera.line_on_sphere(&mut scene, &parallel, ["#6a6a6a", "#cfcfcf"], 1.2);
        // beside the sphere, with a line from the right end of the parallel
        let (x, y) = camera.place([0.0, 0.0, u]);
        let right = x + RADIUS * (1.0 - u * u).max(0.0).sqrt();
        let label_y = if bound.place == Place::Lowest { y.max(e2_y + 18.0) } else { y };
        let points = [(right + 3.0, y), (LABELS - 6.0, label_y - 4.0)].into();
        let stroke = Color::from("#cfcfcf");
        scene.add(Primitive::PolyLine { points, stroke, stroke_width: 1.0, stroke_dasharray: None });
        text(&mut scene, &bound.to_string(), [LABELS, label_y], 12, TextAnchor::Start, "#333333");
    }
    let axis = |t: f64| span.at(t).orientation().axis();
    let points: Vec<_> = span.times_in_cycles(POINTS, PER_CYCLE).map(axis).collect();
    camera.line_on_sphere(&mut scene, &points, ["#1f4e8c", "#b4c6dd"], 1.8);
    if let [first, ..] = points[..] {
        let (cx, cy) = camera.place(first);
        let fill = Color::from("#c0392b");
        scene.add(Primitive::Circle {
            cx,
            cy,
            r: 4.5,
            fill,
            fill_opacity: None,
            stroke: None,
            stroke_width: None,
        });
    }
    let [from, until] = ends_as_text(span.ends());
    let shown = format!("dot: t = {from}; line: until t = {until}{}; pale: behind", units.name(" s"));
    text(&mut scene, &shown, [MIDDLE[0], HEIGHT - 16.0], 12, middle, "#555555");
    scene
}

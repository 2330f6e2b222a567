//! Curve of the axis on the unit sphere.

use super::tip::caption;
use crate::commands::pictures::drawing::{
    ACCENT_COLOR, BOUND_COLOR, CAPTION_COLOR, CURVE_COLOR, disc, line, text,
};
use kuva::render::render::{Scene, TextAnchor};
use std::f64::consts::PI;
use toytop_host::input::scenario::Scenario;
use toytop_host::pictures::MotionSpan;
use toytop_host::pictures::curve::TiltLimit;
use toytop_model::equations::dot;
use toytop_model::unit::Unit::Si;

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
    let points: Vec<_> = span.times_of_curve().map(|t| span.at(t).pose.orientation.axis()).collect();
    camera.line_on_sphere(picture, &points, [CURVE_COLOR, "#b4c6dd"], 1.8);
    disc(picture, camera.project(points[0]), 4.5, ACCENT_COLOR, None);
    let [from, until] = span.ends_as_text();
    let unit = scenario.units.name(Si(" s"));
    let shown = format!("dot: t = {from}; line: until t = {until}{unit}; pale: behind");
    text(picture, &shown, [MIDDLE[0], HEIGHT - 16.0], 12, middle, CAPTION_COLOR);
    scene
}

/// Parallel projection from a direction above the horizon, with its middle and its scale on paper.
pub struct Camera {
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
    /// Place of the origin on paper, pixels.
    middle: [f64; 2],
    /// Pixels of a unit of length.
    scale: f64,
}

impl Camera {
    /// Projection from the direction with this azimuth and elevation above the horizon, rad.
    pub fn new(azimuth: f64, elevation: f64, middle: [f64; 2], scale: f64) -> Self {
        let (s, c) = azimuth.sin_cos();
        let (rise, level) = elevation.sin_cos();
        Self {
            right: [-s, c, 0.0],
            up: [-rise * c, -rise * s, level],
            towards: [level * c, level * s, rise],
            middle,
            scale,
        }
    }

    /// Place on paper, pixels.
    pub fn project(&self, point: [f64; 3]) -> (f64, f64) {
        let [x, y] = [self.right, self.up].map(|axis| self.scale * dot(axis, point));
        (self.middle[0] + x, self.middle[1] - y)
    }

    /// Whether a point of a sphere about the origin is on its near side.
    fn sees(&self, point: [f64; 3]) -> bool {
        dot(self.towards, point) >= 0.0
    }

    /// Adds a line through points of space.
    pub fn line(&self, scene: &mut Scene, points: &[[f64; 3]], color: &str, stroke_width: f64) {
        let points = points.iter().map(|point| self.project(*point)).collect();
        line(scene, points, color, stroke_width);
    }

    /// Adds a line on a sphere about the origin. Its part on the far side is thinner and pale.
    fn line_on_sphere(&self, scene: &mut Scene, points: &[[f64; 3]], [near, far]: [&str; 2], width: f64) {
        let mut from = 0;
        for piece in points.chunk_by(|a, b| self.sees(*a) == self.sees(*b)) {
            let until = from + piece.len();
            let (color, width) = if self.sees(piece[0]) { (near, width) } else { (far, 0.6 * width) };
            // up to the first point of the next piece
            self.line(scene, &points[from..(until + 1).min(points.len())], color, width);
            from = until;
        }
    }
}

/// Points of a horizontal circle about the vertical axis.
pub fn circle(radius: f64, height: f64) -> Vec<[f64; 3]> {
    const CORNERS: u32 = 180;
    let corner = |i: u32| {
        let angle = 2.0 * PI * f64::from(i) / f64::from(CORNERS);
        [radius * angle.cos(), radius * angle.sin(), height]
    };
    (0..=CORNERS).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_is_up_and_the_near_side_is_seen() {
        let camera = Camera::new(-1.0, 0.4, [100.0, 100.0], 50.0);
        let (x, y) = camera.project([0.0, 0.0, 1.0]);
        assert!((x - 100.0).abs() < 1e-12 && (y - (100.0 - 50.0 * 0.4_f64.cos())).abs() < 1e-12);
        let near = [(-1.0_f64).cos(), (-1.0_f64).sin(), 0.0];
        assert!(camera.sees(near) && !camera.sees(near.map(|x| -x)));
        // of a right-handed frame seen from in front, y is to the right where x comes near
        let front = Camera::new(0.0, 0.0, [0.0, 0.0], 1.0);
        assert!(front.project([0.0, 1.0, 0.0]).0 > 0.99);
    }
}

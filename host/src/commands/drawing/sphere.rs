//! Pictures of space: the curve of the axis on the unit sphere, and the top in motion as a GIF.

use super::tip::caption;
use super::{BOUND, CAPTION, CURVE, START, disc, line, raster, text};
use crate::input::scenario::Scenario;
use crate::output::progress::Progress;
use crate::pictures::curve::TiltLimit;
use crate::pictures::span::Span;
use kuva::render::render::{Scene, TextAnchor};
use std::f64::consts::PI;
use std::io::{self, Write};
use toytop::Support;
use toytop_model::equations::dot;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 700.0;
const MIDDLE: [f64; 2] = [320.0, 385.0];
const RADIUS: f64 = 265.0;
/// Horizontal position at which the names of the parallels begin, pixels.
const LABELS: f64 = 572.0;

/// Draws the curve of the axis over a span of time.
pub fn draw(scenario: &Scenario, span: &Span) -> Scene {
    let mut scene = Scene::new(WIDTH, HEIGHT);
    let picture = &mut scene;
    let camera = Camera::new(-1.05, 0.42, MIDDLE, RADIUS);
    let middle = TextAnchor::Middle;
    let title = format!("{}: the axis on the unit sphere", scenario.name);
    text(picture, &title, [MIDDLE[0], 34.0], 18, middle, "black");
    for (line, y) in caption(scenario, span, "").iter().zip([58.0, 76.0]) {
        text(picture, line, [MIDDLE[0], y], 12, middle, CAPTION);
    }
    disc(picture, MIDDLE.into(), RADIUS, "#fbfbfb", Some(BOUND));
    camera.line_on_sphere(picture, &circle(1.0, 0.0), ["#c4c4c4", "#e6e6e6"], 1.0);
    camera.line(picture, &[[0.0, 0.0, 1.0], [0.0, 0.0, 1.12]], BOUND, 1.2);
    let (x, y) = camera.place([0.0, 0.0, 1.15]);
    text(picture, "up", [x, y - 2.0], 12, middle, CAPTION);
    let (_, highest) = camera.place([0.0, 0.0, scenario.motion.branch_points().e2]);
    for limit in TiltLimit::all(&scenario.motion) {
        camera.line_on_sphere(picture, &circle(limit.sine, limit.u), ["#6a6a6a", "#cfcfcf"], 1.2);
        // beside the sphere, with a line from the right end of the parallel
        let (x, y) = camera.place([0.0, 0.0, limit.u]);
        let label = if limit.name == "lowest" { y.max(highest + 18.0) } else { y };
        let ends = [(x + RADIUS * limit.sine + 3.0, y), (LABELS - 6.0, label - 4.0)];
        line(picture, ends.into(), "#cfcfcf", 1.0);
        text(picture, &limit.to_string(), [LABELS, label], 12, TextAnchor::Start, "#333333");
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

/// Parallel projection from a direction above the horizon, with its middle and its scale on paper.
struct Camera {
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
    fn new(azimuth: f64, elevation: f64, middle: [f64; 2], scale: f64) -> Self {
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
    fn place(&self, point: [f64; 3]) -> (f64, f64) {
        let [x, y] = [self.right, self.up].map(|axis| self.scale * dot(axis, point));
        (self.middle[0] + x, self.middle[1] - y)
    }

    /// Whether a point of a sphere about the origin is on its near side.
    fn sees(&self, point: [f64; 3]) -> bool {
        dot(self.towards, point) >= 0.0
    }

    /// Adds a line through points of space.
    fn line(&self, scene: &mut Scene, points: &[[f64; 3]], color: &str, stroke_width: f64) {
        let points = points.iter().map(|point| self.place(*point)).collect();
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
fn circle(radius: f64, height: f64) -> Vec<[f64; 3]> {
    const CORNERS: u32 = 180;
    let corner = |i: u32| {
        let angle = 2.0 * PI * f64::from(i) / f64::from(CORNERS);
        [radius * angle.cos(), radius * angle.sin(), height]
    };
    (0..=CORNERS).map(corner).collect()
}

/// Side of a frame's layout, pixels.
const SIDE: f64 = 480.0;
/// Radius of the disc and length of the axis, in units of the height of the centre of mass.
const DISC: f64 = 0.75;
const AXIS: f64 = 1.45;
/// Number of points of the path of the tip, or of the axis if the tip is held.
const PATH: u64 = 1500;

/// Film of a motion over a span of time, in frames that are evenly spread over it.
pub struct Film<'a> {
    pub scenario: &'a Scenario,
    pub span: &'a Span,
    pub frames: u64,
    /// Width and height of a frame, pixels.
    pub size: u16,
}

impl Film<'_> {
    /// Lower and upper end of the axis.
    fn ends(&self, t: f64) -> [[f64; 3]; 2] {
        let [x, y, z] = self.span.at(t).orientation().axis();
        let tip = match self.scenario.motion.top().support() {
            // the centre of mass stays above one point of the plane
            Support::Sliding => [-x, -y, 0.0],
            Support::Fixed | Support::Free => [0.0; 3],
        };
        [tip, [tip[0] + AXIS * x, tip[1] + AXIS * y, tip[2] + AXIS * z]]
    }

    /// Picture of one frame.
    fn scene(&self, frame: u64) -> Scene {
        let share = frame as f64 / (self.frames.max(2) - 1) as f64;
        let t = self.span.times(self.frames).nth(frame as usize).unwrap_or_default();
        let phi = self.span.at(t).orientation();
        let [tip, end] = self.ends(t);
        let mut scene = Scene::new(SIDE, SIDE);
        let camera = Camera::new(-1.05, 0.38, [0.5 * SIDE, 0.72 * SIDE], 0.27 * SIDE);
        for radius in [0.5, 1.0] {
            camera.line(&mut scene, &circle(radius, 0.0), "#dedede", 1.0);
        }
        // what leaves a trace is the tip that slides, or the upper end of the axis
        let traced = usize::from(self.scenario.motion.top().support() != Support::Sliding);
        let count = ((share * PATH as f64) as usize).max(1);
        let path: Vec<_> = self.span.times(PATH).take(count).map(|t| self.ends(t)[traced]).collect();
        camera.line(&mut scene, &path, CURVE, 1.6);
        camera.line(&mut scene, &[tip, end], CAPTION, 4.0);
        // disc about the centre of mass, with spokes that turn with the body
        let rim = |angle: f64, radius: f64| {
            let [x, y, z] = phi.adjoint([radius * angle.cos(), radius * angle.sin(), 1.0]);
            [tip[0] + x, tip[1] + y, tip[2] + z]
        };
        let around: Vec<_> = (0..=96).map(|i| rim(2.0 * PI * f64::from(i) / 96.0, DISC)).collect();
        camera.line(&mut scene, &around, "#333333", 3.0);
        for spoke in 0..6 {
            let angle = PI * f64::from(spoke) / 3.0;
            // one spoke has another colour, so that the rotation can be seen
            let (color, width) = if spoke == 0 { (START, 4.0) } else { ("#9a9a9a", 1.4) };
            camera.line(&mut scene, &[rim(angle, 0.0), rim(angle, DISC)], color, width);
        }
        disc(&mut scene, camera.place(rim(0.0, DISC)), 5.0, START, None);
        text(&mut scene, &self.scenario.name, [14.0, 26.0], 15, TextAnchor::Start, "black");
        let time = format!("t = {t:.3}{}", self.scenario.units.name(" s"));
        text(&mut scene, &time, [SIDE - 14.0, 26.0], 15, TextAnchor::End, "black");
        scene
    }

    /// Pixels of one frame, four bytes each.
    fn pixels(&self, frame: u64) -> io::Result<Vec<u8>> {
        let png = raster(&self.scene(frame), f64::from(self.size) / SIDE)?;
        let mut reader = png::Decoder::new(io::Cursor::new(png)).read_info()?;
        let mut bytes = vec![0; reader.output_buffer_size().unwrap_or_default()];
        reader.next_frame(&mut bytes)?;
        Ok(bytes)
    }

    /// All frames as a GIF that repeats without end. Each frame lasts `delay` hundredths of a second.
    ///
    /// # Errors
    /// The errors of the writer.
    pub fn gif(&self, delay: u16, out: impl Write, progress: &Progress) -> io::Result<()> {
        let mut encoder = gif::Encoder::new(out, self.size, self.size, &[]).map_err(io::Error::other)?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(io::Error::other)?;
        for frame in 0..self.frames {
            let mut pixels = self.pixels(frame)?;
            let mut picture = gif::Frame::from_rgba_speed(self.size, self.size, &mut pixels, 10);
            picture.delay = delay;
            encoder.write_frame(&picture).map_err(io::Error::other)?;
            progress.add(1);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_is_up_and_the_near_side_is_seen() {
        let camera = Camera::new(-1.0, 0.4, [100.0, 100.0], 50.0);
        let (x, y) = camera.place([0.0, 0.0, 1.0]);
        assert!((x - 100.0).abs() < 1e-12 && (y - (100.0 - 50.0 * 0.4_f64.cos())).abs() < 1e-12);
        let near = [(-1.0_f64).cos(), (-1.0_f64).sin(), 0.0];
        assert!(camera.sees(near) && !camera.sees(near.map(|x| -x)));
        // of a right-handed frame seen from in front, y is to the right where x comes near
        let front = Camera::new(0.0, 0.0, [0.0, 0.0], 1.0);
        assert!(front.place([0.0, 1.0, 0.0]).0 > 0.99);
    }
}

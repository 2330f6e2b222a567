//! The top in motion: frames at exact times, as a GIF or as pictures for a program that makes films.

use super::camera::{Camera, circle};
use crate::input::scenario::Scenario;
use crate::pictures::drawing::{CAPTION, CURVE, START, disc, raster, text};
use crate::pictures::span::Span;
use kuva::render::render::{Scene, TextAnchor};
use std::f64::consts::PI;
use std::io::{self, Write};
use toytop::Support;

/// Side of a frame's layout, pixels.
const SIDE: f64 = 480.0;
/// Radius of the disc and length of the axis, in units of the height of the centre of mass.
const DISC: f64 = 0.75;
const AXIS: f64 = 1.45;
/// Number of points of the path of the tip, or of the axis if the tip is held.
const PATH: u64 = 1500;

/// Frames of a motion over a span of time.
pub struct Film<'a> {
    scenario: &'a Scenario,
    span: &'a Span,
    frames: u64,
    camera: Camera,
    /// Width and height of a frame, pixels.
    size: u32,
    /// Points of the path, in units of the height of the centre of mass.
    path: Vec<[f64; 3]>,
}

impl<'a> Film<'a> {
    /// Film of this many frames, evenly spread over the span, each `size` pixels wide and high.
    pub fn new(scenario: &'a Scenario, span: &'a Span, frames: u64, size: u32) -> Self {
        let camera = Camera::new(-1.05, 0.38, [0.5 * SIDE, 0.72 * SIDE], 0.27 * SIDE);
        let mut film = Self { scenario, span, frames, camera, size, path: Vec::new() };
        // what leaves a trace is the tip that slides, or the upper end of the axis
        let traced = usize::from(scenario.motion.top().support() != Support::Sliding);
        film.path = span.times(PATH).map(|t| film.ends(t)[traced]).collect();
        film
    }

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
        let t = self.span.times(self.frames).nth(frame as usize).unwrap_or_default();
        let phi = self.span.at(t).orientation();
        let [tip, end] = self.ends(t);
        let mut scene = Scene::new(SIDE, SIDE);
        let camera = &self.camera;
        for radius in [0.5, 1.0] {
            camera.line(&mut scene, &circle(radius, 0.0), "#dedede", 1.0);
        }
        let share = frame as f64 / (self.frames.max(2) - 1) as f64;
        let traced = ((share * PATH as f64) as usize).clamp(1, self.path.len());
        camera.line(&mut scene, &self.path[..traced], CURVE, 1.6);
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

    /// One frame as a PNG file.
    ///
    /// # Errors
    /// The frame cannot be encoded.
    pub fn png(&self, frame: u64) -> io::Result<Vec<u8>> {
        raster(&self.scene(frame), f64::from(self.size) / SIDE)
    }

    /// All frames as a GIF that repeats without end. Each frame lasts `delay` hundredths of a second; `done` is called
    /// after each.
    ///
    /// # Errors
    /// The errors of the writer.
    pub fn gif(&self, delay: u16, out: impl Write, mut done: impl FnMut()) -> io::Result<()> {
        let side = u16::try_from(self.size).map_err(io::Error::other)?;
        let mut encoder = gif::Encoder::new(out, side, side, &[]).map_err(io::Error::other)?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(io::Error::other)?;
        for frame in 0..self.frames {
            let (width, height, mut pixels) = pixels(&self.png(frame)?)?;
            let mut picture = gif::Frame::from_rgba_speed(width, height, &mut pixels, 10);
            picture.delay = delay;
            encoder.write_frame(&picture).map_err(io::Error::other)?;
            done();
        }
        Ok(())
    }
}

/// Width, height and pixels of a PNG file, four bytes each.
fn pixels(png: &[u8]) -> io::Result<(u16, u16, Vec<u8>)> {
    let mut decoder = png::Decoder::new(io::Cursor::new(png));
    decoder.set_transformations(png::Transformations::ALPHA | png::Transformations::STRIP_16);
    let mut reader = decoder.read_info().map_err(io::Error::other)?;
    let size = reader.output_buffer_size().ok_or_else(|| io::Error::other("a frame is too large"))?;
    let mut bytes = vec![0; size];
    let info = reader.next_frame(&mut bytes).map_err(io::Error::other)?;
    bytes.truncate(info.buffer_size());
    let narrow = |x: u32| u16::try_from(x).map_err(io::Error::other);
    Ok((narrow(info.width)?, narrow(info.height)?, bytes))
}

//! Film of the top in motion, as a GIF.

use crate::drawing::camera::{Camera, circle};
use crate::drawing::{ACCENT_COLOR, CAPTION_COLOR, CURVE_COLOR, disc, raster, text};
use crate::terminal::parallel::Progress;
use kuva::render::render::{Scene, TextAnchor};
use std::f64::consts::PI;
use std::io::{self, Write};
use toytop::Support;
use toytop_host::input::scenario::Scenario;
use toytop_host::pictures::MotionSpan;
use toytop_model::constants::Unit::Si;

/// Side of a frame's layout, pixels.
const SIDE: f64 = 480.0;
/// Radius of the disc and length of the axis, in units of the height of the centre of mass.
const DISC: f64 = 0.75;
const AXIS: f64 = 1.45;
/// Number of points of the path of the tip, or of the axis if the tip is held.
const PATH: u64 = 1500;

/// Film of a motion over a span of time, in frames that are evenly spread over it.
pub struct Film<'a> {
    /// Scenario of the motion.
    pub scenario: &'a Scenario,
    /// Span of time that the film shows.
    pub span: &'a MotionSpan,
    /// Number of frames.
    pub frames: u64,
    /// Width and height of a frame, pixels.
    pub size: u16,
}

impl Film<'_> {
    /// Lower and upper end of the axis.
    fn ends_of_axis(&self, t: f64) -> [[f64; 3]; 2] {
        let [x, y, z] = self.span.at(t).orientation.axis();
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
        let orientation = self.span.at(t).orientation;
        let [tip, end] = self.ends_of_axis(t);
        let mut scene = Scene::new(SIDE, SIDE);
        let camera = Camera::new(-1.05, 0.38, [0.5 * SIDE, 0.72 * SIDE], 0.27 * SIDE);
        for radius in [0.5, 1.0] {
            camera.line(&mut scene, &circle(radius, 0.0), "#dedede", 1.0);
        }
        // what leaves a trace is the tip that slides, or the upper end of the axis
        let traced = usize::from(self.scenario.motion.top().support() != Support::Sliding);
        let count = ((share * PATH as f64) as usize).max(1);
        let path: Vec<_> = self.span.times(PATH).take(count).map(|t| self.ends_of_axis(t)[traced]).collect();
        camera.line(&mut scene, &path, CURVE_COLOR, 1.6);
        camera.line(&mut scene, &[tip, end], CAPTION_COLOR, 4.0);
        // disc about the centre of mass, with spokes that turn with the body
        let rim = |angle: f64, radius: f64| {
            let [x, y, z] = orientation.adjoint([radius * angle.cos(), radius * angle.sin(), 1.0]);
            [tip[0] + x, tip[1] + y, tip[2] + z]
        };
        let around: Vec<_> = (0..=96).map(|i| rim(2.0 * PI * f64::from(i) / 96.0, DISC)).collect();
        camera.line(&mut scene, &around, "#333333", 3.0);
        for spoke in 0..6 {
            let angle = PI * f64::from(spoke) / 3.0;
            // one spoke has another colour, so that the rotation can be seen
            let (color, width) = if spoke == 0 { (ACCENT_COLOR, 4.0) } else { ("#9a9a9a", 1.4) };
            camera.line(&mut scene, &[rim(angle, 0.0), rim(angle, DISC)], color, width);
        }
        disc(&mut scene, camera.project(rim(0.0, DISC)), 5.0, ACCENT_COLOR, None);
        text(&mut scene, &self.scenario.name, [14.0, 26.0], 15, TextAnchor::Start, "black");
        let time = format!("t = {t:.3}{}", self.scenario.units.name(Si(" s")));
        text(&mut scene, &time, [SIDE - 14.0, 26.0], 15, TextAnchor::End, "black");
        scene
    }

    /// Pixels of one frame, four bytes each. kuva draws pixels as a PNG only.
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

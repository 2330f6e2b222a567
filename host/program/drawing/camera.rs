//! Lines of space, drawn as they are seen from one direction.

use super::line;
use kuva::render::render::Scene;
use std::f64::consts::PI;
use toytop_model::equations::dot;

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
    pub fn line_on_sphere(&self, scene: &mut Scene, points: &[[f64; 3]], [near, far]: [&str; 2], width: f64) {
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

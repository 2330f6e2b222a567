//! Bounds on the errors of segments and on speeds.

use crate::scalar::Ring;

/// Upper bounds on the errors of segments, rad, and on speeds, rad per half period. They are in `f32`, for which many chips have an FPU.
#[derive(Debug)]
pub(super) struct SegmentBounds {
    /// Orientation error by truncation, rad; infinite where a tick could overflow.
    pub(super) error: f32,
    /// Angular speed 2 √(|da/dt|² + |db/dt|²), rad per half period.
    pub(super) angular_speed: f32,
    /// Rate of a residual phase, rad per half period.
    pub(super) residual_rate: f32,
    /// Rate of the local coordinate x.
    pub(super) coordinate_rate: f32,
}

impl SegmentBounds {
    pub(super) const ZERO: Self =
        Self { error: 0.0, angular_speed: 0.0, residual_rate: 0.0, coordinate_rate: 0.0 };

    /// Includes other segments.
    pub(super) fn include(&mut self, other: &Self) {
        let raise = |greatest: &mut f32, other: f32| *greatest = greatest.larger_or_nan(other);
        raise(&mut self.error, other.error);
        raise(&mut self.angular_speed, other.angular_speed);
        raise(&mut self.residual_rate, other.residual_rate);
        raise(&mut self.coordinate_rate, other.coordinate_rate);
    }

    /// Greatest change of the orientation on half a segment, rad. The half is at most a cell.
    pub(super) fn half_segment_change(&self) -> f64 {
        f64::from(self.angular_speed) / 16.0
    }

    /// Orientation error by a delay of χ alone, in half periods.
    pub(super) fn error_of_delay(&self, delay: f64) -> f64 {
        f64::from(self.angular_speed + 2.0 * self.residual_rate) * delay
    }
}

//! Errors and derivatives of the segments, and the greatest speeds of the table, by which a delay causes an error.

use super::limits::max_or_nan;
use crate::scalar::Float;
use crate::table::evaluation::TABLE_UNIT;

/// Errors and derivative of a segment, in units of 2^-62. `f64` is slow without an FPU for it.
#[derive(Default)]
pub(super) struct SegmentErrors {
    /// Greatest orientation error by the stored coefficients.
    pub(super) stored: f32,
    /// Sum of the squares of the truncation errors of a and b.
    pub(super) truncation_squared: f32,
    /// Sum of the squares of bounds on da/dx and db/dx.
    pub(super) slope_squared: f32,
}

impl SegmentErrors {
    /// Orientation error by truncation and rounding, in units of 2^-62 rad.
    pub(super) fn orientation(&self) -> f32 {
        max_or_nan(2.0 * Float::sqrt(self.truncation_squared), self.stored)
    }
}

/// Upper bounds on the speeds of the tabulated a and b. The unit of time is half a period.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speeds {
    /// Angular speed 2 √(|da/dt|² + |db/dt|²), rad.
    pub(super) angular_speed: f64,
    /// Twice the greater rate of a residual phase, rad.
    pub(super) twice_residual_rate: f64,
    /// Rate of the local coordinate x.
    pub(super) x_rate: f64,
}

impl Speeds {
    pub(super) const ZERO: Self = Self { angular_speed: 0.0, twice_residual_rate: 0.0, x_rate: 0.0 };

    /// Includes the speeds on a segment.
    ///
    /// * `x_rate`: rate of x per half period
    /// * `residual_rate`: bound on the rates of the residual phases by x
    pub(super) fn include(&mut self, segment: &SegmentErrors, x_rate: f32, residual_rate: f32) {
        let include = |greatest: &mut f64, speed: f32| *greatest = max_or_nan(*greatest, speed.into());
        let slope = 2.0 * TABLE_UNIT as f32 * Float::sqrt(segment.slope_squared);
        include(&mut self.angular_speed, slope * x_rate);
        include(&mut self.twice_residual_rate, 2.0 * residual_rate * x_rate);
        include(&mut self.x_rate, x_rate);
    }

    /// Greatest change of the orientation on half a segment, which is at most one cell, rad.
    pub(super) fn half_segment_change(&self) -> f64 {
        self.angular_speed / 16.0
    }

    /// Orientation error by a delay of χ alone, in half periods.
    pub(super) fn error_of_delay(&self, delay: f64) -> f64 {
        (self.angular_speed + self.twice_residual_rate) * delay
    }
}

//! Greatest speeds of the tabulated motion, which multiply a delay or an error of the nutation phase.

use crate::law::series::larger_or_nan;
use crate::scalar::Float;

/// Upper bounds over all segments on the speeds of α and β without their mean rotation. They are sums of the
/// magnitudes of coefficients, so they hold at every point of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Speeds<F = f64> {
    /// Greatest angular velocity 2 √(|dα/dt|² + |dβ/dt|²), in rad per half period.
    pub(crate) sweep: F,
    /// Twice the greatest rate of θ_A or θ_B, in rad per half period.
    pub(crate) turning: F,
    /// Greatest change of the orientation on half a segment, 2 √(|dα/dx|² + |dβ/dx|²), rad.
    pub(crate) steepness: F,
    /// Greatest acceleration 2 √(|d²α/dt²|² + |d²β/dt²|²), in rad per half period squared.
    pub(crate) acceleration: F,
    /// Greatest change of the angular velocity on half a segment, in rad per half period.
    pub(crate) velocity_change: F,
    /// Truncation error of the angular velocity 2 √(|dα/dt|² + |dβ/dt|²), in rad per half period.
    pub(crate) sweep_error: F,
    /// Greatest rate dx/dt of the local coordinate, per half period.
    pub(crate) x_rate: F,
}

/// Derivatives with respect to x on one segment, each as 2 √(|α|² + |β|²).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SegmentSpeeds {
    /// First derivative.
    pub(crate) slope: f32,
    /// Truncation error of the first derivative.
    pub(crate) slope_error: f32,
    /// Second derivative.
    pub(crate) curvature: f32,
}

impl<F: Float> Speeds<F> {
    pub(crate) const ZERO: Self = Self {
        sweep: F::ZERO,
        turning: F::ZERO,
        steepness: F::ZERO,
        acceleration: F::ZERO,
        velocity_change: F::ZERO,
        sweep_error: F::ZERO,
        x_rate: F::ZERO,
    };
}

impl Speeds<f32> {
    /// Includes a segment whose half length is the fraction `part` of half a period, with its speeds and dθ/dx.
    pub(crate) fn note(&mut self, speeds: SegmentSpeeds, theta_slope: f32, part: f32) {
        let SegmentSpeeds { slope, slope_error, curvature } = speeds;
        let x_rate = 1.0 / part;
        *self = Self {
            sweep: larger_or_nan(self.sweep, slope * x_rate),
            turning: larger_or_nan(self.turning, 2.0 * theta_slope * x_rate),
            steepness: larger_or_nan(self.steepness, slope),
            acceleration: larger_or_nan(self.acceleration, curvature * x_rate * x_rate),
            velocity_change: larger_or_nan(self.velocity_change, curvature * x_rate),
            sweep_error: larger_or_nan(self.sweep_error, slope_error * x_rate),
            x_rate: larger_or_nan(self.x_rate, x_rate),
        };
    }

    pub(crate) fn to_f64(self) -> Speeds {
        Speeds {
            sweep: self.sweep.into(),
            turning: self.turning.into(),
            steepness: self.steepness.into(),
            acceleration: self.acceleration.into(),
            velocity_change: self.velocity_change.into(),
            sweep_error: self.sweep_error.into(),
            x_rate: self.x_rate.into(),
        }
    }
}

impl Speeds {
    /// Orientation error, rad, if χ alone is delayed by a fraction `share` of half a period. α and β are delayed with
    /// it; θ, which was correct for the undelayed χ, has an error of at most its greatest rate times the delay.
    pub(crate) fn delay(&self, share: f64) -> f64 {
        (self.sweep + self.turning) * share
    }

    /// Orientation error, rad, caused by `remainder`: the sum of the errors of θ, and of the errors of χ multiplied by
    /// the quotient of `fastest` and the local rate of χ, both rates per half period.
    pub(crate) fn truncation_error(&self, remainder: f64, fastest: f64) -> f64 {
        self.delay(remainder / fastest) + 2.0 * remainder
    }
}

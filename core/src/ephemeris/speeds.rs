//! Greatest speeds of the tabulated motion, which multiply a delay or an error of the nutation phase.

use crate::law::series::{TERMS, UNIT, larger_or_nan};

/// Upper bounds over all segments on the speeds of α and β without their mean rotation. They are sums of the
/// magnitudes of coefficients, so they hold at every point of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Speeds {
    /// Greatest angular velocity 2 √(|dα/dt|² + |dβ/dt|²), in rad per half period.
    pub(crate) sweep: f64,
    /// Twice the greatest rate of θ_A or θ_B, in rad per half period.
    pub(crate) turning: f64,
    /// Greatest change on half a segment, 2 √(|dα/dx|² + |dβ/dx|²), rad.
    pub(crate) steepness: f64,
}

impl Speeds {
    pub(crate) const ZERO: Self = Self { sweep: 0.0, turning: 0.0, steepness: 0.0 };

    /// Includes a segment whose half length is the fraction `part` of half a period: 2 √(|dα/dx|² + |dβ/dx|²) and
    /// dθ/dx on it.
    pub(crate) fn note(&mut self, slope: f64, theta_slope: f64, part: f64) {
        *self = Self {
            sweep: larger_or_nan(self.sweep, slope / part),
            turning: larger_or_nan(self.turning, 2.0 * theta_slope / part),
            steepness: larger_or_nan(self.steepness, slope),
        };
    }

    /// Orientation error, rad, if χ alone is delayed by a fraction `share` of half a period. α and β are delayed with
    /// it; θ, which was correct for the undelayed χ, has an error of at most its greatest rate times the delay.
    pub(crate) fn delay(&self, share: f64) -> f64 {
        (self.sweep + self.turning) * share
    }

    /// Orientation error, rad, of a `remainder` that is the sum of the errors of θ and of the errors of χ multiplied
    /// by `fastest` over the local rate of χ, both rates per half period.
    pub(crate) fn left_out(&self, remainder: f64, fastest: f64) -> f64 {
        self.delay(remainder / fastest) + 2.0 * remainder
    }
}

/// Upper bound on [-1, 1] of the derivative of a polynomial, lowest power first, in units of 2^-56.
pub(crate) fn greatest_slope(part: &[i64; TERMS]) -> f64 {
    // sixteen products of at most fifteen and a coefficient below 2^60 need four bits more than i64 has
    let sum = part.iter().zip(0_i64..).fold(0, |sum, (c, power)| sum + power * ((c.abs() >> 8) + 1));
    sum as f64 * (256.0 * UNIT)
}

//! Errors of a table: those allowed to its parts, and what the bounds on its errors follow from.

use crate::scalar::{Float, Ring, Scalar};
use crate::table::evaluation::{LEAST_DEPTH, TABLE_UNIT};

/// Larger of two numbers, or NaN if one of them is NaN.
pub(super) fn larger_or_nan<F: Float>(a: F, b: F) -> F {
    if b <= a || a.partial_cmp(&a).is_none() { a } else { b }
}

/// Share of the allowed error: all steps.
const STEPS_SHARE: f64 = 0.125;
/// Share of a polynomial's allowed error: terms dropped before the last halving.
const DROPPED_SHARE: f32 = 1.0 / 512.0;
/// Share of a polynomial's allowed error: terms beyond the sixteenth.
pub(super) const REMAINDER_SHARE: f32 = 1.0 / 32.0;
/// Share of a polynomial's allowed error: a segment of two cells, whose derivative is less accurate.
const TWO_CELLS_SHARE: f32 = 0.125;
/// Share of the allowed error: a negligible term.
const NEGLIGIBLE_SHARE: f64 = 1.0 / 256.0;

/// Limits that a set-up keeps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Number of terms of a polynomial in the table.
    pub(super) terms: usize,
    /// Number of segments.
    pub(super) capacity: usize,
    /// Truncation error of all steps along half a period, rad.
    pub(super) steps: f64,
    /// Truncation error of a polynomial, in units of 2^-62 rad.
    pub(super) polynomial: f32,
    /// Sum of the terms that are dropped before the last halving, in units of 2^-62.
    pub(super) dropped_terms: i64,
    /// Negligible term of a and b, rad.
    pub(super) negligible: f64,
}

impl Limits {
    pub(super) const ZERO: Self =
        Self { terms: 0, capacity: 0, steps: 0.0, polynomial: 0.0, dropped_terms: 0, negligible: 0.0 };

    /// Limits for a truncation error, rad, with series at least as accurate as for the `usual` one.
    pub(super) fn new(terms: usize, allowed: f64, usual: f64, capacity: usize) -> Self {
        let polynomial =
            |error: f64| (((1.0 - STEPS_SHARE) * error / TABLE_UNIT) as f32).clamp(f32::MIN, f32::MAX);
        let of_series = allowed.min(usual);
        Self {
            terms,
            capacity,
            steps: STEPS_SHARE * allowed,
            polynomial: polynomial(allowed),
            dropped_terms: (DROPPED_SHARE * polynomial(of_series)) as i64,
            negligible: NEGLIGIBLE_SHARE * of_series,
        }
    }

    /// Truncation error of a segment of this depth, in units of 2^-62 rad.
    pub(super) fn segment_error(&self, depth: u32) -> f32 {
        if depth == LEAST_DEPTH { TWO_CELLS_SHARE * self.polynomial } else { self.polynomial }
    }

    /// Negligible term in units of 2^-62.
    pub(super) fn negligible_term(&self) -> i64 {
        (self.negligible / TABLE_UNIT) as i64
    }
}

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
        larger_or_nan(2.0 * Float::sqrt(self.truncation_squared), self.stored)
    }
}

/// One turn in rad.
pub(super) const TURN: f64 = 2.0 * core::f64::consts::PI;
/// Number of standard deviations in a bound.
pub(super) const DEVIATIONS: f64 = 6.0;
/// Variance of the roundings that do not depend on the motion, in (2^-53 rad)².
const FIXED_VARIANCE: f64 = 12.0;
/// Relative errors of the `f64` nearest to 1/2π and of two phases of 64 bits, in units of 2^-53.
const PER_TURN: f64 = 0.56 + 1.0 / 512.0;
/// Standard deviation of a step's rounding, relative to its terms, in units of 2^-53.
const STEP: f64 = 2.1;

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
        let include = |greatest: &mut f64, speed: f32| *greatest = larger_or_nan(*greatest, speed.into());
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

    /// Orientation error, rad, of all roundings in `f64`.
    ///
    /// * `delays`, `angles`: sums of the squares of the steps' terms of χ, as delays in half periods, and of the residual phases, rad
    /// * `start`: delay by a rounding of χ at t = 0, in half periods
    pub(super) fn rounding(&self, [delays, angles]: [f64; 2], start: f64) -> f64 {
        let Self { angular_speed: angular, twice_residual_rate: residual, .. } = *self;
        let steps = STEP * STEP * (delays * (angular * angular + residual * residual) + 4.0 * angles);
        // of the half phase at the launch, and of the coefficients after the first
        let others = self.error_of_delay(start).squared() + self.half_segment_change().squared();
        let deviation = Float::sqrt(FIXED_VARIANCE + steps + others);
        (DEVIATIONS * deviation + PER_TURN * (angular + TURN)) * f64::ROUNDING
    }
}

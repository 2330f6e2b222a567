//! Limits of the errors and of the size of a table.

use crate::table::evaluation::LEAST_DEPTH;
use crate::table::evaluation::TABLE_UNIT;

/// Limits that a set-up keeps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    pub(super) coefficients: usize,
    pub(super) capacity: usize,
    /// Truncation error of all steps along half a period, rad.
    pub(super) steps: f64,
    /// Truncation error of a polynomial, in units of 2^-62 rad.
    pub(super) polynomial: f32,
    /// Sum of the terms that are dropped before the last halving, in units of 2^-62.
    pub(super) dropped: i64,
    /// Negligible term of α and β, rad.
    pub(super) negligible: f64,
}

/// Part of the allowed error for the steps.
const STEPS_PART: f64 = 0.125;
/// Part of a polynomial's allowed error for terms dropped before the last halving.
const DROPPED_PART: f32 = 1.0 / 512.0;
/// Part for terms beyond the sixteenth.
pub(super) const REMAINDER_PART: f32 = 1.0 / 32.0;
/// Part for a segment of two cells, whose derivative is less accurate.
const TWO_CELLS_PART: f32 = 0.125;
/// Negligible part of the allowed error.
const NEGLIGIBLE_PART: f64 = 1.0 / 256.0;

impl Limits {
    pub(super) const ZERO: Self =
        Self { coefficients: 0, capacity: 0, steps: 0.0, polynomial: 0.0, dropped: 0, negligible: 0.0 };

    /// Limits for a truncation error, rad, with series at least as accurate as for the `usual` one.
    pub(super) fn new(coefficients: usize, allowed: f64, usual: f64, capacity: usize) -> Self {
        let polynomial =
            |error: f64| (((1.0 - STEPS_PART) * error / TABLE_UNIT) as f32).clamp(f32::MIN, f32::MAX);
        let of_series = allowed.min(usual);
        Self {
            coefficients,
            capacity,
            steps: STEPS_PART * allowed,
            polynomial: polynomial(allowed),
            dropped: (DROPPED_PART * polynomial(of_series)) as i64,
            negligible: NEGLIGIBLE_PART * of_series,
        }
    }

    /// Truncation error of a segment of this depth, in units of 2^-62 rad.
    pub(super) fn segment_error(&self, depth: u32) -> f32 {
        if depth == LEAST_DEPTH { TWO_CELLS_PART * self.polynomial } else { self.polynomial }
    }

    /// Negligible term in units of 2^-62.
    pub(super) fn negligible_term(&self) -> i64 {
        (self.negligible / TABLE_UNIT) as i64
    }
}

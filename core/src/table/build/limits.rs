//! Errors that a set-up allows to the parts of a table.

use crate::table::data::cell::LEAST_DEPTH;
use crate::table::evaluation::{EphemerisScalar, TABLE_UNIT};

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
pub(super) struct Limits {
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
    /// Limits for a truncation error, rad, with series at least as accurate as for that of the scalar.
    pub(super) fn new<R: EphemerisScalar>(allowed: f64, capacity: usize) -> Self {
        let polynomial =
            |error: f64| (((1.0 - STEPS_SHARE) * error / TABLE_UNIT) as f32).clamp(f32::MIN, f32::MAX);
        let of_series = allowed.min(R::TRUNCATION);
        Self {
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

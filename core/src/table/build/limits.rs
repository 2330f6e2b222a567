//! Errors that a set-up allows to the parts of a table.

use crate::table::data::cell::MIN_DEPTH;
use crate::table::evaluation::{EphemerisScalar, TABLE_UNIT};

/// Part of the allowed error for the truncation of all steps along half a period.
const STEPS_SHARE: f64 = 0.125;
/// Part of the allowed error for the terms that are left out of a series, or of a polynomial before its last halving.
const TERMS_SHARE: f32 = 1.0 / 256.0;
/// Part of the allowed error for a segment of two cells, whose derivative is less accurate.
const TWO_CELLS_SHARE: f32 = 0.125;

/// Limits that a set-up keeps.
pub(super) struct Limits {
    /// Number of segments.
    pub(super) capacity: usize,
    /// Truncation error of all steps along half a period, rad.
    pub(super) steps: f64,
    /// Truncation error of a segment, rad.
    pub(super) segment: f32,
    /// Sum of the terms of a and b that are left out, rad.
    pub(super) terms: f64,
}

impl Limits {
    /// Limits for an allowed truncation error, rad. Series keep the scalar's accuracy even if more is allowed.
    pub(super) fn new<R: EphemerisScalar>(allowed: f64, capacity: usize) -> Self {
        Self {
            capacity,
            steps: STEPS_SHARE * allowed,
            // finite, so that the error of an overflow, which is infinite, is refused
            segment: (((1.0 - STEPS_SHARE) * allowed) as f32).min(f32::MAX),
            terms: f64::from(TERMS_SHARE) * allowed.min(R::TRUNCATION),
        }
    }

    /// Truncation error of a segment of this depth, rad.
    pub(super) fn segment_error(&self, depth: u32) -> f32 {
        if depth == MIN_DEPTH { TWO_CELLS_SHARE * self.segment } else { self.segment }
    }

    /// Whether the estimated terms beyond the sixteenth, in units of 2^-62, are few enough.
    pub(super) fn allows_remainder(&self, remainder: f32) -> bool {
        TABLE_UNIT as f32 * remainder <= TERMS_SHARE * self.segment
    }

    /// Sum of the terms that are left out, in units of 2^-62.
    pub(super) fn terms_in_units(&self) -> i64 {
        (self.terms / TABLE_UNIT) as i64
    }
}

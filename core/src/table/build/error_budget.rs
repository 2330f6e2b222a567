//! Error budget: the shares of the allowed truncation error, which [the error bound](crate::error_bound) lists.

use crate::table::data::cell::MIN_DEPTH;
use crate::table::evaluation::TABLE_UNIT;
use crate::table::evaluation::TableScalar;

/// Share of all steps along half a period. The segments have the rest.
const PATH_FRACTION: f64 = 1.0 / 8.0;
/// Share of dropped terms. It costs about one more term.
const TERMS_FRACTION: f32 = 1.0 / 256.0;
/// Part of a segment's share that a segment of two cells may use: its derivative, and with it the energy, is less accurate.
const TWO_CELLS_FRACTION: f32 = 1.0 / 8.0;

/// A term of a rate ends the series if it is below this number times half the length of the span times the allowed error of dropped terms. The
/// integral of such a term over the span is some hundred times smaller.
const LAST_TERM_FACTOR: f64 = 512.0;

/// Allowed errors of the parts of a table.
pub(super) struct ErrorBudget {
    /// Truncation error of all steps along half a period, rad.
    pub(super) path_error: f64,
    /// Truncation error of a segment of at most one cell, rad.
    segment_error: f32,
    /// Error by the dropped terms of a and b, rad.
    dropped_rad: f64,
    /// Error by the dropped terms of a and b, in units of 2^-62.
    pub(super) dropped_q62: i64,
}

impl ErrorBudget {
    /// Budget for an allowed truncation error, rad. Series keep the scalar's accuracy even if more is allowed.
    pub(super) fn new<R: TableScalar>(allowed: f64) -> Self {
        let dropped_rad = f64::from(TERMS_FRACTION) * allowed.min(R::TRUNCATION);
        Self {
            path_error: PATH_FRACTION * allowed,
            // finite, so that the error of an overflow, which is infinite, is refused
            segment_error: (((1.0 - PATH_FRACTION) * allowed) as f32).min(f32::MAX),
            dropped_rad,
            dropped_q62: (dropped_rad / TABLE_UNIT) as i64,
        }
    }

    /// Truncation error of a segment of this depth, rad.
    pub(super) fn segment_error_at(&self, depth: u32) -> f32 {
        if depth == MIN_DEPTH { TWO_CELLS_FRACTION * self.segment_error } else { self.segment_error }
    }

    /// Whether the estimated sum of the terms after the sixteenth is small enough.
    ///
    /// * `tail`: the sum, in units of 2^-62
    pub(super) fn is_negligible_tail(&self, tail: f32) -> bool {
        TABLE_UNIT as f32 * tail <= TERMS_FRACTION * self.segment_error
    }

    /// Magnitude below which a term of a rate at x = 1 ends its series, rad.
    ///
    /// * `half_length`: half of the span, in half periods
    pub(super) fn negligible_term(&self, half_length: f64) -> f64 {
        LAST_TERM_FACTOR * half_length * self.dropped_rad
    }
}

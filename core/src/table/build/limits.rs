//! Limits of the errors and of the size of a table.

use crate::table::scalar::TABLE_UNIT;

/// Limits of the errors and of the size of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Number of coefficients of a polynomial.
    pub(super) terms: usize,
    /// Largest number of segments.
    pub(super) capacity: usize,
    /// Truncation error of all steps, rad.
    pub(super) steps: f64,
    /// Truncation error of a polynomial, in units of 2^-62 rad.
    pub(super) polynomial: f32,
    /// Sum of the terms that may be left out of a span's series, in units of 2^-62.
    pub(super) left_out: i64,
    /// Term of a series that is negligible, rad.
    pub(super) least: f64,
}

/// Part of the allowed error reserved for the steps.
const STEPS: f64 = 0.125;
/// Part of a polynomial's allowed error reserved for terms left out of the series of a span.
const LEFT_OUT: f32 = 1.0 / 512.0;
/// Part reserved for terms beyond the sixteenth.
pub(super) const OMITTED: f32 = 1.0 / 32.0;
/// Part that a segment of two cells may use, because its derivative is less accurate.
const LONG: f32 = 0.125;
/// Negligible part of the allowed error.
const NEGLIGIBLE: f64 = 1.0 / 256.0;

impl Limits {
    /// Limits before a set-up.
    pub(super) const NONE: Self =
        Self { terms: 0, capacity: 0, steps: 0.0, polynomial: 0.0, left_out: 0, least: 0.0 };

    /// Limits for a truncation error `allowed`, rad, with series at least as accurate as for the error `usual`.
    pub(crate) fn new(terms: usize, allowed: f64, usual: f64, capacity: usize) -> Self {
        let polynomial = |error: f64| (((1.0 - STEPS) * error / TABLE_UNIT) as f32).clamp(f32::MIN, f32::MAX);
        let of_series = allowed.min(usual);
        Self {
            terms,
            capacity,
            steps: STEPS * allowed,
            polynomial: polynomial(allowed),
            left_out: (LEFT_OUT * polynomial(of_series)) as i64,
            least: NEGLIGIBLE * of_series,
        }
    }

    /// Truncation error of a segment of this level, in units of 2^-62 rad.
    pub(super) fn segment(&self, level: u32) -> f32 {
        if level == 0 { LONG * self.polynomial } else { self.polynomial }
    }

    /// Negligible term of α and β in units of 2^-62. The terms after two such ones are not larger.
    pub(super) fn least_term(&self) -> i64 {
        (self.least / TABLE_UNIT) as i64
    }
}

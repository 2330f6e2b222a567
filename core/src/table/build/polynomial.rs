//! Polynomials of α and of β in powers of x ∈ [-1, 1], lowest power first.

use crate::table::series::expansion::Polynomial;
use crate::table::series::integers::TERMS;

/// Function that stores a polynomial: index of the segment, 0 for α or 1 for β, coefficients. It returns the errors of the
/// orientation and of the derivative from rounding the coefficients, in units of 2^-62 rad.
///
/// It is a reference, so that set-up is compiled once for all scalars.
pub(crate) type Store<'a> = dyn FnMut(usize, usize, &Polynomial) -> [f32; 2] + 'a;

/// Estimated sum of the omitted terms of a series, in units of 2^-62: its last four terms are continued as a geometric series.
/// The result is infinite where these terms do not decrease.
pub(crate) fn omitted_terms(part: &[i64; TERMS]) -> f32 {
    /// Magnitude below which terms are rounding errors and need not decrease: 3e-17 in units of 2^-62.
    const NEGLIGIBLE: i64 = 138;
    let [.., c12, c13, c14, c15] = part.map(i64::abs);
    // in pairs, because a series may be even or odd
    let (before, last) = (c12 + c13, c14 + c15);
    if last <= NEGLIGIBLE {
        return 0.0;
    }
    let (before, last) = (before as f32, last as f32);
    let ratio = last / before;
    if ratio < 1.0 { last * ratio / (1.0 - ratio) } else { f32::INFINITY }
}

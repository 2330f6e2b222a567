//! Storing of polynomials as the coefficients of a table.

use super::series::MOST_TERMS;
use crate::scalar::{Float, short_float};
use crate::table::evaluation::{Coefficient, EphemerisScalar};

/// Function that stores a polynomial of α (column 0) or β (column 2) in a segment. Its arguments are the segment, the column and the
/// coefficients of both parts; its results are those of [`store_polynomial`].
pub(super) type Store<'a> = dyn FnMut(usize, usize, [&[i64; MOST_TERMS]; 2]) -> [f32; 2] + 'a;

/// Stores a polynomial in two columns of a segment, if the table contains it. Returns the error of the orientation by short products and
/// coefficients out of range, and that of the derivative by rounding, in units of 2^-62 rad.
pub(super) fn store_polynomial<R: EphemerisScalar>(
    segments: &mut [R::Segment],
    segment: usize,
    column: usize,
    parts: [&[i64; MOST_TERMS]; 2],
) -> [f32; 2] {
    let place = segments.get_mut(segment).map_or(&mut [][..], |segment| segment.as_mut());
    let (mut largest, mut slope_squares) = (0.0, 0.0);
    for (column, part) in (column..).zip(parts) {
        let part = part.get(..R::TERMS).unwrap_or(part);
        // Σ k |error of c_k|
        let (mut errors, mut slope_error) = (0_u64, 0_u64);
        for (power, (four, &value)) in place.iter_mut().zip(part).enumerate().rev() {
            if let Some(held) = four.get_mut(column) {
                let (coefficient, error) = R::Coefficient::nearest(value, power);
                *held = coefficient;
                if power > 0 {
                    errors = errors.saturating_add(error.unsigned_abs());
                    slope_error = slope_error.saturating_add(errors);
                }
            }
        }
        let error = R::Coefficient::error(part);
        largest = if error > largest { error } else { largest };
        let slope_error = short_float(slope_error);
        slope_squares += slope_error * slope_error;
    }
    [4.0 * largest, Float::sqrt(slope_squares)]
}

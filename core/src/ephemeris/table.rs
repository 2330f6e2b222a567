//! Table of an ephemeris: the segment of a phase, and the storage of a polynomial.

use crate::ephemeris::EphemerisScalar;
use crate::ephemeris::cell::{CELLS, Cell, PAIR_BITS};
use crate::ephemeris::polynomial::Polynomial;
use crate::scalar::{Float, short_float};
use core::fmt;

/// Segment that contains a phase, and the local coordinate on it.
pub(crate) struct LocatedSegment<'a, R: EphemerisScalar> {
    /// Coefficients, lowest power first.
    pub(crate) terms: &'a [[R::Coefficient; 4]],
    /// Local coordinate x·2^63 with x in [-1, 1).
    pub(crate) x: i64,
    /// Local coordinate times 2^31, from 32 bits of the fraction of the pair of cells: a multiple of 2^level, rounded down.
    pub(crate) short_x: i32,
    /// Index of the segment.
    pub(crate) number: usize,
    /// Number of halvings of the pair of cells.
    pub(crate) level: u32,
}

/// Segment for a fraction of half a period, given as 64 bits.
#[inline(always)]
pub(crate) fn locate<'a, R: EphemerisScalar>(
    cells: &[u16; CELLS],
    segments: &'a [R::Segment],
    share: u64,
) -> LocatedSegment<'a, R> {
    let number = (share >> (u64::BITS - PAIR_BITS - 1)) as usize;
    let cell = Cell::from_bits(cells.get(number).copied().unwrap_or_default());
    let level = cell.level();
    // the fraction of the pair, and its 32 leading bits
    let (share, short) = (share << PAIR_BITS, (share >> (32 - PAIR_BITS)) as u32);
    // the upper `level` bits are the place of the segment in the pair; two shifts, because a shift by 32 is not
    // allowed
    let number = cell.segment(short >> 1 >> (31 - level));
    // no cell refers to a segment beyond the last; the fallback to the first segment avoids a branch for a panic
    let segment = segments.get(number).or(segments.first());
    // the range [0, 1) becomes [-1, 1) by flipping the upper bit
    let (x, short_x) = ((share << level) ^ (1 << 63), (short << level) ^ (1 << 31));
    LocatedSegment {
        terms: segment.map_or(&[], |segment| segment.as_ref()),
        x: x as i64,
        short_x: short_x as i32,
        number,
        level,
    }
}

/// Stores the polynomial of α (`which` = 0) or of β (1) on a segment, if the table contains that segment. Returns the
/// orientation error that short products and coefficients out of range cause, and the error of the derivative that the rounding of its
/// coefficients causes, in units of 2^-62 rad.
pub(crate) fn put<R: EphemerisScalar>(
    segments: &mut [R::Segment],
    segment: usize,
    which: usize,
    polynomial: &Polynomial,
) -> [f32; 2] {
    let place = segments.get_mut(segment).map_or(&mut [][..], |segment| segment.as_mut());
    let (mut largest, mut slope_squares) = (0.0, 0.0);
    for (column, part) in (2 * which..).zip(polynomial) {
        let part = part.get(..R::TERMS).unwrap_or(part);
        // the sum over all powers of the power times the error: each power adds the errors from it on
        let (mut errors, mut slope_error) = (0_u64, 0_u64);
        for (power, (four, &value)) in place.iter_mut().zip(part).enumerate().rev() {
            if let Some(held) = four.get_mut(column) {
                let (coefficient, error) = R::coefficient(value, power);
                *held = coefficient;
                if power > 0 {
                    errors = errors.saturating_add(error.unsigned_abs());
                    slope_error = slope_error.saturating_add(errors);
                }
            }
        }
        let error = R::coefficient_error(part);
        largest = if error > largest { error } else { largest };
        let slope_error = short_float(slope_error);
        slope_squares += slope_error * slope_error;
    }
    [4.0 * largest, Float::sqrt(slope_squares)]
}

/// Error of set-up: the table has too few segments for the allowed truncation error.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TableTooSmall {
    /// Allowed truncation error, rad.
    pub truncation: f64,
    /// Number of segments of the table, which is too small;
    /// [`EphemerisView::segments_needed`](crate::EphemerisView::segments_needed) finds a sufficient number.
    pub segments: u32,
}

impl fmt::Display for TableTooSmall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { truncation, segments } = self;
        write!(f, "a table of {segments} segments cannot follow the motion to within {truncation:.1e} rad")
    }
}

impl core::error::Error for TableTooSmall {}

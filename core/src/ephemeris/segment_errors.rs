//! Errors of one segment, from its two polynomials.

use crate::ephemeris::chebyshev::Chebyshev;
use crate::ephemeris::polynomial::Store;
use crate::ephemeris::speeds::SegmentSpeeds;
use crate::law::series::{TERMS, UNIT, larger_or_nan};
use crate::scalar::Float;

/// Errors and slopes of a segment, from the series of α and β so far, in units of 2^-62. They are in `f32`, because soft
/// arithmetic in `f64` took a third of the time of a polynomial.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SegmentErrors {
    /// Sum of the squares of the truncation errors.
    squares: f32,
    /// Greatest error of the stored coefficients.
    stored: f32,
    /// Sums of the squares of the slopes, of their errors and of the curvatures.
    slopes: [f32; 3],
}

impl SegmentErrors {
    /// Errors before the first polynomial.
    pub(crate) const NONE: Self = Self { squares: 0.0, stored: 0.0, slopes: [0.0; 3] };

    /// Reduces a series to `terms` coefficients, passes their polynomial to `store` as that of a segment and of α (0) or β (1),
    /// and includes its errors: those of the reduction, those that `store` returns, of the value and of the derivative, and
    /// those of the series itself, `beyond`.
    #[inline(never)] // the stack frames of set-up must not add up
    pub(crate) fn shorten(
        &mut self,
        series: &Chebyshev,
        [beyond, slope_beyond]: [f32; 2],
        terms: usize,
        (segment, which): (usize, usize),
        store: &mut Store<'_>,
    ) {
        let bounds = series.bounds(terms);
        let mut polynomial = [[0; TERMS]; 2];
        series.powers(terms, &mut polynomial);
        let [stored, rounded_slope] = store(segment, which, &polynomial);
        let change = bounds.change + beyond;
        let slope_error = bounds.slope_change + slope_beyond + rounded_slope;
        self.squares += change * change;
        self.stored = larger_or_nan(self.stored, stored);
        let each = [bounds.slope_squares, slope_error * slope_error, bounds.curvature_squares];
        self.slopes.iter_mut().zip(each).for_each(|(sum, squares)| *sum += squares);
    }

    /// Truncation and rounding error of the segment, as an orientation error, in units of 2^-62 rad.
    pub(crate) fn error(&self) -> f32 {
        larger_or_nan(2.0 * Float::sqrt(self.squares), self.stored)
    }

    /// Derivatives on the segment.
    pub(crate) fn speeds(&self) -> SegmentSpeeds {
        let [slope, slope_error, curvature] =
            self.slopes.map(|squares| 2.0 * UNIT as f32 * Float::sqrt(squares));
        SegmentSpeeds { slope, slope_error, curvature }
    }
}

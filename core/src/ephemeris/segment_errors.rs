//! Errors of one segment, from its two polynomials.

use crate::ephemeris::economise::economise;
use crate::ephemeris::polynomial::Polynomial;
use crate::ephemeris::speeds::{SegmentSpeeds, greatest_slopes};
use crate::law::series::{UNIT, larger_or_nan};
use crate::scalar::Float;

/// Errors and slopes of a segment, from its polynomials of α and β so far, in units of 2^-62. They are in `f32`, because soft
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

    /// Reduces a polynomial to `terms` coefficients, passes it to `store`, and includes its errors:
    /// those of the reduction, those that `store` returns, of the value and of the derivative, and those of the series itself,
    /// `beyond`.
    pub(crate) fn shorten(
        &mut self,
        polynomial: &mut Polynomial,
        [beyond, slope_beyond]: [f32; 2],
        terms: usize,
        store: impl FnOnce(&Polynomial) -> [f32; 2],
    ) {
        let [dropped, dropped_slope] = economise(polynomial, terms);
        let dropped = dropped + beyond;
        let [[re_slope, re_curvature], [im_slope, im_curvature]] =
            polynomial.parts.each_ref().map(|part| greatest_slopes(part, terms));
        let [stored, rounded_slope] = store(polynomial);
        let slope_error = dropped_slope + slope_beyond + rounded_slope;
        self.squares += dropped * dropped;
        self.stored = larger_or_nan(self.stored, stored);
        let each = [[re_slope, im_slope], [slope_error, 0.0], [re_curvature, im_curvature]];
        self.slopes.iter_mut().zip(each).for_each(|(sum, [x, y])| *sum += x * x + y * y);
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

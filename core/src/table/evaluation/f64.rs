//! Evaluation in `f64`.

use crate::complex::Complex;
use crate::scalar::{Extended, fraction_of_word, sine_cosine_f64};
use crate::table::evaluation::{Coefficient, SegmentPoint, TABLE_UNIT, TableScalar, TickErrors, range};

impl TableScalar for f64 {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 11];
    type Quantity = Self;
    type SetUpFloat = Extended;

    const ROUNDING: f64 = Self::EPSILON / 2.0;
    const CODE: u32 = 64;
    const TERMS: usize = 11;
    const ZERO_SEGMENT: Self::Segment = [[0.0; 4]; 11];
    const ERRORS: TickErrors = TickErrors {
        orientation: 24.0 * Self::ROUNDING,
        coordinate: 0.0,
        omega: 0.0,
        relative_omega: 21.0 * Self::ROUNDING,
    };

    #[inline]
    fn from_component(number: Self) -> Self {
        number
    }

    #[inline]
    fn to_quantity(number: Self) -> Self {
        number
    }

    #[inline(always)]
    fn sine_cosine(phase: u64) -> [f64; 2] {
        sine_cosine_f64(phase).into()
    }
}

impl Coefficient for f64 {
    type Accumulator = Self;
    type Component = Self;

    fn nearest(value: i64, _: usize) -> Self {
        value as f64 * TABLE_UNIT
    }

    fn are_safe(segment: &[[f64; 4]]) -> bool {
        range::are_safe_f64(segment.as_flattened())
    }

    #[inline]
    fn to_sum(self) -> f64 {
        self
    }

    #[inline(always)]
    fn coordinate(point: SegmentPoint) -> f64 {
        2.0 * fraction_of_word(point.x_q63)
    }

    #[inline(always)]
    fn step(self, sum: f64, x: f64) -> f64 {
        sum * x + self
    }

    #[inline(always)]
    fn slope_step(sum: f64, slope: f64, x: f64) -> f64 {
        slope * x + sum
    }

    #[inline(always)]
    fn rotated([re, im]: [f64; 2], is_falling: bool, [sine, cosine]: [f64; 2]) -> Complex<f64> {
        Complex::new(re, if is_falling { -im } else { im }) * Complex::new(cosine, sine)
    }
}

//! Evaluation in `f64`.

use crate::complex::Complex;
use crate::scalar::{Extended, Scalar, fraction_of_word, sine_cosine_f64};
use crate::su2::Vector;
use crate::table::evaluation::{
    Coefficient, SegmentPoint, TABLE_UNIT, TableScalar, TickErrors, TickNumber, range,
};

impl TableScalar for f64 {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 11];
    type Quantity = Self;
    type PeriodNumber = Extended;
    type PathNumber = Extended;

    const CODE: u32 = 64;
    const TERMS: usize = 11;
    const ZERO_SEGMENT: Self::Segment = [[0.0; 4]; 11];
    const ERRORS: TickErrors = TickErrors {
        orientation: 24.0 * <Self as Scalar>::ROUNDING,
        coordinate: 0.0,
        omega: 0.0,
        relative_omega: 11.0 * <Self as Scalar>::ROUNDING,
    };

    #[inline]
    fn from_number(number: Self) -> Self {
        number
    }

    #[inline(always)]
    fn sine_cosine_sums(phase: u64) -> [f64; 2] {
        sine_cosine_f64(phase).into()
    }
}

impl Coefficient for f64 {
    type Sum = Self;
    type Number = Self;

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

    #[inline(always)]
    fn sine_cosine_of_difference([[sine_a, cosine_a], [sine_b, cosine_b]]: [[f64; 2]; 2]) -> [f64; 2] {
        let difference = Complex::new(cosine_a, sine_a).conj() * Complex::new(cosine_b, sine_b);
        [difference.im, difference.re]
    }
}

impl TickNumber for f64 {
    type Sum = Self;
    type Quantity = Self;

    #[inline]
    fn to_quantity(self, _: i32) -> Self {
        self
    }

    #[inline(always)]
    fn omega_body(
        polynomials: [[f64; 4]; 2],
        [sine, cosine]: [f64; 2],
        point: SegmentPoint,
        [x, mean, axial]: [f64; 3],
    ) -> (Vector<f64>, i32) {
        let pair = |[re_a, im_a, re_b, im_b]: [f64; 4]| [Complex::new(re_a, im_a), Complex::new(re_b, im_b)];
        let [[a, b], [a_slope, b_slope]] = polynomials.map(pair);
        let x = x * Self::from(1_u16 << point.halvings);
        let change = (a.conj() * b_slope - b * a_slope.conj()).scaled(x);
        let n = change + (a.conj() * b).times_i().scaled(mean);
        let n = if point.is_falling { -n.conj() } else { n } * Complex::new(cosine, sine);
        ([2.0 * n.im, -2.0 * n.re, axial], 0)
    }
}

//! Evaluation in `f64`.

use crate::complex::Complex;
use crate::scalar::{Scalar, fraction_of_word, sine_cosine_f64};
use crate::su2::Vector;
use crate::table::scalar::{Coefficient, EphemerisScalar, EvaluationErrors, SegmentPoint, TABLE_UNIT};

impl EphemerisScalar for f64 {
    type Coefficient = Self;
    type Segment = [[Self; 4]; 11];
    type Quantity = Self;

    const TERMS: usize = 11;
    const RATE_WORDS: usize = 2;
    const ZERO_SEGMENT: Self::Segment = [[0.0; 4]; 11];
    const CODE: u32 = 64;
    /// The random roundings of a tick are counted with those of set-up. Those of the rotation of the angular velocity are five standard
    /// deviations of one rounding.
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: 0.0,
        slope: 0.0,
        rate: 0.0,
        relative_rate: 5.0 * <Self as Scalar>::ROUNDING,
    };

    #[inline]
    fn rounded(number: Self) -> Self {
        number
    }
}

impl Coefficient for f64 {
    type Sum = Self;
    type Number = Self;
    type Quantity = Self;

    fn nearest(value: i64, _: usize) -> (Self, i64) {
        let nearest = value as f64;
        (nearest * TABLE_UNIT, (nearest as i64).saturating_sub(value))
    }

    fn error(_: &[i64]) -> f32 {
        0.0
    }

    fn value(self, _: usize) -> f64 {
        self
    }

    #[inline(always)]
    fn coordinate(point: SegmentPoint) -> f64 {
        2.0 * fraction_of_word(point.x)
    }

    #[inline]
    fn sum(self) -> f64 {
        self
    }

    #[inline]
    fn slope(sum: f64) -> f64 {
        sum
    }

    #[inline(always)]
    fn step(added: f64, sum: f64, x: f64, _: bool) -> f64 {
        sum * x + added
    }

    #[inline(always)]
    fn last_step(constant: f64, sum: f64, x: f64) -> f64 {
        sum * x + constant
    }

    #[inline(always)]
    fn sine_cosine(phase: u64, _: usize) -> [f64; 2] {
        sine_cosine_f64(phase).into()
    }

    #[inline(always)]
    fn rotated([re, im]: [f64; 2], mirrored: bool, [sine, cosine]: [f64; 2]) -> Complex<f64> {
        Complex::new(re, if mirrored { -im } else { im }) * Complex::new(cosine, sine)
    }

    #[inline(always)]
    fn omega_body(
        polynomials: [[f64; 4]; 2],
        turns: [[f64; 2]; 2],
        point: SegmentPoint,
        [x, mean, axial]: [f64; 3],
    ) -> (Vector<f64>, i32) {
        let [turn_a, turn_b] = turns.map(|[sine, cosine]| Complex::new(cosine, sine));
        let pair = |[re_a, im_a, re_b, im_b]: [f64; 4]| [Complex::new(re_a, im_a), Complex::new(re_b, im_b)];
        let [[a, b], [a_slope, b_slope]] = polynomials.map(pair);
        let x = x * Self::from(1_u16 << point.level);
        let change = (a.conj() * b_slope - b * a_slope.conj()).scaled(x);
        let n = change + (a.conj() * b).times_i().scaled(mean);
        let n = if point.mirrored { -n.conj() } else { n } * (turn_a.conj() * turn_b);
        ([2.0 * n.im, -2.0 * n.re, axial], 0)
    }

    #[inline]
    fn rate(number: Self, _: i32) -> Self {
        number
    }
}

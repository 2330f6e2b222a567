//! Evaluation with coefficients of 16 bits: c·2^(15+k) for x^k. Factors have 16 bits, so that a product is one instruction on the smallest chip.

use crate::complex::Complex;
use crate::scalar::{Q30, sine_cosine_q15};
use crate::table::evaluation::{Coefficient, SegmentPoint, TickScalar};
use fixed::types::I2F14;

impl TickScalar for I2F14 {
    type Number = Q30;
    type Coefficient = i16;
    type Segment = [[i16; 4]; 3];
    type Quantity = f32;

    const TERMS: usize = 3;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 3];
    const CODE: u32 = 15;

    #[inline]
    fn from_number(number: Q30) -> Self {
        Self::from_bits((number.0 >> 16) as i16)
    }

    #[inline(always)]
    fn sine_cosine_sums(phase: u64) -> [i32; 2] {
        let (sine, cosine) = sine_cosine_q15((phase >> 32) as u32);
        [sine >> 15, cosine >> 15]
    }
}

impl Coefficient for i16 {
    type Sum = i32;
    type Number = Q30;

    #[inline]
    fn to_sum(self) -> i32 {
        i32::from(self) << 16
    }

    #[inline]
    fn coordinate(point: SegmentPoint) -> i32 {
        ((point.x_q31 >> 15) + 1) >> 1
    }

    #[inline(always)]
    fn step(self, sum: i32, x: i32, _: bool) -> i32 {
        self.to_sum() + (sum >> 16) * x
    }

    /// Value plus half a unit of 2^-15, so that the shift in a rotation rounds.
    #[inline(always)]
    fn last_step(self, sum: i32, x: i32) -> i32 {
        (self.to_sum() + (1 << 15)).saturating_add((sum >> 16) * x)
    }

    #[inline(always)]
    fn slope_step(sum: i32, slope: i32, x: i32, _: bool) -> i32 {
        (sum >> 1) + (slope >> 16) * x
    }

    /// Result rounded to 2^-14.
    #[inline(always)]
    fn rotated([re, im]: [i32; 2], is_falling: bool, [sine, cosine]: [i32; 2]) -> Complex<Q30> {
        let [re, im] = [re, im ^ -i32::from(is_falling)].map(|part| part >> 16);
        let rounded = |part: i32| Q30((part + (1 << 15)) >> 16 << 16);
        Complex::new(rounded(re * cosine - im * sine), rounded(re * sine + im * cosine))
    }

    #[inline(always)]
    fn sine_cosine_of_difference([[sine_a, cosine_a], [sine_b, cosine_b]]: [[i32; 2]; 2]) -> [i32; 2] {
        [cosine_a * sine_b - sine_a * cosine_b, cosine_a * cosine_b + sine_a * sine_b]
    }
}

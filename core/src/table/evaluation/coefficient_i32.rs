//! Evaluation in integers of 32 bits. Sums are in units of 2^-31.
//!
//! A coefficient of x^k is stored as c·2^(31+k). The upper word of its product with x·2^31 has half the scale, which is that of the next lower
//! coefficient. The sums for a derivative have half the scale, because they may be twice as large. Set-up refuses sums that could overflow; the
//! last one saturates.
//!
//! For the upper half of the powers 16 bits of x are enough: their coefficients are small, as set-up verifies.

use crate::complex::Complex;
use crate::integer::{high_product, high_product_limited, product_32x16};
use crate::scalar::{Q30, sine_cosine_q26};
use crate::table::evaluation::{Coefficient, SegmentPoint, TickNumber, TickScalar};
#[cfg(feature = "fixed")]
use {crate::scalar::sine_cosine_q31, fixed::types::I2F30};

impl TickScalar for f32 {
    type Number = Q30;
    type Coefficient = i32;
    type Segment = [[i32; 4]; 5];
    type Quantity = Self;

    const TERMS: usize = 5;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 5];
    const CODE: u32 = 32;

    #[inline]
    fn from_number(number: Q30) -> Self {
        number.ldexp(0)
    }

    #[inline(always)]
    fn sine_cosine_sums(phase: u64) -> [i32; 2] {
        sine_cosine_q26((phase >> 32) as u32).into()
    }
}

#[cfg(feature = "fixed")]
impl TickScalar for I2F30 {
    type Number = Q30;
    type Coefficient = i32;
    type Segment = [[i32; 4]; 4];
    type Quantity = f32;

    const TERMS: usize = 4;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 4];
    const CODE: u32 = 31;

    #[inline]
    fn from_number(number: Q30) -> Self {
        Self::from_bits(number.0)
    }

    #[inline(always)]
    fn sine_cosine_sums(phase: u64) -> [i32; 2] {
        sine_cosine_q31((phase >> 32) as u32).into()
    }
}

impl Coefficient for i32 {
    type Sum = Self;
    type Number = Q30;

    #[inline]
    fn to_sum(self) -> i32 {
        self
    }

    #[inline]
    fn coordinate(point: SegmentPoint) -> i32 {
        point.x_q31
    }

    #[inline(always)]
    fn step(self, sum: i32, x: i32, by_16_bits: bool) -> i32 {
        self + if by_16_bits { product_32x16(sum, x) } else { high_product_limited(sum, x) }
    }

    #[inline(always)]
    fn last_step(self, sum: i32, x: i32) -> i32 {
        self.saturating_add(high_product_limited(sum, x))
    }

    #[inline(always)]
    fn slope_step(sum: i32, slope: i32, x: i32, by_16_bits: bool) -> i32 {
        (sum >> 1).step(slope, x, by_16_bits)
    }

    #[inline(always)]
    fn rotated([re, im]: [i32; 2], is_falling: bool, [sine, cosine]: [i32; 2]) -> Complex<Q30> {
        let im = im ^ -i32::from(is_falling);
        Complex::new(
            Q30(high_product(!im, sine) + high_product(re, cosine)),
            Q30(high_product(im, cosine) + high_product(re, sine)),
        )
    }

    #[inline(always)]
    fn sine_cosine_of_difference([[sine_a, cosine_a], [sine_b, cosine_b]]: [[i32; 2]; 2]) -> [i32; 2] {
        [
            high_product(cosine_a, sine_b) - high_product(sine_a, cosine_b),
            high_product(cosine_a, cosine_b) + high_product(sine_a, sine_b),
        ]
    }
}

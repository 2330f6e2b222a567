//! Evaluation with coefficients of 16 bits: c·2^(15+k) for x^k. Factors have 16 bits, so that a product is one instruction on the smallest chip.

use crate::complex::Complex;
use crate::integer::shifted_right;
use crate::scalar::{Q14, Q30, Wide, coarse_sine_cosine_q30};
use crate::table::evaluation::i32::{COORDINATE_ERROR, ERRORS_Q30};
use crate::table::evaluation::{Coefficient, SegmentPoint, TABLE_BITS, TableScalar, TickErrors, range};
use fixed::{Wrapping, types::I2F14};

/// Unit of the sums, 2^-15.
const UNIT_Q15: f64 = 1.0 / (1_u64 << 15) as f64;

impl TableScalar for I2F14 {
    type Coefficient = i16;
    type Segment = [[i16; 4]; 3];
    type Quantity = f32;
    type SetUpFloat = Wide<1>;

    const ROUNDING: f64 = 0.5 / (1_u64 << 14) as f64;
    const CODE: u32 = 15;
    const TERMS: usize = 3;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 3];
    const ERRORS: TickErrors = TickErrors {
        orientation: 16.83 * UNIT_Q15 + 2.6e-5,
        coordinate: 0.5 * UNIT_Q15 + COORDINATE_ERROR,
        omega: 4.4 * UNIT_Q15,
        ..ERRORS_Q30
    };

    #[inline]
    fn from_component(Wrapping(number): Q14) -> Self {
        number
    }

    #[inline(always)]
    fn to_quantity(Wrapping(number): Q14) -> f32 {
        number.into()
    }

    #[inline(always)]
    fn sine_cosine(phase: u64) -> [i32; 2] {
        let (sine, cosine) = coarse_sine_cosine_q30((phase >> 32) as u32);
        [sine >> 15, cosine >> 15]
    }

    /// Result from all 32 bits of the number.
    #[inline(always)]
    fn rotated_quantity([re, im]: [i32; 2], is_falling: bool, sine_cosine: [i32; 2]) -> Complex<f32> {
        let [re, im] = [re, im ^ -i32::from(is_falling)].map(|part| Q30(part >> 1).into());
        let [sine, cosine] = sine_cosine.map(|part| Q30(part << 15).into());
        Complex::new(re, im) * Complex::new(cosine, sine)
    }
}

impl Coefficient for i16 {
    type Accumulator = i32;
    type Component = Q14;

    fn nearest(value: i64, power: usize) -> Self {
        /// Factor 1 - 9.4e-6 of the coefficients, in units of 2^-30. The 16-bit sines are up to 1.9e-5 too large; this halves the error.
        const SHRINK: i64 = (1 << 30) - 10093;
        // 2^-30 of the value's unit is far below the rounding
        let rounded = shifted_right((value >> 30) * SHRINK, TABLE_BITS - 15 - power as u32);
        if power == 0 {
            return rounded.clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        }
        rounded.try_into().unwrap_or(i16::MIN)
    }

    fn are_safe(segment: &[[i16; 4]]) -> bool {
        range::are_safe_i16(segment.as_flattened())
    }

    #[inline]
    fn to_sum(self) -> i32 {
        i32::from(self) << 16
    }

    #[inline]
    fn coordinate(point: SegmentPoint) -> i32 {
        ((point.x_q31 >> 15) + 1) >> 1
    }

    #[inline(always)]
    fn step(self, sum: i32, x: i32) -> i32 {
        self.to_sum() + (sum >> 16) * x
    }

    /// Value plus half a unit of 2^-15, so that the shift in a rotation rounds.
    #[inline(always)]
    fn last_step(self, sum: i32, x: i32) -> i32 {
        (self.to_sum() + (1 << 15)).saturating_add((sum >> 16) * x)
    }

    #[inline(always)]
    fn slope_step(sum: i32, slope: i32, x: i32) -> i32 {
        (sum >> 1) + (slope >> 16) * x
    }

    /// Result rounded to 2^-14.
    #[inline(always)]
    fn rotated([re, im]: [i32; 2], is_falling: bool, [sine, cosine]: [i32; 2]) -> Complex<Q14> {
        let [re, im] = [re, im ^ -i32::from(is_falling)].map(|part| part >> 16);
        let rounded = |part: i32| Wrapping(I2F14::from_bits(((part + (1 << 15)) >> 16) as i16));
        Complex::new(rounded(re * cosine - im * sine), rounded(re * sine + im * cosine))
    }
}

//! Evaluation in integers with coefficients of 16 bits. Both factors of every product have 16 bits, so that a product is one instruction on
//! the smallest chip.

use crate::complex::Complex;
use crate::scalar::{sine_cosine_q15, times_power_of_two};
use crate::su2::Vector;
use crate::table::scalar::integer::{COORDINATE_ERROR, ERRORS, overflow_limit, short_factors};
use crate::table::scalar::integer_rates::omega_body;
use crate::table::scalar::q30::Q30;
use crate::table::scalar::{Coefficient, EphemerisScalar, EvaluationErrors, SegmentPoint, TABLE_BITS};
use fixed::types::I2F14;

/// Unit of the sums in 16 bits, 2^-15.
const SHORT_UNIT: f64 = 1.0 / (1_u64 << 15) as f64;
/// Least sum in 16 bits that could overflow, with a margin of about thirty roundings of a coefficient.
const SHORT_OVERFLOW: i64 = overflow_limit(1e-3);
/// Factor 1 - 9.4e-6 of the coefficients of 16 bits, in units of 2^-30. It halves the error of their sines, which are up to 1.9e-5 too large.
const SHRINK: i64 = (1 << 30) - 10093;

impl EphemerisScalar for I2F14 {
    type Coefficient = i16;
    type Segment = [[i16; 4]; 3];
    type Quantity = f32;

    const TERMS: usize = 3;
    const ZERO_SEGMENT: Self::Segment = [[0; 4]; 3];
    const CODE: u32 = 15;
    const ERRORS: EvaluationErrors = EvaluationErrors {
        tick: 16.83 * SHORT_UNIT + 2.6e-5,
        slope: 0.5 * SHORT_UNIT + COORDINATE_ERROR,
        rate: 2.001 * SHORT_UNIT,
        ..ERRORS
    };

    #[inline]
    fn rounded(number: Q30) -> Self {
        Self::from_bits((number.0 >> 16) as i16)
    }
}

impl Coefficient for i16 {
    type Sum = i32;
    type Number = Q30;
    type Quantity = f32;

    fn nearest(value: i64, power: usize) -> (Self, i64) {
        let dropped = TABLE_BITS - 15 - power as u32;
        // 2^-30 of the value's unit is far below the rounding
        let shrunk = (value >> 30) * SHRINK;
        let rounded = (shrunk >> (dropped - 1)).saturating_add(1) >> 1;
        let held = rounded.clamp(i16::MIN.into(), i16::MAX.into());
        (held as i16, (held << dropped).saturating_sub(value))
    }

    fn error(polynomial: &[i64]) -> f32 {
        short_factors(polynomial, SHORT_OVERFLOW).map_or(f32::INFINITY, |_| 0.0)
    }

    fn value(self, power: usize) -> f64 {
        times_power_of_two(self.into(), -15 - power as i32)
    }

    #[inline]
    fn coordinate(point: SegmentPoint) -> i32 {
        ((point.short_x >> 15) + 1) >> 1
    }

    #[inline]
    fn sum(self) -> i32 {
        i32::from(self) << 16
    }

    #[inline]
    fn slope(sum: i32) -> i32 {
        sum >> 1
    }

    #[inline(always)]
    fn step(added: i32, sum: i32, x: i32, _: bool) -> i32 {
        added + (sum >> 16) * x
    }

    /// Value with half the weight of the last bit that a rotation uses.
    #[inline(always)]
    fn last_step(constant: Self, sum: i32, x: i32) -> i32 {
        (constant.sum() + (1 << 15)).saturating_add((sum >> 16) * x)
    }

    #[inline(always)]
    fn sine_cosine(phase: u64, _: usize) -> [i32; 2] {
        let (sine, cosine) = sine_cosine_q15((phase >> 32) as u32);
        [sine >> 15, cosine >> 15]
    }

    /// Result rounded to 2^-14.
    #[inline(always)]
    fn rotated([re, im]: [i32; 2], mirrored: bool, [sine, cosine]: [i32; 2]) -> Complex<Q30> {
        let [re, im] = [re, im ^ -i32::from(mirrored)].map(|part| part >> 16);
        let rounded = |part: i32| Q30((part + (1 << 15)) >> 16 << 16);
        Complex::new(rounded(re * cosine - im * sine), rounded(re * sine + im * cosine))
    }

    #[inline(always)]
    fn omega_body(
        polynomials: [[i32; 4]; 2],
        [[sine_a, cosine_a], [sine_b, cosine_b]]: [[i32; 2]; 2],
        point: SegmentPoint,
        rates: [f32; 3],
    ) -> (Vector<Q30>, i32) {
        let difference = [cosine_a * cosine_b + sine_a * sine_b, cosine_a * sine_b - sine_a * cosine_b];
        omega_body(polynomials, point.mirrored, difference, point.level, rates)
    }

    #[inline]
    fn rate(number: Q30, exponent: i32) -> f32 {
        number.times_power_of_two(exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::scalar::integer::tests::polynomial;

    #[test]
    fn sums_stay_below_their_powers_by_a_margin() {
        assert_eq!(i16::error(&polynomial([0.9, 0.4994, 0.0])), 0.0);
        assert_eq!(i16::error(&polynomial([0.9, 0.4996, 0.0])), f32::INFINITY);
        assert_eq!(i16::error(&polynomial([0.9, 0.2, -0.2499, 0.0])), f32::INFINITY);
    }
}

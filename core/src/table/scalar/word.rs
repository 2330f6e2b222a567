//! Integers of 32 and of 16 bits as coefficients: their rounding, their products, and their rotations.
//!
//! A coefficient of x^k is stored as c·2^(31+k) (in 16 bits as c·2^(15+k)). The upper word of its product with x·2^31 has half the scale,
//! that of the next lower coefficient. Set-up refuses segments in which a sum could overflow; the last sum saturates.
//!
//! For the powers above half the number of terms, 16 bits of x are enough, because their coefficients are small: set-up verifies it.

use crate::product::{high_product, high_product_of_less, short_product};
#[cfg(feature = "fixed")]
use crate::scalar::sine_cosine_q15;
use crate::scalar::{sine_cosine_q26, sine_cosine_q31};
use core::fmt::Debug;

/// Width of the factors of the products. Sums have 32 bits, in units of 2^-31.
pub trait Word: Copy + Debug + PartialEq {
    /// Half the weight of the last bit that a rotation uses of a sum.
    const HALF: i32;
    /// See [`Coefficient::nearest`](super::Coefficient::nearest).
    fn nearest(value: i64, power: usize) -> (Self, i64);
    /// See [`Coefficient::error`](super::Coefficient::error).
    fn error(polynomial: &[i64]) -> f32;
    /// Coefficient as a sum.
    fn sum(self) -> i32;
    /// Factor for the local coordinate, from the latter times 2^31.
    fn coordinate(x: i32) -> i32;
    /// Product of a sum and the local coordinate, of which 16 bits are enough if `short`.
    fn product(sum: i32, x: i32, short: bool) -> i32;
    /// Sine and cosine of a phase, given by its 32 leading bits, for polynomials of this many terms.
    fn sine_cosine(phase: u32, terms: usize) -> (i32, i32);
    /// Complex number in units of 2^-30, turned by an angle with this sine and cosine.
    fn rotated(number: [i32; 2], by: (i32, i32)) -> [i32; 2];
    /// Cosine and sine, in units of 2^-30, of the difference of the angles b and a.
    fn difference(a: (i32, i32), b: (i32, i32)) -> [i32; 2];
}

/// Fraction bits of the values that coefficients are made from.
const TABLE_BITS: u32 = 62;
/// Error of short products that counts as part of a tick, in units of 2^-62: 2^-31.
const SHORT_ERROR: f32 = (1_u32 << 31) as f32;
/// Least sum that could overflow, with a margin of 2^-15 plus some thousand roundings of a coefficient.
const OVERFLOW: i64 = overflow_limit(3.2e-5);
/// Least sum in 16 bits that could overflow, with a margin of about thirty roundings of a coefficient.
#[cfg(feature = "fixed")]
const SHORT_OVERFLOW: i64 = overflow_limit(1e-3);
/// Factor 1 - 9.4e-6 of the coefficients of 16 bits, in units of 2^-30. It halves the error of their sines, which are up to 1.9e-5 too large.
#[cfg(feature = "fixed")]
const SHRINK: i64 = (1 << 30) - 10093;

/// 1 minus `margin`, in units of 2^-62.
const fn overflow_limit(margin: f64) -> i64 {
    ((1.0 - margin) * (1_i64 << TABLE_BITS) as f64) as i64
}

/// Whether 16 bits of x are enough for a sum that is multiplied by this power of x.
#[inline(always)]
pub(super) const fn is_short(power: usize, terms: usize) -> bool {
    2 * power > terms
}

/// Upper bound on the sum of the factors of x in short products, in units of 2^-30; `None` where a sum could exceed `limit`.
fn short_factors(polynomial: &[i64], limit: i64) -> Option<u32> {
    let limit = (limit >> 32) as u32;
    let (mut sum, mut factors) = (0_u32, 0);
    for (power, value) in polynomial.iter().enumerate().skip(1).rev() {
        // rounded up; a sum that is not too large has room for another coefficient
        sum += (value.unsigned_abs() >> 32) as u32 + 1;
        if sum > limit >> power {
            return None;
        }
        if is_short(power, polynomial.len()) {
            factors += sum;
        }
    }
    Some(factors)
}

impl Word for i32 {
    const HALF: i32 = 0;

    /// The coefficient has half a unit more, because the product that is added to it is rounded down. The constant has not, so that the
    /// bitwise complement of the last sum is its negative.
    fn nearest(value: i64, power: usize) -> (Self, i64) {
        let dropped = TABLE_BITS - 31 - power as u32;
        let rounded =
            if power == 0 { (value >> (dropped - 1)).saturating_add(1) >> 1 } else { (value >> dropped) + 1 };
        let held = rounded.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        // both are equal modulo 2^32 up to the error, which is smaller
        (held, (held << dropped).wrapping_sub(value as i32).into())
    }

    fn error(polynomial: &[i64]) -> f32 {
        let Some(factors) = short_factors(polynomial, OVERFLOW) else { return f32::INFINITY };
        // from units of 2^-30, times the truncation of x to 2^-15
        let error = factors as f32 * (1_u32 << (TABLE_BITS - 30 - 15)) as f32;
        if error > SHORT_ERROR { error - SHORT_ERROR } else { 0.0 }
    }

    #[inline(always)]
    fn sum(self) -> i32 {
        self
    }

    #[inline(always)]
    fn coordinate(x: i32) -> i32 {
        x
    }

    #[inline(always)]
    fn product(sum: i32, x: i32, short: bool) -> i32 {
        if short { short_product(sum, x) } else { high_product_of_less(sum, x) }
    }

    /// With five terms the results become `f32`, which needs fewer bits.
    #[inline(always)]
    fn sine_cosine(phase: u32, terms: usize) -> (i32, i32) {
        if terms < 5 { sine_cosine_q31(phase) } else { sine_cosine_q26(phase) }
    }

    #[inline(always)]
    fn rotated([re, im]: [i32; 2], (sine, cosine): (i32, i32)) -> [i32; 2] {
        [
            high_product(!im, sine) + high_product(re, cosine),
            high_product(im, cosine) + high_product(re, sine),
        ]
    }

    #[inline(always)]
    fn difference((sine_a, cosine_a): (i32, i32), (sine_b, cosine_b): (i32, i32)) -> [i32; 2] {
        [
            high_product(cosine_a, cosine_b) + high_product(sine_a, sine_b),
            high_product(cosine_a, sine_b) - high_product(sine_a, cosine_b),
        ]
    }
}

/// Both factors of every product have 16 bits, so that a product is one instruction on the smallest chip.
#[cfg(feature = "fixed")]
impl Word for i16 {
    const HALF: i32 = 1 << 15;

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

    #[inline(always)]
    fn sum(self) -> i32 {
        i32::from(self) << 16
    }

    #[inline(always)]
    fn coordinate(x: i32) -> i32 {
        ((x >> 15) + 1) >> 1
    }

    #[inline(always)]
    fn product(sum: i32, x: i32, _: bool) -> i32 {
        (sum >> 16) * x
    }

    #[inline(always)]
    fn sine_cosine(phase: u32, _: usize) -> (i32, i32) {
        let (sine, cosine) = sine_cosine_q15(phase);
        (sine >> 15, cosine >> 15)
    }

    /// Result rounded to 2^-14.
    #[inline(always)]
    fn rotated(number: [i32; 2], (sine, cosine): (i32, i32)) -> [i32; 2] {
        let [re, im] = number.map(|part| part >> 16);
        [re * cosine - im * sine, re * sine + im * cosine].map(|part| (part + (1 << 15)) >> 16 << 16)
    }

    #[inline(always)]
    fn difference((sine_a, cosine_a): (i32, i32), (sine_b, cosine_b): (i32, i32)) -> [i32; 2] {
        [cosine_a * cosine_b + sine_a * sine_b, cosine_a * sine_b - sine_a * cosine_b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::series::expansion::TABLE_UNIT;

    /// With six terms the products with the fourth and the fifth power are short, and the sum of the lower one
    /// contains both.
    #[test]
    fn what_short_products_lose() {
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 2e-13, "{found:e} {expected:e}");
        let error = |values| TABLE_UNIT * f64::from(i32::error(&polynomial(values)));
        let accepted = TABLE_UNIT * f64::from(SHORT_ERROR);
        // in range, but the short products are not accurate enough
        near(error([0.0, 0.0, 0.0, 0.0, 0.02, 0.01]), 0.04 / 32768.0 - accepted);
        near(error([0.9, 0.3, 0.05, 0.02, -0.03, 0.01]), 0.05 / 32768.0 - accepted);
        assert_eq!(error([0.9, 0.3, 0.05, 0.02, 0.0, 1e-9]), 0.0);
        assert_eq!(error([0.0, 0.0, 0.0, 0.0, 0.02, 0.04]), f64::INFINITY);
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn sums_stay_below_their_powers_by_a_margin() {
        assert_eq!(i16::error(&polynomial([0.9, 0.4994, 0.0])), 0.0);
        assert_eq!(i16::error(&polynomial([0.9, 0.4996, 0.0])), f32::INFINITY);
        assert_eq!(i16::error(&polynomial([0.9, 0.2, -0.2499, 0.0])), f32::INFINITY);
    }

    #[test]
    fn a_coefficient_knows_its_error() {
        for power in 0..16 {
            for value in [0.2, -0.2, 1e-9, 0.0].map(|value| value * 0.5_f64.powi(power)) {
                let [value] = polynomial([value]);
                let (held, error) = i32::nearest(value, power as usize);
                let truth = f64::from(held) * 2_f64.powi(-31 - power) - value as f64 * 2_f64.powi(-62);
                assert!((error as f64 * 2_f64.powi(-62) - truth).abs() < 1e-16, "{power} {value}");
                assert!(truth.abs() <= 2_f64.powi(-31 - power));
            }
        }
        assert_eq!(i32::nearest(i64::MAX, 1).0, i32::MAX);
    }

    fn polynomial<const N: usize>(values: [f64; N]) -> [i64; N] {
        values.map(|value| (value * 2_f64.powi(62)) as i64)
    }
}

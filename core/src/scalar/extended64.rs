//! Extended precision of 64 bits: a floating-point number with a significand of one long word, computed in integers.
//!
//! The phases of a tick in `f32` or in fixed point need rates with some 60 correct bits, not the 120 of
//! [`Extended`](super::Extended): a product takes four products of 32-bit words instead of sixteen, and a number has half the size.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::phase::integer_parts;
use crate::product::product_of_long;
use crate::scalar::extended::newton::{short_inverse_root, short_reciprocal};
use crate::scalar::{Extended, Float, Ring, times_power_of_two};

/// Number ±significand · 2^exponent. Relative error of one operation: below 1.1 · 2^-64.
///
/// Infinity and NaN become 0, and a quotient by 0 the largest number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extended64 {
    /// Magnitude in [2^63, 2^64), or 0.
    significand: u64,
    exponent: i32,
    /// Whether the number is below 0.
    negative: bool,
}

/// Exponent of 0, below that of every other number.
const OF_ZERO: i32 = i32::MIN / 4;
/// Exponent of a quotient by 0.
const LARGEST: i32 = i32::MAX / 4;
/// Leading bit of a significand.
const LEADING: u64 = 1 << 63;

impl Extended64 {
    /// Number ±(high + low · 2^-64) · 2^exponent, rounded to the nearest.
    #[inline(never)] // a call, because a copy in each operation would take much of a chip's flash
    fn normalised([high, low]: [u64; 2], exponent: i32, negative: bool) -> Self {
        let ([high, low], exponent) =
            if high == 0 { ([low, 0], exponent - 64) } else { ([high, low], exponent) };
        if high == 0 {
            return Self::ZERO;
        }
        let spare = high.leading_zeros();
        let significand = (high << spare) | ((low >> 1) >> (63 - spare));
        Self::rounded([significand, low << spare], exponent - spare as i32, negative)
    }

    /// Number ±(estimate + correction) · 2^exponent, whose magnitude is in [2^63, 2^64].
    fn corrected(estimate: u64, correction: i64, exponent: i32, negative: bool) -> Self {
        match estimate.checked_add_signed(correction) {
            Some(significand) => Self { significand: significand | LEADING, exponent, negative },
            None => Self { significand: LEADING, exponent: exponent + 1, negative },
        }
    }

    /// Number ±(high + low · 2^-64) · 2^exponent with the leading bit of `high` set, rounded to the nearest.
    #[inline(always)]
    fn rounded([high, low]: [u64; 2], exponent: i32, negative: bool) -> Self {
        match high.overflowing_add(low >> 63) {
            (significand, false) => Self { significand, exponent, negative },
            (_, true) => Self { significand: LEADING, exponent: exponent + 1, negative },
        }
    }
}

/// Quotient of a number by 2^exponent and the bits below it, for an exponent from 1 to 31, in words of 32 bits: a chip takes half of the
/// instructions for a shift by up to 63 bits.
#[inline(always)]
fn over_power(number: u64, exponent: u32) -> [u64; 2] {
    let (high, low) = ((number >> 32) as u32, number as u32);
    let quotient = u64::from(high >> exponent) << 32 | u64::from(low >> exponent | high << (32 - exponent));
    [quotient, u64::from(low << (32 - exponent)) << 32]
}

impl Add for Extended64 {
    type Output = Self;
    #[inline(never)] // a call, as in `Extended`
    fn add(self, other: Self) -> Self {
        let (larger, smaller) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let distance = (larger.exponent - smaller.exponent) as u32;
        let Self { exponent, negative, .. } = larger;
        let [high, low] = match distance {
            0 => [smaller.significand, 0],
            1..=31 => over_power(smaller.significand, distance),
            32..=63 => [smaller.significand >> distance, smaller.significand << (64 - distance)],
            64 => [0, smaller.significand],
            _ => return larger,
        };
        if negative == smaller.negative {
            return match larger.significand.overflowing_add(high) {
                (0, false) => Self::ZERO,
                (sum, false) => Self::rounded([sum, low], exponent, negative),
                (sum, true) => Self::rounded([LEADING | (sum >> 1), sum << 63], exponent + 1, negative),
            };
        }
        // at distance 0 the other number may be the larger one, and no bit is below the last
        if larger.significand < high {
            return Self::normalised([high - larger.significand, 0], exponent, !negative);
        }
        let difference = larger.significand - high - u64::from(low != 0);
        Self::normalised([difference, low.wrapping_neg()], exponent, negative)
    }
}

impl Neg for Extended64 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { negative: !self.negative && self.significand != 0, ..self }
    }
}

impl Sub for Extended64 {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended64 {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let negative = self.negative != other.negative;
        let exponent = self.exponent + other.exponent + 64;
        let [high, low] = product_of_long(self.significand, other.significand);
        if high >= LEADING {
            Self::rounded([high, low], exponent, negative)
        } else if high == 0 {
            Self::ZERO
        } else {
            Self::rounded([(high << 1) | (low >> 63), low << 1], exponent - 1, negative)
        }
    }
}

impl Div for Extended64 {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if other.significand == 0 {
            return if self.significand == 0 { Self::ZERO } else { Self { exponent: LARGEST, ..self } };
        }
        if self.significand == 0 {
            return Self::ZERO;
        }
        let (dividend, divisor) = (self.significand, other.significand);
        // 2^126 / divisor, with 60 correct bits
        let reciprocal = short_reciprocal(divisor);
        // dividend · 2^(62 + shift) / divisor in [2^63, 2^64), with an error of a few units until the remainder corrects it
        let (shift, scaled) =
            if dividend < divisor { (2, [dividend, 0]) } else { (1, [dividend >> 1, dividend << 63]) };
        let [estimate, _] = product_of_long(dividend, reciprocal);
        let estimate = estimate.min(u64::MAX >> shift) << shift;
        let product = product_of_long(estimate, divisor);
        let rest = difference(scaled, product);
        let correction = ((rest >> 20) as i64 * (reciprocal >> 50) as i64 + (1 << 55)) >> 56;
        let exponent = self.exponent - other.exponent - 62 - shift;
        Self::corrected(estimate, correction, exponent, self.negative != other.negative)
    }
}

/// Difference of two numbers of 128 bits, given as words of 64 bits, that differ by less than 2^127.
fn difference([high, low]: [u64; 2], [other_high, other_low]: [u64; 2]) -> i128 {
    let (low, borrow) = low.overflowing_sub(other_low);
    let high = high.wrapping_sub(other_high).wrapping_sub(borrow.into());
    (i128::from(high as i64) << 64) | i128::from(low)
}

impl PartialOrd for Extended64 {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let magnitudes = || (self.exponent, self.significand).cmp(&(other.exponent, other.significand));
        Some(match (self.negative, other.negative) {
            (false, false) => magnitudes(),
            (true, true) => magnitudes().reverse(),
            (false, true) => Ordering::Greater,
            (true, false) => Ordering::Less,
        })
    }
}

impl Ring for Extended64 {
    const ZERO: Self = Self { significand: 0, exponent: OF_ZERO, negative: false };
    const ONE: Self = Self { significand: LEADING, exponent: -63, negative: false };

    #[inline(never)] // copies of the short operations would take more flash, too
    fn doubled(self) -> Self {
        Self { exponent: self.exponent + i32::from(self.significand != 0), ..self }
    }
}

impl Float for Extended64 {
    #[inline(never)]
    fn from_f64(x: f64) -> Self {
        let (mantissa, exponent) = integer_parts(x);
        Self::normalised([mantissa.unsigned_abs(), 0], exponent, mantissa < 0)
    }

    #[inline(never)]
    fn to_f64(self) -> f64 {
        let size = times_power_of_two(self.significand as f64, self.exponent);
        if self.negative { -size } else { size }
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        if self.negative || self.significand == 0 {
            return Self::ZERO;
        }
        // number = high + low · 2^-64 in [2^62, 2^64), with an even exponent
        let odd = self.exponent & 1;
        let [high, low] = [self.significand >> odd, if odd == 1 { self.significand << 63 } else { 0 }];
        // 2^94 / √number, with 52 correct bits
        let inverse = short_inverse_root(high);
        // √number · 2^32 in [2^63, 2^64), with an error of some thousand units until the residual over twice the root
        // corrects it
        let [estimate, _] = product_of_long(high, inverse);
        let estimate = estimate.min(u64::MAX >> 2) << 2;
        let rest = difference([high, low], product_of_long(estimate, estimate));
        let correction = ((rest >> 31) as i64 * (inverse >> 47) as i64 + (1 << 48)) >> 49;
        Self::corrected(estimate, correction, (self.exponent + odd) / 2 - 32, false)
    }

    #[inline(never)]
    fn abs(self) -> Self {
        Self { negative: false, ..self }
    }

    #[inline(never)]
    fn halved(self) -> Self {
        Self { exponent: self.exponent - i32::from(self.significand != 0), ..self }
    }
}

impl From<Extended> for Extended64 {
    #[inline(never)]
    fn from(number: Extended) -> Self {
        let (magnitude, exponent) = (number.significand().unsigned_abs() << 2, number.exponent + 62);
        let [high, low] = [(magnitude >> 64) as u64, magnitude as u64];
        let negative = number.significand() < 0;
        // all but 0 and a negative power of two
        if high >> 62 == 1 {
            Self::rounded([(high << 1) | (low >> 63), low << 1], exponent - 1, negative)
        } else {
            Self::normalised([high, low], exponent, negative)
        }
    }
}

impl From<Extended64> for Extended {
    #[inline(never)]
    fn from(Extended64 { significand, exponent, negative }: Extended64) -> Self {
        if significand == 0 {
            return Self::ZERO;
        }
        // 61 bits more
        let significand = (i128::from(significand >> 3) << 64) | i128::from(significand << 61);
        Self::nearly_normalised(if negative { -significand } else { significand }, exponent - 61)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of an operation, relative to its result.
    const ROUNDING: f64 = 1.1 / (1_u128 << 64) as f64;

    /// Numbers with 64 significant bits, of both signs and of sizes that overlap.
    fn samples() -> impl Iterator<Item = Extended64> {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        (0..if cfg!(miri) { 100 } else { 50_000 }).map(move |k| {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let significand = match k % 5 {
                0 => u64::MAX - (bits >> 60),
                1 => LEADING + (bits >> 61),
                2 => bits & (u64::MAX << 50) | LEADING,
                _ => bits | LEADING,
            };
            let exponent = -64 + (bits >> 20) as i32 % if k % 3 == 0 { 3 } else { 70 };
            Extended64 { significand, exponent, negative: bits & 1 == 1 }
        })
    }

    /// Error of a result, relative to the true one.
    fn error(result: Extended64, truth: Extended) -> f64 {
        let difference = Extended::from(result) - truth;
        if truth == Extended::ZERO { difference.to_f64() } else { (difference / truth).abs().to_f64() }
    }

    #[test]
    fn every_operation_is_rounded_to_the_nearest() {
        let mut worst = [0.0_f64; 6];
        let mut before = Extended64::ONE;
        for x in samples() {
            let [a, b] = [x, before].map(Extended::from);
            let errors = [
                error(x + before, a + b),
                error(x - before, a - b),
                error(x * before, a * b),
                error(x / before, a / b),
                error(x.abs().sqrt(), a.abs().sqrt()),
                error(Extended64::from(a / b), a / b),
            ];
            assert!(errors.iter().all(|error| *error < ROUNDING), "{x:?} {before:?} {errors:?}");
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = worst.max(error);
            }
            assert_eq!(x.partial_cmp(&before), a.partial_cmp(&b), "{x:?} {before:?}");
            assert_eq!(Extended64::from(a), x);
            before = x;
        }
        assert!(worst.iter().all(|worst| *worst > 0.6 * ROUNDING || cfg!(miri)), "{worst:?}");
    }

    #[test]
    fn zero_and_what_has_no_value() {
        let [zero, one, third] =
            [Extended64::ZERO, Extended64::ONE, Extended64::ONE / Extended64::from_f64(3.0)];
        assert_eq!([zero + zero, zero * one, zero / one, zero / zero, -zero, third - third], [zero; 6]);
        assert_eq!([third + zero, zero + third, third * one, third / one, -(-third)], [third; 5]);
        assert_eq!([(-one).sqrt(), Extended64::from_f64(f64::NAN), zero.halved(), zero.doubled()], [zero; 4]);
        assert_eq!((one / zero).to_f64(), f64::INFINITY);
        assert!(zero < third && -third < zero && -one < -third);
        assert_eq!(third.to_f64(), 1.0 / 3.0);
    }

    #[test]
    fn numbers_of_f64_are_exact() {
        for x in [1.0, -0.1, 6e-310, 1.7e308, 3.0] {
            assert_eq!(Extended64::from_f64(x).to_f64(), if x == 6e-310 { 0.0 } else { x });
        }
    }
}

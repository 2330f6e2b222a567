//! Extended precision: a floating-point number with a significand of 125 bits, computed in integers.
//!
//! Set-up computes in this type, so that small differences that the `f64` input determines exactly (1e-12 between two
//! branch points, or the rounding of the product mass × height) keep their digits in the rates. Integer instructions
//! give the same bits on every processor, and on a chip without a floating-point unit for `f64` they cost a fraction
//! of the pairs of `f64` that would have this precision: a product takes 16 products of 32-bit words.

mod conversion;

pub(super) mod newton;

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::product::wide_product;
use crate::scalar::{Float, Ring};
use conversion::nearest;
use newton::{inverse_root, reciprocal};

/// Number significand · 2^exponent. Relative error of one operation: below 2^-123.
///
/// Range: every `f64` and all products of a few of them, exactly; the exponent has 32 bits, so no result of set-up
/// leaves the range. Infinity and NaN become 0, and a quotient by 0 the largest number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Extended {
    /// Lower and upper word of the significand, which is in [2^124, 2^125) or [-2^125, -2^124), or 0, in two's complement. Three bits are
    /// spare: two for the sum of two numbers that are shifted by one bit, one for the sign.
    ///
    /// One integer of 128 bits would be passed in registers, which each call stores and loads: a launch would take a sixth more flash.
    words: [u64; 2],
    pub(super) exponent: i32,
}

/// Number of bits of the significand.
const BITS: i32 = 125;
/// Exponent of 0, below that of every other number.
const OF_ZERO: i32 = i32::MIN / 4;
/// Exponent of a quotient by 0.
const LARGEST: i32 = i32::MAX / 4;

impl Extended {
    /// Upper bound on the relative error of one sum, product, quotient or root.
    pub(crate) const ROUNDING: f64 = 1.0 / (1_u128 << 123) as f64;

    /// 2π.
    pub(crate) const TWO_PI: Self = Self::of(0x1921_fb54_442d_1846_9898_cc51_701b_839a, 3 - BITS);

    /// Number of a normalised significand.
    pub(super) const fn of(significand: i128, exponent: i32) -> Self {
        Self { words: [significand as u64, (significand >> 64) as u64], exponent }
    }

    /// Significand as one integer.
    #[inline(always)]
    pub(super) const fn significand(&self) -> i128 {
        let [low, high] = self.words;
        ((high as i64 as i128) << 64) | low as i128
    }

    /// Number `significand` · 2^`exponent`, exact for a significand of up to 125 bits.
    #[inline(never)] // called from every operation
    pub(crate) fn normalised(significand: i128, exponent: i32) -> Self {
        if significand == 0 {
            return Self::ZERO;
        }
        let spare = (significand ^ (significand >> 127)).leading_zeros() as i32 - (128 - BITS);
        let significand = if spare < 0 { significand >> -spare } else { significand << spare };
        Self::of(significand, exponent - spare)
    }

    /// [`Extended::normalised`] for a significand that is 0, or has one bit too many or too few at most: a fraction of the cost.
    #[inline(always)]
    pub(super) fn nearly_normalised(significand: i128, exponent: i32) -> Self {
        // a negative significand of -2^n has as many bits as one of 2^n - 1
        let bits = significand ^ (significand >> 127);
        match bits >> (BITS - 1) {
            1 => Self::of(significand, exponent),
            2 | 3 => Self::of(significand >> 1, exponent + 1),
            _ => Self::normalised(significand, exponent),
        }
    }

    /// Number with this magnitude and the sign of a product or quotient of two others.
    fn signed(magnitude: u128, exponent: i32, negative: bool) -> Self {
        let magnitude = magnitude as i128;
        Self::nearly_normalised(if negative { -magnitude } else { magnitude }, exponent)
    }
}

impl Add for Extended {
    type Output = Self;
    #[inline(never)] // a call, because inlining into every formula of a launch would take much of a chip's flash
    fn add(self, other: Self) -> Self {
        let (larger, smaller) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let distance = larger.exponent - smaller.exponent;
        if distance > BITS {
            return Self::nearly_normalised(larger.significand(), larger.exponent);
        }
        // one more bit: a difference of two numbers whose exponents differ by 1 is exact
        let sum = (larger.significand() << 1) + ((((smaller.significand() << 2) >> distance) + 1) >> 1);
        // most sums have as many bits as the larger number, or one more
        match (sum ^ (sum >> 127)) >> BITS {
            1 => Self::of(sum >> 1, larger.exponent),
            2 | 3 => Self::of(sum >> 2, larger.exponent + 1),
            _ => Self::normalised(sum, larger.exponent - 1),
        }
    }
}

impl Neg for Extended {
    type Output = Self;
    #[inline(never)]
    fn neg(self) -> Self {
        Self::nearly_normalised(-self.significand(), self.exponent)
    }
}

impl Sub for Extended {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        // a sum does not depend on the one bit by which a negated significand may be too short, but it must not be too long
        let significand = -other.significand();
        if significand >> BITS > 0 { self + -other } else { self + Self::of(significand, other.exponent) }
    }
}

impl Mul for Extended {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        // two factors in [2^126, 2^127], whose product is in [2^252, 2^254]
        let [a, b] = [self, other].map(|factor| factor.significand().unsigned_abs() << 2);
        let [high, _] = wide_product(a, b);
        let negative = (self.significand() < 0) != (other.significand() < 0);
        Self::signed(high, self.exponent + other.exponent + BITS - 1, negative)
    }
}

impl Div for Extended {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if other.significand() == 0 {
            return if self.significand() == 0 { Self::ZERO } else { Self { exponent: LARGEST, ..self } };
        }
        let [dividend, divisor] = [self, other].map(|number| number.significand().unsigned_abs());
        // dividend · 2^125 / divisor, with an error of a few units until the remainder corrects it
        let [mut quotient, _] = wide_product(dividend << 2, reciprocal(divisor));
        let [_, product] = wide_product(quotient, divisor);
        let mut rest = (dividend << BITS).wrapping_sub(product) as i128;
        while rest < 0 {
            (quotient, rest) = (quotient - 1, rest + divisor as i128);
        }
        while rest >= divisor as i128 {
            (quotient, rest) = (quotient + 1, rest - divisor as i128);
        }
        let negative = (self.significand() < 0) != (other.significand() < 0);
        Self::signed(quotient, self.exponent - other.exponent - BITS, negative)
    }
}

impl PartialOrd for Extended {
    #[inline(never)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let sign = |number: &Self| number.significand().signum();
        let magnitudes = || (self.exponent, self.significand()).cmp(&(other.exponent, other.significand()));
        let order = sign(self).cmp(&sign(other));
        Some(order.then_with(|| match sign(self) {
            1 => magnitudes(),
            -1 => other.exponent.cmp(&self.exponent).then(self.significand().cmp(&other.significand())),
            _ => Ordering::Equal,
        }))
    }
}

impl Ring for Extended {
    const ZERO: Self = Self::of(0, OF_ZERO);
    const ONE: Self = Self::of(1 << (BITS - 1), 1 - BITS);

    #[inline(never)] // copies of the short operations would take more flash, too
    fn doubled(self) -> Self {
        Self { exponent: self.exponent + i32::from(self.significand() != 0), ..self }
    }
}

impl Float for Extended {
    fn from_f64(x: f64) -> Self {
        x.into()
    }

    #[inline(never)]
    fn to_f64(self) -> f64 {
        nearest(self.significand(), self.exponent)
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        if self.significand() <= 0 {
            return Self::ZERO;
        }
        let odd = self.exponent & 1;
        let inverse = inverse_root(self.significand().unsigned_abs() << (2 + odd));
        let inverse = Self::normalised(inverse as i128, -188 - (self.exponent - odd) / 2);
        let root = self * inverse;
        // half the residual over the root
        root + (self - root * root) * inverse.halved()
    }

    #[inline(never)]
    fn abs(self) -> Self {
        if self.significand() < 0 { -self } else { self }
    }

    #[inline(never)]
    fn halved(self) -> Self {
        Self { exponent: self.exponent - i32::from(self.significand() != 0), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::Phase;

    const TINY: f64 = 1e-36;

    /// Numbers of all signs and sizes, some with few bits.
    fn samples() -> impl Iterator<Item = f64> {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        (0..if cfg!(miri) { 100 } else { 20_000 }).map(move |k| {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let number = f64::from_bits((bits >> 1) % (0x7fe << 52));
            let number = if k % 3 == 0 { libm::round((bits >> 50) as f64 / 7.0) } else { number };
            let number = if (1e-150..=1e150).contains(&number) { number } else { 0.375 };
            if bits & 1 == 1 { -number } else { number }
        })
    }

    #[test]
    fn a_third_times_three_is_one_to_36_digits() {
        let third = Extended::ONE / 3.0.into();
        let defect = (third * 3.0.into() - Extended::ONE).abs();
        assert!(defect.to_f64() < TINY && defect.to_f64() > 0.0);
        assert_eq!(third.parts(), [1.0 / 3.0, 1.850371707708594e-17]);
    }

    #[test]
    fn numbers_of_f64_and_their_products_are_exact() {
        let mut before = 0.75;
        for x in samples() {
            let (a, b) = (Extended::from(x), Extended::from(before));
            assert_eq!((a.to_f64(), (-a).to_f64()), (x, -x));
            let sum = if x.abs() < 1e30 * before.abs() { a + b } else { b + a };
            assert_eq!(sum.to_f64(), x + before, "{x:e} {before:e}");
            assert_eq!((a * b).to_f64(), x * before, "{x:e} {before:e}");
            assert_eq!(a.partial_cmp(&b), x.partial_cmp(&before), "{x:e} {before:e}");
            if before != 0.0 {
                assert_eq!((a * b) / b, a, "{x:e} {before:e}");
                assert_eq!((a / b).to_f64(), x / before, "{x:e} {before:e}");
            }
            if (1e-15..1e15).contains(&(x / before).abs()) {
                assert_eq!((a + b) - b, a, "{x:e} {before:e}");
            }
            let square = a * a;
            assert_eq!(square.sqrt(), a.abs(), "{x:e}");
            let [upper, lower] = (a / 3.0.into()).halves();
            assert_eq!(upper + lower, a / 3.0.into());
            before = x;
        }
    }

    #[test]
    fn a_root_squares_back() {
        for x in [2.0, 1e-20, 12345.678, 9.81] {
            let x = Extended::from(x);
            let root = x.sqrt();
            assert!(((root * root - x) / x).abs().to_f64() < TINY);
        }
        assert_eq!(Extended::from(-1e-300).sqrt(), Extended::ZERO);
    }

    #[test]
    fn a_small_difference_survives() {
        let big = Extended::sum(1.0, 1e-20);
        assert_eq!((big - Extended::ONE).to_f64(), 1e-20);
        assert_eq!((Extended::product(0.1, 3.0) - Extended::from(0.1) * 3.0.into()).to_f64(), 0.0);
        assert!(big > Extended::ONE);
    }

    #[test]
    fn a_quotient_by_zero_is_larger_than_any_f64() {
        assert_eq!((Extended::ONE / Extended::ZERO).to_f64(), f64::INFINITY);
        assert_eq!((-Extended::ONE / Extended::ZERO).to_f64(), f64::NEG_INFINITY);
        assert_eq!(Extended::ZERO / Extended::ZERO, Extended::ZERO);
        assert_eq!(Extended::from(f64::NAN), Extended::ZERO);
    }

    #[test]
    fn a_turn_has_a_phase() {
        assert_eq!(Extended::from(-3.25).to_phase(), Phase::new(-3.25));
        assert_eq!((Extended::TWO_PI * 0.25.into()).in_turns().to_phase(), Phase::QUARTER);
        let ([whole, low], rest) = Extended::sum(1e20, 0.75).floor_and_rest();
        assert_eq!((whole + low, rest.to_f64()), (1e20, 0.75));
    }
}

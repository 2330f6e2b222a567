//! Extended precision: a floating-point number with a significand of 125 bits, computed in integers.
//!
//! Set-up computes in this type, so that small differences that the `f64` input determines exactly (1e-12 between two
//! branch points, or the rounding of the product mass × height) keep their digits in the rates. Integer instructions
//! give the same bits on every processor, and on a chip without a floating-point unit for `f64` they cost a fraction
//! of the pairs of `f64` that would have this precision: a product takes 16 products of 32-bit words.

mod newton;

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::phase::{FRACTION_BITS, Phase, integer_parts, shifted};
use crate::product::wide_product;
use crate::scalar::{Float, Ring};
use newton::{inverse_root, reciprocal};

/// Number significand · 2^exponent. Relative error of one operation: below 2^-123.
///
/// Range: every `f64` and all products of a few of them, exactly; the exponent has 32 bits, so no result of set-up
/// leaves the range. Infinity and NaN become 0, and a quotient by 0 the largest number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Extended {
    /// Two's complement, in [2^124, 2^125) or [-2^125, -2^124), or 0. Three bits are spare: two for the sum of two
    /// numbers that are shifted by one bit, one for the sign.
    significand: i128,
    exponent: i32,
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
    pub(crate) const TWO_PI: Self =
        Self { significand: 0x1921_fb54_442d_1846_9898_cc51_701b_839a, exponent: 3 - BITS };

    /// Number `significand` · 2^`exponent`, exact for a significand of up to 125 bits.
    #[inline(never)] // called from every operation
    pub(crate) fn normalised(significand: i128, exponent: i32) -> Self {
        if significand == 0 {
            return Self::ZERO;
        }
        let spare = (significand ^ (significand >> 127)).leading_zeros() as i32 - (128 - BITS);
        let significand = if spare < 0 { significand >> -spare } else { significand << spare };
        Self { significand, exponent: exponent - spare }
    }

    /// Number with this magnitude and the sign of a product or quotient of two others.
    fn signed(magnitude: u128, exponent: i32, negative: bool) -> Self {
        let magnitude = magnitude as i128;
        Self::normalised(if negative { -magnitude } else { magnitude }, exponent)
    }

    /// Angle in turns, from an angle in rad.
    pub(crate) fn in_turns(self) -> Self {
        const PER_TURN: Extended =
            Extended { significand: 0x145f_306d_c9c8_82a5_3f84_eafa_3ea6_9bb8, exponent: -2 - BITS };
        self * PER_TURN
    }

    /// Phase of this number of turns, modulo 2^32 turns, rounded to the nearest.
    #[must_use]
    pub fn to_phase(self) -> Phase {
        Phase::from_bits(shifted(self.significand, self.exponent.saturating_add(FRACTION_BITS)))
    }

    /// Sum of two `f64`, exact unless one is below 2^-72 of the other.
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        Self::from(a) + Self::from(b)
    }

    /// Product of two `f64`, exact.
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        Self::from(a) * Self::from(b)
    }

    /// Nearest `f64`, and the `f64` nearest to the rest: 106 bits or more.
    #[must_use]
    pub fn parts(self) -> [f64; 2] {
        let leading = self.to_f64();
        [leading, (self - leading.into()).to_f64()]
    }

    /// Upper 62 bits and the other 63, whose products with those of another number are exact.
    pub(crate) fn halves(self) -> [Self; 2] {
        let lower = self.significand & ((1 << (BITS - 62)) - 1);
        let upper = Self { significand: self.significand - lower, exponent: self.exponent };
        // 0, and a negative power of two, are normalised anew
        [Self::normalised(upper.significand, self.exponent), Self::normalised(lower, self.exponent)]
    }

    /// Largest whole number not above this one, as the sum of two whole `f64`, and the remainder in [0, 1).
    pub(crate) fn floor_and_rest(self) -> ([f64; 2], Self) {
        let [leading, low] = self.parts();
        let (whole, low_whole) = (libm::floor(leading), libm::floor(low));
        let rest = (self - whole.into()) - low_whole.into();
        if rest < Self::ONE {
            ([whole, low_whole], rest)
        } else {
            ([whole, low_whole + 1.0], rest - Self::ONE)
        }
    }
}

impl From<f64> for Extended {
    #[inline(never)]
    fn from(x: f64) -> Self {
        let (mantissa, exponent) = integer_parts(x);
        Self::normalised(mantissa.into(), exponent)
    }
}

impl From<Phase> for Extended {
    /// Number of turns, whole turns included; exact below 2^28 turns.
    fn from(phase: Phase) -> Self {
        Self::normalised(phase.to_bits(), -FRACTION_BITS)
    }
}

impl Add for Extended {
    type Output = Self;
    #[inline(never)] // a call: inlined into every formula of a launch it would cost a chip its flash
    fn add(self, other: Self) -> Self {
        let (larger, smaller) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let distance = larger.exponent - smaller.exponent;
        if distance > BITS {
            return larger;
        }
        // one more bit: a difference of two numbers whose exponents differ by 1 is exact
        Self::normalised(
            (larger.significand << 1) + ((((smaller.significand << 2) >> distance) + 1) >> 1),
            larger.exponent - 1,
        )
    }
}

impl Neg for Extended {
    type Output = Self;
    #[inline(never)]
    fn neg(self) -> Self {
        Self::normalised(-self.significand, self.exponent)
    }
}

impl Sub for Extended {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        // two factors in [2^126, 2^127], whose product is in [2^252, 2^254]
        let [a, b] = [self, other].map(|factor| factor.significand.unsigned_abs() << 2);
        let [high, _] = wide_product(a, b);
        let negative = (self.significand < 0) != (other.significand < 0);
        Self::signed(high, self.exponent + other.exponent + BITS - 1, negative)
    }
}

impl Div for Extended {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if other.significand == 0 {
            return if self.significand == 0 { Self::ZERO } else { Self { exponent: LARGEST, ..self } };
        }
        let [dividend, divisor] = [self, other].map(|number| number.significand.unsigned_abs());
        // dividend · 2^125 / divisor, a few units off before the remainder corrects it
        let [mut quotient, _] = wide_product(dividend << 2, reciprocal(divisor));
        let [_, product] = wide_product(quotient, divisor);
        let mut rest = (dividend << BITS).wrapping_sub(product) as i128;
        while rest < 0 {
            (quotient, rest) = (quotient - 1, rest + divisor as i128);
        }
        while rest >= divisor as i128 {
            (quotient, rest) = (quotient + 1, rest - divisor as i128);
        }
        let negative = (self.significand < 0) != (other.significand < 0);
        Self::signed(quotient, self.exponent - other.exponent - BITS, negative)
    }
}

impl PartialOrd for Extended {
    #[inline(never)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let sign = |number: &Self| number.significand.signum();
        let magnitudes = || (self.exponent, self.significand).cmp(&(other.exponent, other.significand));
        let order = sign(self).cmp(&sign(other));
        Some(order.then_with(|| match sign(self) {
            1 => magnitudes(),
            -1 => other.exponent.cmp(&self.exponent).then(self.significand.cmp(&other.significand)),
            _ => Ordering::Equal,
        }))
    }
}

impl Ring for Extended {
    const ZERO: Self = Self { significand: 0, exponent: OF_ZERO };
    const ONE: Self = Self { significand: 1 << (BITS - 1), exponent: 1 - BITS };

    fn doubled(self) -> Self {
        Self { exponent: self.exponent + i32::from(self.significand != 0), ..self }
    }
}

impl Float for Extended {
    fn from_f64(x: f64) -> Self {
        x.into()
    }

    #[inline(never)]
    fn to_f64(self) -> f64 {
        nearest(self.significand, self.exponent)
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        if self.significand <= 0 {
            return Self::ZERO;
        }
        let odd = self.exponent & 1;
        let inverse = inverse_root(self.significand.unsigned_abs() << (2 + odd));
        let inverse = Self::normalised(inverse as i128, -188 - (self.exponent - odd) / 2);
        let root = self * inverse;
        // half the residual over the root
        root + (self - root * root) * inverse.halved()
    }

    fn abs(self) -> Self {
        if self.significand < 0 { -self } else { self }
    }

    fn halved(self) -> Self {
        Self { exponent: self.exponent - i32::from(self.significand != 0), ..self }
    }
}

/// Nearest `f64` to significand · 2^exponent, of two equally near ones the even one; infinity beyond the range of
/// `f64`, and 0 below the normal numbers.
fn nearest(significand: i128, exponent: i32) -> f64 {
    const DROPPED: i32 = BITS - 53;
    const HALF: u128 = 1 << (DROPPED - 1);
    let magnitude = significand.unsigned_abs();
    let (kept, rest) = ((magnitude >> DROPPED) as u64, magnitude & (2 * HALF - 1));
    let rounded = kept + u64::from(rest > HALF || (rest == HALF && kept & 1 == 1));
    // the leading bit of the significand adds 1 to the exponent's field
    let field = i64::from(exponent) + i64::from(DROPPED) + 1074;
    let bits = match field {
        ..0 => 0,
        2046.. => f64::INFINITY.to_bits(),
        _ => ((field as u64) << 52) + rounded,
    };
    let size = f64::from_bits(bits);
    if significand < 0 { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

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

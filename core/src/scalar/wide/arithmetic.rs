//! Sums, products, quotients and roots of wide numbers.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::words::{inverse_root_u64, leading, quotient};
use super::{DoubleWidth, Extended, Wide};
use crate::integer::{ldexp, power_of_two};
use crate::scalar::{Float, Ring};

impl<const WORDS: usize> Wide<WORDS> {
    /// Difference a - bc with one rounding.
    fn minus_product(a: Self, [b, c]: [Self; 2]) -> Self {
        DoubleWidth::from(a).plus(DoubleWidth::product(&-b, &c))
    }

    /// Difference ab - cd with one rounding.
    pub(crate) fn difference_of_products([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        DoubleWidth::product(&a, &b).plus(DoubleWidth::product(&-c, &d))
    }
}

impl<const WORDS: usize> Add for Wide<WORDS> {
    type Output = Self;
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        DoubleWidth::from(self).plus(DoubleWidth::from(other))
    }
}

impl<const WORDS: usize> Neg for Wide<WORDS> {
    type Output = Self;
    #[inline(never)]
    fn neg(self) -> Self {
        Self { negative: !self.negative && !self.is_zero(), ..self }
    }
}

impl<const WORDS: usize> Sub for Wide<WORDS> {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const WORDS: usize> Mul for Wide<WORDS> {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        DoubleWidth::product(&self, &other).rounded()
    }
}

impl<const WORDS: usize> Div for Wide<WORDS> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.is_zero() {
            return self.with_exponent(i32::MAX / 8);
        }
        if self.is_zero() {
            return self;
        }
        let words = quotient(&self.significand, &other.significand);
        let exponent = self.exponent - other.exponent + 72 * WORDS as i32 - 56;
        DoubleWidth::new(words, exponent, self.negative != other.negative).rounded()
    }
}

impl<const WORDS: usize> PartialOrd for Wide<WORDS> {
    #[inline(never)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let magnitude = |x: &Self| (!x.is_zero(), x.exponent, x.significand);
        Some(match (self.negative, other.negative) {
            (false, false) => magnitude(self).cmp(&magnitude(other)),
            (true, true) => magnitude(other).cmp(&magnitude(self)),
            (false, true) => Ordering::Greater,
            (true, false) => Ordering::Less,
        })
    }
}

impl<const WORDS: usize> Ring for Wide<WORDS> {
    const ZERO: Self = Self { significand: [0; WORDS], exponent: 0, negative: false };
    const ONE: Self = Self::constant(1 << 127, 1);

    #[inline(never)]
    fn doubled(self) -> Self {
        self.with_exponent(self.exponent + 1)
    }
}

impl<const WORDS: usize> Float for Wide<WORDS> {
    const OPERATION_ERROR: f64 = 1.1 * power_of_two(-64 * WORDS as i32);

    fn from_f64(x: f64) -> Self {
        x.into()
    }

    fn from_extended(x: Extended) -> Self {
        Self::resized(x)
    }

    fn to_extended(self) -> Extended {
        Extended::resized(self)
    }

    /// Nearest `f64`, ties to even; infinity beyond its range, 0 below its normal numbers.
    #[inline(never)]
    fn to_f64(self) -> f64 {
        let sticky = self.significand.iter().skip(1).any(|word| *word != 0);
        let size = (leading(&self.significand) | u64::from(sticky)) as f64;
        let size = ldexp(size, self.exponent - 64);
        if self.negative { -size } else { size }
    }

    fn sqrt(self) -> Self {
        if self.negative || self.is_zero() {
            return Self::ZERO;
        }
        let odd = self.exponent & 1;
        let nearby = inverse_root_u64(leading(&self.significand) >> odd);
        let mut inverse = Self::from_integer(nearby.into(), -62 - (self.exponent + odd) / 2, false);
        // each step of Newton's method doubles the 52 correct bits
        for _ in 1..WORDS {
            let remainder = Self::minus_product(Self::ONE, [self * inverse, inverse]);
            inverse = inverse + (remainder * inverse).halved();
        }
        let root = self * inverse;
        root + (Self::minus_product(self, [root, root]) * inverse).halved()
    }

    fn abs(self) -> Self {
        Self { negative: false, ..self }
    }

    #[inline(never)]
    fn halved(self) -> Self {
        self.with_exponent(self.exponent - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Extended;

    type Extended64 = Wide<1>;

    /// Numbers of all signs and sizes, some with few bits.
    fn samples() -> impl Iterator<Item = f64> {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        (0..if cfg!(miri) { 100 } else { 20_000 }).map(move |k| {
            bits = crate::integer::next_random(bits);
            let number = f64::from_bits((bits >> 1) % (0x7fe << 52));
            let number = if k % 3 == 0 { libm::round((bits >> 50) as f64 / 7.0) } else { number };
            let number = if (1e-150..=1e150).contains(&number) { number } else { 0.375 };
            if bits & 1 == 1 { -number } else { number }
        })
    }

    #[test]
    fn a_third_times_three_is_one_to_38_digits() {
        let third = Extended::ONE / 3.0.into();
        let defect = Extended::minus_product(Extended::ONE, [third, 3.0.into()]).abs().to_f64();
        assert!(defect < 3e-39 && defect > 0.0, "{defect:e}");
        assert_eq!(third.to_f64_pair(), [1.0 / 3.0, 1.850371707708594e-17]);
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
            assert_eq!((a * a).sqrt(), a.abs(), "{x:e}");
            before = x;
        }
    }

    #[test]
    fn a_root_squares_back() {
        for x in [2.0, 1e-20, 12345.678, 9.81] {
            let x = Extended::from(x);
            let root = x.sqrt();
            let defect = (Extended::minus_product(x, [root, root]) / x).abs().to_f64();
            assert!(defect < 7e-39 && defect > 0.0, "{defect:e}");
        }
        assert_eq!(Extended::from(-1e-300).sqrt(), Extended::ZERO);
    }

    #[test]
    fn a_small_difference_survives() {
        let big = Extended::from_f64_pair([1.0, 1e-20]);
        assert_eq!((big - Extended::ONE).to_f64(), 1e-20);
        assert!(big > Extended::ONE);
        let x = Extended::ONE + Extended::from(2_f64.powi(-120));
        let exact = Extended::difference_of_products([x, x], [Extended::ONE, x.doubled() - Extended::ONE]);
        assert_eq!(exact.to_f64(), 2_f64.powi(-240));
    }

    #[test]
    fn a_quotient_by_zero_is_larger_than_any_f64() {
        assert_eq!((Extended::ONE / Extended::ZERO).to_f64(), f64::INFINITY);
        assert_eq!((-Extended::ONE / Extended::ZERO).to_f64(), f64::NEG_INFINITY);
        assert_eq!(Extended::ZERO / Extended::ZERO, Extended::ZERO);
        assert_eq!(Extended::from(f64::NAN), Extended::ZERO);
    }

    /// Numbers with 64 significant bits, of both signs and of sizes that overlap.
    fn samples_of_64_bits() -> impl Iterator<Item = Extended64> {
        const LEADING: u64 = 1 << 63;
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        (0..if cfg!(miri) { 100 } else { 50_000 }).map(move |k| {
            bits = crate::integer::next_random(bits);
            let significand = match k % 5 {
                0 => u64::MAX - (bits >> 60),
                1 => LEADING + (bits >> 61),
                2 => bits & (u64::MAX << 50) | LEADING,
                _ => bits | LEADING,
            };
            let exponent = (bits >> 20) as i32 % if k % 3 == 0 { 3 } else { 70 };
            Wide { significand: [significand], exponent, negative: bits & 1 == 1 }
        })
    }

    #[test]
    fn every_operation_is_rounded_to_the_nearest() {
        let error = |result: Extended64, truth: Extended| {
            let difference = Extended::resized(result) - truth;
            if truth == Extended::ZERO { difference.to_f64() } else { (difference / truth).abs().to_f64() }
        };
        const ROUNDING: f64 = Extended64::OPERATION_ERROR;
        let mut worst = [0.0_f64; 6];
        let mut before = Extended64::ONE;
        for x in samples_of_64_bits() {
            let [a, b] = [x, before].map(Extended::resized);
            let errors = [
                error(x + before, a + b),
                error(x - before, a - b),
                error(x * before, a * b),
                error(x / before, a / b),
                error(x.abs().sqrt(), a.abs().sqrt()),
                error(Extended64::resized(a / b), a / b),
            ];
            assert!(errors.iter().all(|error| *error < ROUNDING), "{x:?} {before:?} {errors:?}");
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = worst.max(error);
            }
            assert_eq!(x.partial_cmp(&before), a.partial_cmp(&b), "{x:?} {before:?}");
            assert_eq!(Extended64::resized(a), x);
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
        for x in [1.0, -0.1, 6e-310, 1.7e308, 3.0] {
            assert_eq!(Extended64::from_f64(x).to_f64(), if x == 6e-310 { 0.0 } else { x });
        }
    }
}

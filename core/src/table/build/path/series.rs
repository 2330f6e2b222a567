//! Power series in integers of a common exponent.
//!
//! The coefficients of a converging series do not grow, so that one exponent serves all.

use core::ops::Range;

use crate::integer::{LIMB_BITS, Limbs, exponent, ldexp, mantissa_and_exponent, power_of_two, to_units};

/// Largest number of terms of a series.
pub(super) const MAX_TERMS: usize = 16;

/// Bits of a coefficient of the expected magnitude. One may be four times as large.
pub(super) const BITS: i32 = 56;

/// Result of a sum above the range of a coefficient; for a sum below it, the result is `!OUT_OF_RANGE`.
const OUT_OF_RANGE: i64 = 1 << (BITS + 3);

/// Least shift of a sum in range.
const MIN_SHIFT: i32 = 33;

/// Sum upper · 2^60 + lower · 2^30 divided by 2^shift, rounded to the nearest, with lower in [0, 2^30).
fn shifted_sum(upper: i64, lower: u32, shift: i32) -> i64 {
    let twice = match shift {
        61.. => upper >> (shift - 61).min(63),
        // whether upper is below 2^(shift - 1)
        MIN_SHIFT.. if matches!((upper >> 32) as i32 >> (shift - 33), 0 | -1) => {
            (upper << (61 - shift)) + i64::from(lower >> (shift - 31))
        }
        _ if upper == 0 && lower == 0 => return 0,
        _ => return OUT_OF_RANGE ^ (upper >> 63),
    };
    (twice >> 1) + (twice & 1)
}

/// Whether a number has at most this number of bits besides its sign, at least 32.
#[inline(always)]
const fn has_bits(value: i64, bits: i32) -> bool {
    // only the upper word counts, so that a chip compares one word
    matches!((value >> 32) as i32 >> (bits - 32), -1 | 0)
}

/// Number in the range of a coefficient; `None` if the series does not converge.
#[inline(always)]
pub(super) fn in_range(value: i64) -> Option<i64> {
    has_bits(value, BITS + 2).then_some(value)
}

/// Sum; `None` if a number is out of range.
#[inline(always)]
pub(super) fn sum_in_range<const N: usize>(numbers: [i64; N]) -> Option<i64> {
    numbers.iter().all(|number| has_bits(*number, BITS + 3)).then(|| numbers.iter().sum())
}

/// Fraction bits of a [`UnitFactor`], of an inverse and of y.
const FACTOR_BITS: u32 = 60;

/// Constant factor between the units of two series.
pub(super) struct UnitFactor {
    /// Factor in units of 2^(`shift` - 60).
    mantissa: Limbs,
    shift: u32,
}

impl UnitFactor {
    /// Factor from one series to another, whose exponents are known.
    pub(super) fn new(factor: f64, from: &PowerSeries, to: &PowerSeries) -> Self {
        let (_, exponent) = mantissa_and_exponent(factor);
        let least = to.exponent - from.exponent - FACTOR_BITS as i32;
        // 53 bits become 60 at most
        let unit = least.max(exponent - 7);
        Self { mantissa: Limbs::new(to_units(factor, unit)), shift: (unit - least).min(62) as u32 }
    }

    /// Product, rounded to the nearest, or [`OUT_OF_RANGE`].
    pub(super) fn times(&self, value: i64) -> i64 {
        let product = self.mantissa.times::<FACTOR_BITS>(value);
        if self.shift == 0 {
            return product;
        }
        product.saturating_mul(1 << self.shift).clamp(!OUT_OF_RANGE, OUT_OF_RANGE)
    }
}

/// Coefficient c/(k + 1) of the integral of a term c y^k, rounded to the nearest.
pub(super) fn integrated(c: i64, k: usize) -> i64 {
    #[allow(clippy::indexing_slicing)]
    static INVERSES: [Limbs; MAX_TERMS] = {
        let mut inverses = [Limbs::ZERO; MAX_TERMS];
        let mut k = 0;
        while k < MAX_TERMS {
            let divisor = k as i64 + 1;
            inverses[k] = Limbs::new(((1 << FACTOR_BITS) + divisor / 2) / divisor);
            k += 1;
        }
        inverses
    };
    INVERSES.get(k).map_or(0, |inverse| inverse.times::<FACTOR_BITS>(c))
}

/// Coefficients of 1, y, y², ..., in units of 2^exponent.
#[derive(Debug)]
pub(super) struct PowerSeries {
    coefficients: [Limbs; MAX_TERMS],
    pub(super) exponent: i32,
}

impl PowerSeries {
    pub(super) const ZERO: Self = Self { coefficients: [Limbs::ZERO; MAX_TERMS], exponent: 0 };

    /// Sets the exponent for coefficients that are expected to be at most `magnitude`.
    pub(super) fn set_exponent(&mut self, magnitude: f64) {
        self.exponent = exponent(magnitude).max(-900) - BITS;
    }

    /// Product of a factor and the expected magnitude of a coefficient.
    pub(super) fn magnitude_times(&self, factor: f64) -> f64 {
        ldexp(factor, self.exponent + BITS)
    }

    pub(super) fn coefficient(&self, k: usize) -> i64 {
        self.coefficients.get(k).map_or(0, |c| c.value())
    }

    /// Sets a coefficient; `None` if it is out of range.
    pub(super) fn set(&mut self, k: usize, value: i64) -> Option<()> {
        let value = Limbs::new(in_range(value)?);
        if let Some(coefficient) = self.coefficients.get_mut(k) {
            *coefficient = value;
        }
        Some(())
    }

    /// Coefficient of y^k of the product of these terms and another series, divided by 2^shift and rounded to the nearest, or [`OUT_OF_RANGE`].
    #[inline(never)]
    pub(super) fn product(&self, other: &Self, terms: Range<usize>, k: usize, shift: i32) -> i64 {
        let first = terms.start;
        let ours = self.coefficients.get(terms).unwrap_or_default();
        let theirs = other.coefficients.get(..=k.saturating_sub(first)).unwrap_or_default();
        let (upper, lower) = Limbs::sum_of_products(ours.iter().zip(theirs.iter().rev()));
        shifted_sum(upper, lower, shift)
    }

    /// Sum Σ t(c, k) yᵏ⁻¹ of k = 1 to `terms` - 1, at y in [-1, 1].
    pub(super) fn sum(&self, y: f64, terms: usize, term: fn(i64, usize) -> i64) -> f64 {
        let y = Limbs::new(to_units(y, -(FACTOR_BITS as i32)));
        // beyond the range only where the series does not converge
        let next = |sum, k| y.times::<FACTOR_BITS>(sum) + term(self.coefficient(k), k);
        ldexp((1..terms).rev().fold(0, next) as f64, self.exponent)
    }

    /// Upper bound on Σ |c| yᵏ at y = 1/4, without the constant.
    pub(super) fn bound_at_quarter(&self, terms: usize) -> f32 {
        let coefficients = self.coefficients.get(1..terms).unwrap_or_default().iter().rev();
        let sum = coefficients.fold(0, |sum: u32, c| ((sum + 3) >> 2) + c.high.unsigned_abs() + 1);
        0.25 * ((1_u32 << LIMB_BITS) as f32 * sum as f32 * power_of_two(self.exponent) as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number beyond the range is seen before it can cancel with another, whatever its sign.
    #[test]
    fn numbers_beyond_the_range_do_not_cancel() {
        for (upper, shift) in [
            (OUT_OF_RANGE, 60),
            (2 * OUT_OF_RANGE, 61),
            (-OUT_OF_RANGE - 1, 60),
            (1 << 40, 33),
            (-(1 << 40), 33),
        ] {
            let quotient = shifted_sum(upper, 0, shift);
            assert_eq!(sum_in_range([quotient, -quotient / 2]), None, "{upper:x}");
        }
        let limit = OUT_OF_RANGE / 2;
        assert_eq!(sum_in_range([limit, -limit]), Some(0));
        let eight = UnitFactor::new(8.0, &PowerSeries::ZERO, &PowerSeries::ZERO);
        for value in [limit, -limit] {
            assert_eq!(sum_in_range([eight.times(value), -value]), None, "{value}");
        }
    }

    /// Sums in words round like wide integers, also where one leaves the range.
    #[test]
    fn sums_round_in_words_as_a_whole() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut seen = [0; 3];
        for _ in 0..if cfg!(miri) { 300 } else { 100_000 } {
            bits = crate::integer::next_random(bits);
            let (upper, lower) = (bits as i64 >> (5 + bits % 56), (bits >> 34) as u32);
            let shift = MIN_SHIFT + (bits >> 40) as i32 % 90;
            let sum = (i128::from(upper) << (2 * LIMB_BITS)) + (i128::from(lower) << LIMB_BITS);
            let exact = ((sum >> (shift - 1)) + 1) >> 1;
            let (found, in_range) =
                (shifted_sum(upper, lower, shift), exact.abs() < i128::from(OUT_OF_RANGE));
            assert!(!in_range || i128::from(found) == exact, "{upper} {lower} {shift}: {found}");
            assert_eq!(
                has_bits(found, BITS + 3),
                in_range || exact == i128::from(-OUT_OF_RANGE),
                "{upper} {lower} {shift}"
            );
            seen[usize::from(found != 0) + usize::from(!in_range)] += 1;
        }
        assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
    }
}

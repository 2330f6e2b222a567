//! Power series with integer coefficients of a common exponent, and their products.
//!
//! A sum of products is exact and costs a 32-bit processor four multiplications for each pair of coefficients, where
//! emulated `f64` arithmetic costs 150 instructions. The coefficients of a converging series do not grow, so that all
//! of them share the exponent of the first ones.

use core::ops::Range;

use crate::phase::integer_parts;
use crate::product::signed_product;
use crate::scalar::{exponent, short_power_of_two};

/// Largest number of terms of a series; fewer are computed where the terms fall below the resolution of the scalar.
/// The segments of a table are short compared with the radius of convergence: where degree 5 leaves an error of 3e-8,
/// sixteen terms leave 1e-10; where degree 9 or more leaves 1e-16, they leave only rounding.
pub(crate) const TERMS: usize = 16;

/// Number of bits of a coefficient of the expected magnitude. A coefficient may be four times as large: then a sum of
/// 16 products and its three parts stay in range.
pub(crate) const BITS: i32 = 56;

/// Largest magnitude of a coefficient.
const LIMIT: i64 = 1 << (BITS + 2);

/// Bits of the lower part of a coefficient.
const LOW_BITS: u32 = 30;

/// Integer as high · 2^30 + low, with low in [0, 2^30): the parts of which products are made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Split {
    high: i32,
    low: i32,
}

impl Split {
    pub(crate) const ZERO: Self = Self { high: 0, low: 0 };

    pub(crate) const fn of(value: i64) -> Self {
        Self { high: (value >> LOW_BITS) as i32, low: value as i32 & ((1 << LOW_BITS) - 1) }
    }

    #[inline(always)]
    pub(crate) const fn value(self) -> i64 {
        ((self.high as i64) << LOW_BITS) + self.low as i64
    }
}

/// Sum of the products of pairs, at most 16 of them, divided by 2^shift and rounded to the nearest. The sum is exact; a
/// quotient beyond the range becomes the largest that is not a coefficient.
#[inline(always)]
fn inner<'a>(pairs: impl Iterator<Item = (&'a Split, &'a Split)>, shift: i32) -> i64 {
    if cfg!(target_pointer_width = "64") {
        let sum = pairs.fold(0, |sum, (a, b)| sum + i128::from(a.value()) * i128::from(b.value()));
        return rounded(sum, shift);
    }
    let (upper, across, lower) = pairs.fold((0_i64, 0_i64, 0_u64), |(upper, across, lower), (a, b)| {
        (
            upper + signed_product(a.high, b.high),
            across + signed_product(a.high, b.low) + signed_product(a.low, b.high),
            lower + signed_product(a.low, b.low) as u64,
        )
    });
    rounded_parts(upper, across + (lower >> LOW_BITS) as i64, shift)
}

/// Least shift of a quotient in range; a smaller one is of a series that does not converge.
const LEAST_SHIFT: i32 = 33;
/// Least shift with which the sum of the products of a higher and a lower part gives no quotient beyond the range.
const LEAST_COMMON_SHIFT: i32 = 40;
/// Positive and negative quotient that are not in range: the first numbers beyond 60 bits.
const BEYOND: i64 = 2 * LIMIT;
const BELOW: i64 = -BEYOND - 1;

/// Sum divided by 2^shift, rounded to the nearest.
fn rounded(sum: i128, shift: i32) -> i64 {
    if shift < LEAST_SHIFT {
        return if sum >> LOW_BITS == 0 { 0 } else { BEYOND };
    }
    let twice = sum >> (shift - 1).min(127);
    ((twice + 1) >> 1).clamp(BELOW.into(), BEYOND.into()) as i64
}

/// [`rounded`] of upper · 2^60 + across · 2^30 and 30 lower bits, in words of 64 bits: shifts of 128 bits would cost a
/// chip more than the products. |across| is below 2^63, and |upper| is below 2^62.
#[inline(always)] // its only caller is Block::product
fn rounded_parts(upper: i64, across: i64, shift: i32) -> i64 {
    let twice = match shift {
        61.. => match (upper + (across >> LOW_BITS), shift - 61) {
            (sum, 0) => sum,
            (sum, more @ ..32) => over_power(sum, more),
            (sum, more) => i64::from((sum >> 32) as i32 >> (more - 32).min(31)),
        },
        LEAST_SHIFT.. => {
            // whether upper is below 2^(shift - 1)
            let word = (upper >> 32) as i32;
            if word >> (shift - 33) != word >> 31 {
                return if word < 0 { BELOW } else { BEYOND };
            }
            // the lower word ends above the bits that are dropped
            let twice = times_power(upper, 61 - shift) + over_power(across, shift - 31);
            if shift >= LEAST_COMMON_SHIFT {
                return (twice >> 1) + (twice & 1);
            }
            twice
        }
        _ => return if (upper << LOW_BITS) + across == 0 { 0 } else { BEYOND },
    };
    ((twice >> 1) + (twice & 1)).clamp(BELOW, BEYOND)
}

/// Number · 2^exponent for an exponent from 1 to 31, with two words of 32 bits: a chip takes half of the instructions for a shift by
/// up to 63 bits.
#[inline(always)]
pub(crate) fn times_power(number: i64, exponent: i32) -> i64 {
    let (high, low) = ((number >> 32) as u32, number as u32);
    let high = (high << exponent) | (low >> (32 - exponent));
    (i64::from(high as i32) << 32) | i64::from(low << exponent)
}

/// Number / 2^exponent, rounded down: see [`times_power`].
#[inline(always)]
pub(crate) fn over_power(number: i64, exponent: i32) -> i64 {
    let (high, low) = ((number >> 32) as i32, number as u32);
    let low = (low >> exponent) | ((high as u32) << (32 - exponent));
    (i64::from(high >> exponent) << 32) | i64::from(low)
}

/// Product of two integers divided by 2^SHIFT, for a SHIFT of 54 to 60, rounded to the nearest. Shifts by a constant cost a
/// chip a third of the others.
#[inline(never)] // a call: set-up multiplies in some thirty places
pub(crate) fn scaled_product<const SHIFT: u32>(a: Split, b: Split) -> i64 {
    if cfg!(target_pointer_width = "64") {
        let product = i128::from(a.value()) * i128::from(b.value());
        return (((product >> (SHIFT - 1)) + 1) >> 1) as i64;
    }
    let lower = signed_product(a.low, b.low) >> LOW_BITS;
    let across = signed_product(a.high, b.low) + signed_product(a.low, b.high) + lower;
    let half = 1 << (SHIFT - LOW_BITS - 1);
    (signed_product(a.high, b.high) << (2 * LOW_BITS - SHIFT)) + ((across + half) >> (SHIFT - LOW_BITS))
}

/// Whether a number has at most this number of bits besides its sign: from -2^bits to 2^bits - 1, for at least 32 bits.
#[inline(always)]
const fn has_bits(value: i64, bits: i32) -> bool {
    // only the upper word counts, so that a chip compares one word
    matches!((value >> 32) as i32 >> (bits - 32), -1 | 0)
}

/// Whether a number is small enough for a coefficient. Otherwise the series does not converge.
#[inline(always)]
const fn is_in_range(value: i64) -> bool {
    has_bits(value, BITS + 2)
}

/// The number itself; `None` if it is too large for a coefficient, so that the series does not converge.
pub(crate) fn in_range(value: i64) -> Option<i64> {
    is_in_range(value).then_some(value)
}

/// Sum of quotients; `None` where one of them has left the range, so that the series does not converge. Without this check two
/// quotients beyond the range could cancel.
#[inline(always)]
pub(crate) fn sum_in_range<const N: usize>(quotients: [i64; N]) -> Option<i64> {
    quotients.iter().all(|quotient| has_bits(*quotient, BITS + 3)).then(|| quotients.iter().sum())
}

/// Constant factor between two series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factor {
    /// Factor in units of 2^(`doublings` - 60).
    mantissa: Split,
    doublings: u32,
}

/// Fraction bits of the mantissa of a [`Factor`].
const FACTOR_BITS: i32 = 60;

impl Factor {
    pub(crate) const ZERO: Self = Self { mantissa: Split::ZERO, doublings: 0 };

    /// Factor from a series with the exponent `from` to one with the exponent `to`. The expected magnitude of the
    /// second is at least that of the product, so that the factor is at most about 1 and has 60 bits after the point.
    pub(crate) fn new(factor: f64, from: i32, to: i32) -> Self {
        let (mantissa, exponent) = integer_parts(factor);
        let shift = exponent + from - to + FACTOR_BITS;
        // 53 bits become 60 at most
        let doublings = (shift - (FACTOR_BITS - 53)).clamp(0, 62);
        let mantissa = match shift - doublings {
            shift @ 0.. => mantissa << shift.min(FACTOR_BITS - 53),
            shift @ -62.. => ((mantissa >> (-shift - 1)) + 1) >> 1,
            _ => 0,
        };
        Self { mantissa: Split::of(mantissa), doublings: doublings as u32 }
    }

    /// Product, rounded to the nearest; beyond the range it becomes the largest that is not a coefficient.
    pub(crate) fn times(&self, value: i64) -> i64 {
        let product = scaled_product::<{ FACTOR_BITS as u32 }>(self.mantissa, Split::of(value));
        if self.doublings == 0 {
            return product;
        }
        let limit = BEYOND >> self.doublings;
        product.clamp(-limit - 1, limit + 1).saturating_mul(1 << self.doublings).clamp(BELOW, BEYOND)
    }
}

/// Integral of a term c y^k: the quotient c/(k + 1), rounded to the nearest. A product costs much less than a division
/// on a chip without a divider.
pub(crate) fn integrated(c: i64, k: usize) -> i64 {
    /// 1/(k + 1), rounded, in units of 2^-60.
    #[allow(clippy::indexing_slicing)]
    static INVERSES: [Split; TERMS] = {
        let mut inverses = [Split::ZERO; TERMS];
        let mut k = 0;
        while k < TERMS {
            let divisor = k as i64 + 1;
            inverses[k] = Split::of(((1 << 60) + divisor / 2) / divisor);
            k += 1;
        }
        inverses
    };
    INVERSES.get(k).map_or(0, |inverse| scaled_product::<60>(*inverse, Split::of(c)))
}

/// Integer nearest to x / 2^exponent, for a quotient below 2^62.
#[inline(never)]
pub(crate) fn scaled(x: f64, exponent: i32) -> i64 {
    let (mantissa, own) = integer_parts(x);
    match own.saturating_sub(exponent) {
        10.. => {
            if mantissa < 0 {
                -(1 << 62)
            } else if mantissa > 0 {
                1 << 62
            } else {
                0
            }
        }
        shift @ 0.. => mantissa << shift,
        shift @ -62.. => ((mantissa >> (-shift - 1)) + 1) >> 1,
        _ => 0,
    }
}

/// Coefficients of 1, x, x², ..., in units of 2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    coefficients: [Split; TERMS],
    pub(crate) exponent: i32,
}

impl Block {
    pub(crate) const ZERO: Self = Self { coefficients: [Split::ZERO; TERMS], exponent: -BITS };

    /// Sets the exponent for coefficients that are expected to be at most `magnitude`. Those before are meaningless then, and remain
    /// until they are replaced.
    pub(crate) fn scale_for(&mut self, magnitude: f64) {
        self.exponent = exponent(magnitude).max(-900) - BITS;
    }

    pub(crate) fn get(&self, k: usize) -> i64 {
        self.coefficients.get(k).map_or(0, |coefficient| coefficient.value())
    }

    /// Stores a coefficient. Returns whether it is in range; otherwise the series does not converge.
    #[must_use]
    pub(crate) fn put(&mut self, k: usize, value: i64) -> bool {
        if let Some(coefficient) = self.coefficients.get_mut(k) {
            *coefficient = Split::of(value);
        }
        is_in_range(value)
    }

    /// Unit of the coefficients; 0 or infinity beyond the range of `f32`.
    pub(crate) fn short_unit(&self) -> f32 {
        short_power_of_two(self.exponent)
    }

    /// Coefficient of x^k of a product of two series, from these terms of the first one, divided by 2^shift.
    #[inline(never)] // a call: set-up multiplies series in a dozen places
    pub(crate) fn product(&self, other: &Self, terms: Range<usize>, k: usize, shift: i32) -> i64 {
        let first = terms.start;
        let ours = self.coefficients.get(terms).unwrap_or_default();
        // the iteration ends with the terms of the first series
        let theirs = other.coefficients.get(..=k.saturating_sub(first)).unwrap_or_default();
        inner(ours.iter().zip(theirs.iter().rev()), shift)
    }

    /// Sum Σ c yʲ⁻¹ over the coefficients j from 1 to `terms` - 1, for y = `quarters`/4 < 1. It is at most four times the largest
    /// coefficient.
    pub(crate) fn at_quarters(&self, quarters: i32, terms: usize) -> i64 {
        let quarters = i64::from(quarters);
        let coefficients = self.coefficients.get(1..terms).unwrap_or_default();
        coefficients.iter().rev().fold(0, |sum, c| ((sum * quarters + 2) >> 2) + c.value())
    }

    /// Upper bound on the sum Σ |c| yʲ⁻¹ over these coefficients, from their upper words.
    pub(crate) fn size_at_quarters(&self, quarters: u32, terms: usize) -> f32 {
        /// Unit of the upper words, in units of the coefficients.
        const UNIT: f32 = (1_u32 << LOW_BITS) as f32;
        let coefficients = self.coefficients.get(1..terms).unwrap_or_default();
        let sum = coefficients
            .iter()
            .rev()
            .fold(0, |sum: u32, c| ((sum * quarters + 3) >> 2) + c.high.unsigned_abs() + 1);
        UNIT * sum as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quotient beyond the range is seen before it can cancel with another, whatever its sign.
    #[test]
    fn quotients_beyond_the_range_do_not_cancel() {
        let unit = i128::from(BEYOND) << 60;
        for sum in [unit, 4 * unit, -unit - (1 << 60), -4 * unit] {
            let quotient = rounded(sum, 60);
            assert_eq!(sum_in_range([quotient, -quotient / 2]), None, "{sum:x}");
        }
        let factor = Factor::new(8.0, 0, 0);
        for value in [LIMIT, -LIMIT] {
            assert_eq!(sum_in_range([factor.times(value), -value]), None, "{value}");
        }
        assert_eq!(sum_in_range([LIMIT, -LIMIT]), Some(0));
    }

    /// The words of a chip round like the wide integers of a PC, also where a quotient leaves the range.
    #[test]
    fn sums_round_in_parts_as_a_whole() {
        let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
        let mut seen = [0; 3];
        for _ in 0..if cfg!(miri) { 300 } else { 100_000 } {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let number = |bits: u64| bits as i64 >> (7 + bits % 50);
            let (a, b) = (Split::of(number(bits)), Split::of(number(bits.rotate_left(32))));
            let shift = 30 + (bits >> 40) as i32 % 100;
            let (mut upper, mut across) = (signed_product(a.high, b.high), signed_product(a.high, b.low));
            across += signed_product(a.low, b.high) + (signed_product(a.low, b.low) >> LOW_BITS);
            // also as a sum that nearly cancels
            if bits & 4 == 0 {
                (upper, across) = (upper - 1, across + (1 << LOW_BITS));
            }
            let sum = (i128::from(upper) << (2 * LOW_BITS)) + (i128::from(across) << LOW_BITS);
            let found = rounded_parts(upper, across, shift);
            assert_eq!(found, rounded(sum, shift), "{upper} {across} {shift}");
            seen[usize::from(found != 0) + usize::from(found.abs() >= BEYOND)] += 1;
        }
        assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
    }
}

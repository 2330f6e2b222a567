//! Power series with integer coefficients of a common exponent, and their products.
//!
//! A sum of products is exact and costs a 32-bit processor four multiplications for each pair of coefficients. The coefficients of a
//! converging series do not grow, so that all of them share an exponent.

use core::ops::Range;

use crate::phase::integer_parts;
use crate::scalar::{exponent, short_power_of_two};
use crate::table::series::integers::{
    BELOW, BEYOND, BITS, LOW_BITS, Split, TERMS, inner, is_in_range, scaled_product,
};

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
    /// Factor from a series with the exponent `from` to one with the exponent `to`.
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

    /// Product, rounded to the nearest; [`BEYOND`] marks overflow.
    pub(crate) fn times(&self, value: i64) -> i64 {
        let product = scaled_product::<{ FACTOR_BITS as u32 }>(self.mantissa, Split::of(value));
        if self.doublings == 0 {
            return product;
        }
        let limit = BEYOND >> self.doublings;
        product.clamp(-limit - 1, limit + 1).saturating_mul(1 << self.doublings).clamp(BELOW, BEYOND)
    }
}

/// Integral of a term c y^k: the quotient c/(k + 1), rounded to the nearest.
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

/// Coefficients of 1, x, x², ..., in units of 2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    coefficients: [Split; TERMS],
    pub(crate) exponent: i32,
}

impl Block {
    pub(crate) const ZERO: Self = Self { coefficients: [Split::ZERO; TERMS], exponent: 0 };

    /// Sets the exponent for coefficients that are expected to be at most `magnitude`.
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

    /// Sum Σ c yʲ⁻¹ over the coefficients j from 1 to `terms` - 1, for y = `quarters`/4 < 1.
    pub(crate) fn at_quarters(&self, quarters: u32, terms: usize) -> i64 {
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
    use crate::table::series::integers::sum_in_range;

    #[test]
    fn a_product_beyond_the_range_does_not_cancel() {
        let (factor, limit) = (Factor::new(8.0, 0, 0), BEYOND / 2);
        for value in [limit, -limit] {
            assert_eq!(sum_in_range([factor.times(value), -value]), None, "{value}");
        }
    }
}

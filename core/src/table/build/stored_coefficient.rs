//! Coefficients as a table stores them, rounded from polynomials in units of 2^-62.

use crate::integer::shifted_right;
use crate::table::evaluation::{Coefficient, is_by_16_bits};

/// Fraction bits of the polynomials from which the coefficients are rounded.
pub(super) const TABLE_BITS: u32 = 62;
/// Unit of these polynomials, 2^-62.
pub(super) const TABLE_UNIT: f64 = 1.0 / (1_u64 << TABLE_BITS) as f64;

/// Coefficient that a set-up can store.
pub trait StoredCoefficient: Coefficient {
    /// Coefficient of x^power nearest to a value in units of 2^-62.
    fn nearest(value: i64, power: usize) -> Self;
    /// Error that products by 16 bits of x cause beyond their part of a tick, both in units of 2^-62; infinite where a sum could overflow.
    fn product_error(polynomial: &[i64]) -> f32;
}

impl StoredCoefficient for f64 {
    fn nearest(value: i64, _: usize) -> Self {
        value as f64 * TABLE_UNIT
    }

    fn product_error(_: &[i64]) -> f32 {
        0.0
    }
}

/// Error of products by 16 bits of x that counts as part of a tick, in units of 2^-62: 2^-31.
const ACCEPTED_ERROR: f32 = (1_u32 << 31) as f32;

impl StoredCoefficient for i32 {
    /// Coefficient with half a unit more, because the product added to it is rounded down. The constant has none: a complement changes its
    /// sign.
    fn nearest(value: i64, power: usize) -> Self {
        let dropped = TABLE_BITS - 31 - power as u32;
        let rounded = if power == 0 { shifted_right(value, dropped) } else { (value >> dropped) + 1 };
        rounded.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }

    fn product_error(polynomial: &[i64]) -> f32 {
        /// Least sum that could overflow: 1 minus 2^-15 and some thousand roundings of a coefficient.
        const OVERFLOW: i64 = overflow_limit(3.2e-5);
        let Some(factors) = truncated_factors(polynomial, OVERFLOW) else { return f32::INFINITY };
        // from units of 2^-30, times the truncation of x to 2^-15
        let error = factors as f32 * (1_u32 << (TABLE_BITS - 30 - 15)) as f32;
        if error > ACCEPTED_ERROR { error - ACCEPTED_ERROR } else { 0.0 }
    }
}

#[cfg(feature = "fixed")]
impl StoredCoefficient for i16 {
    fn nearest(value: i64, power: usize) -> Self {
        /// Factor 1 - 9.4e-6 of the coefficients, in units of 2^-30. The 16-bit sines are up to 1.9e-5 too large; this halves the error.
        const SHRINK: i64 = (1 << 30) - 10093;
        let dropped = TABLE_BITS - 15 - power as u32;
        // 2^-30 of the value's unit is far below the rounding
        let shrunk = (value >> 30) * SHRINK;
        shifted_right(shrunk, dropped).clamp(i16::MIN.into(), i16::MAX.into()) as i16
    }

    fn product_error(polynomial: &[i64]) -> f32 {
        /// Least sum that could overflow: 1 minus about thirty roundings of a coefficient.
        const OVERFLOW: i64 = overflow_limit(1e-3);
        truncated_factors(polynomial, OVERFLOW).map_or(f32::INFINITY, |_| 0.0)
    }
}

/// 1 minus `margin`, in units of 2^-62.
const fn overflow_limit(margin: f64) -> i64 {
    ((1.0 - margin) * (1_i64 << TABLE_BITS) as f64) as i64
}

/// Sum of the bounds of all products by 16 bits of x, in units of 2^-30; `None` where a sum could exceed `limit`.
fn truncated_factors(polynomial: &[i64], limit: i64) -> Option<u32> {
    let limit = (limit >> 32) as u32;
    let mut sum = 0_u32;
    let mut factors = 0;
    for (power, value) in polynomial.iter().enumerate().skip(1).rev() {
        // rounded up; a sum that is not too large has room for another coefficient
        sum += (value.unsigned_abs() >> 32) as u32 + 1;
        if sum > limit >> power {
            return None;
        }
        if is_by_16_bits(power, polynomial.len()) {
            factors += sum;
        }
    }
    Some(factors)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Polynomial in units of 2^-62.
    fn polynomial_q62<const N: usize>(values: [f64; N]) -> [i64; N] {
        values.map(|value| (value / TABLE_UNIT) as i64)
    }

    /// With six terms the products with the fourth and the fifth power are short, and the sum of the lower one
    /// contains both.
    #[test]
    fn what_16_bit_products_lose() {
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 2e-13, "{found:e} {expected:e}");
        let error = |values| TABLE_UNIT * f64::from(i32::product_error(&polynomial_q62(values)));
        let accepted = TABLE_UNIT * f64::from(ACCEPTED_ERROR);
        // in range, but the short products are not accurate enough
        near(error([0.0, 0.0, 0.0, 0.0, 0.02, 0.01]), 0.04 / 32768.0 - accepted);
        near(error([0.9, 0.3, 0.05, 0.02, -0.03, 0.01]), 0.05 / 32768.0 - accepted);
        assert_eq!(error([0.9, 0.3, 0.05, 0.02, 0.0, 1e-9]), 0.0);
        assert_eq!(error([0.0, 0.0, 0.0, 0.0, 0.02, 0.04]), f64::INFINITY);
    }

    #[test]
    fn a_coefficient_is_within_a_unit() {
        for power in 0..16 {
            for value in [0.2, -0.2, 1e-9, 0.0].map(|value| value * 0.5_f64.powi(power)) {
                let [value] = polynomial_q62([value]);
                let stored = f64::from(i32::nearest(value, power as usize)) * 2_f64.powi(-31 - power);
                let error = stored - value as f64 * 2_f64.powi(-62);
                assert!(error.abs() <= 2_f64.powi(-31 - power), "{power} {value}");
            }
        }
        assert_eq!(i32::nearest(i64::MAX, 1), i32::MAX);
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn sums_stay_below_their_powers_by_a_margin() {
        assert_eq!(i16::product_error(&polynomial_q62([0.9, 0.4994, 0.0])), 0.0);
        assert_eq!(i16::product_error(&polynomial_q62([0.9, 0.4996, 0.0])), f32::INFINITY);
        assert_eq!(i16::product_error(&polynomial_q62([0.9, 0.2, -0.2499, 0.0])), f32::INFINITY);
    }
}

//! Integer coefficients of `f32` and of 32-bit fixed point, and the errors that they cause.
//!
//! A coefficient of x^k is stored as c·2^(31+k): see [`super::integer`].

use crate::law::series::over_power;

/// Largest error of a polynomial from short products that set-up does not count as an error of the table, in units of 2^-62:
/// 2^-31.
const SHORT_ERROR: f32 = (1_u32 << 31) as f32;

/// Least sum that could overflow, with a margin of 2^-15 plus some thousand roundings of a coefficient.
const OVERFLOW: i64 = overflow_limit(3.2e-5);

/// Fraction bits of the values that coefficients are made from.
pub(crate) const TABLE_BITS: u32 = 62;

/// Coefficient of x^power nearest to a value in units of 2^-62, and its error in these units, which has no meaning if the coefficient is
/// out of range. The coefficient includes half a unit, because the product that is added to it is rounded down. The constant coefficient
/// has no such half unit: the last sum is then half a unit low, and [`super::integer::alpha_beta`] can negate it by a bitwise
/// complement, without a carry.
pub(crate) fn nearest(value: i64, power: usize) -> (i32, i64) {
    let dropped = TABLE_BITS - 31 - power as u32;
    let rounded = if power == 0 {
        over_power(value, dropped as i32 - 1).saturating_add(1) >> 1
    } else {
        over_power(value, dropped as i32) + 1
    };
    let held = rounded.clamp(i32::MIN.into(), i32::MAX.into());
    // both are equal modulo 2^32 up to the error, which is smaller
    (held as i32, ((held as i32) << dropped).wrapping_sub(value as i32).into())
}

/// Value of a coefficient that [`nearest`] returned, with one rounding: the division by a power of two is exact.
pub(crate) fn number(coefficient: i32, power: usize) -> f32 {
    coefficient as f32 * (UNIT_OF_FIRST / (1_u32 << power) as f32)
}

/// Unit of the coefficients of x⁰, 2^-31.
const UNIT_OF_FIRST: f32 = 1.0 / (1_u32 << 31) as f32;

/// Whether 16 bits of x are enough for a sum that is multiplied by this power of x.
#[inline(always)]
pub(crate) const fn is_short(power: usize, terms: usize) -> bool {
    2 * power > terms
}

/// Least sum that could overflow: 1 minus `margin`, in units of 2^-62.
pub(crate) const fn overflow_limit(margin: f64) -> i64 {
    ((1.0 - margin) * (1_i64 << TABLE_BITS) as f64) as i64
}

/// Error of a polynomial that its coefficients cause, in the units of its coefficients, 2^-62: infinite where a sum could overflow,
/// otherwise the part of the error of short products that is above [`SHORT_ERROR`].
pub(crate) fn error(polynomial: &[i64]) -> f32 {
    let Some(factors) = short_factors(polynomial, OVERFLOW) else { return f32::INFINITY };
    // from units of 2^-30, times the truncation of x to 2^-15
    let error = factors as f32 * (1_u32 << (TABLE_BITS - 30 - 15)) as f32;
    if error > SHORT_ERROR { error - SHORT_ERROR } else { 0.0 }
}

/// Infinite where a sum of the polynomial could overflow, with a margin for the rounding of the coefficients, because
/// the error after an overflow is unbounded; otherwise 0.
pub(crate) fn overflow(polynomial: &[i64], limit: i64) -> f32 {
    short_factors(polynomial, limit).map_or(f32::INFINITY, |_| 0.0)
}

/// Upper bound on the sum of the factors of x in short products, in units of 2^-30; `None` where a sum of the polynomial could exceed
/// `limit`.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::series::UNIT;

    /// With six terms the products with the fourth and the fifth power are short, and the sum of the lower one
    /// contains both.
    #[test]
    fn what_short_products_lose() {
        let near =
            |found: f64, expected: f64| assert!((found - expected).abs() < 2e-13, "{found:e} {expected:e}");
        let error = |values| UNIT * f64::from(error(&polynomial(values)));
        let accepted = UNIT * f64::from(SHORT_ERROR);
        // in range, but the short products are not accurate enough
        near(error([0.0, 0.0, 0.0, 0.0, 0.02, 0.01]), 0.04 / 32768.0 - accepted);
        near(error([0.9, 0.3, 0.05, 0.02, -0.03, 0.01]), 0.05 / 32768.0 - accepted);
        assert_eq!(error([0.9, 0.3, 0.05, 0.02, 0.0, 1e-9]), 0.0);
        assert_eq!(error([0.0, 0.0, 0.0, 0.0, 0.02, 0.04]), f64::INFINITY);
    }

    #[test]
    fn sums_stay_below_their_powers_by_a_margin() {
        let limit = overflow_limit(1e-3);
        assert_eq!(overflow(&polynomial([0.9, 0.4994, 0.0]), limit), 0.0);
        assert_eq!(overflow(&polynomial([0.9, 0.4996, 0.0]), limit), f32::INFINITY);
        assert_eq!(overflow(&polynomial([0.9, 0.2, -0.2499, 0.0]), limit), f32::INFINITY);
    }

    #[test]
    fn a_coefficient_knows_its_error() {
        for power in 0..16 {
            for value in [0.2, -0.2, 1e-9, 0.0].map(|value| value * 0.5_f64.powi(power)) {
                let [value] = polynomial([value]);
                let (held, error) = nearest(value, power as usize);
                let truth = f64::from(held) * 2_f64.powi(-31 - power) - value as f64 * 2_f64.powi(-62);
                assert!((error as f64 * 2_f64.powi(-62) - truth).abs() < 1e-16, "{power} {value}");
                assert!(truth.abs() <= 2_f64.powi(-31 - power));
            }
        }
        assert_eq!(nearest(i64::MAX, 1).0, i32::MAX);
    }

    /// The value has the one rounding of the coefficient to 24 bits.
    #[test]
    fn the_value_of_a_coefficient_is_rounded_once() {
        for power in 0..16 {
            for held in [0, 1, -1, 77_777_777, -2_000_000_001, i32::MAX, i32::MIN] {
                let exact = f64::from(held) * 2_f64.powi(-31 - power);
                assert_eq!(number(held, power as usize), exact as f32, "{held} {power}");
            }
        }
    }

    fn polynomial<const N: usize>(values: [f64; N]) -> [i64; N] {
        values.map(|value| (value * 2_f64.powi(62)) as i64)
    }
}

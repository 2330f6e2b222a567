//! Rounding of polynomials to the coefficients of a table, and the errors of products by 16 bits of x.

/// Fraction bits of the polynomials from which the coefficients are rounded.
pub(in crate::table) const TABLE_BITS: u32 = 62;
/// Unit of these polynomials, 2^-62.
pub(in crate::table) const TABLE_UNIT: f64 = 1.0 / (1_u64 << TABLE_BITS) as f64;

/// Whether 16 bits of x are enough for this power.
#[inline(always)]
pub(super) const fn is_by_16_bits(power: usize, terms: usize) -> bool {
    2 * power > terms
}

/// 1 minus `margin`, in units of 2^-62.
pub(super) const fn overflow_limit(margin: f64) -> i64 {
    ((1.0 - margin) * (1_i64 << TABLE_BITS) as f64) as i64
}

/// Sum of the bounds of all products by 16 bits of x, in units of 2^-30; `None` where a sum could exceed `limit`.
pub(super) fn truncated_factors(polynomial: &[i64], limit: i64) -> Option<u32> {
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

/// Polynomial in units of 2^-62.
#[cfg(test)]
pub(super) fn polynomial_q62<const N: usize>(values: [f64; N]) -> [i64; N] {
    values.map(|value| (value / TABLE_UNIT) as i64)
}

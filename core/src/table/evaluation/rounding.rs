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

/// Upper bound on a sum of Horner's rule, in units of 2^-31: its coefficient plus half of the sum before, rounded up. `None` where a tick could
/// overflow.
pub(in crate::table) const fn next_sum(coefficient: u32, before: u32) -> Option<u32> {
    /// Least sum from which the smallest chip cannot compute a product by halves.
    const OVERFLOW: u32 = (1 << 31) - (1 << 15);
    let sum = coefficient.saturating_add(before.div_ceil(2));
    if sum < OVERFLOW { Some(sum) } else { None }
}

/// Sum of the upper bounds of all products by 16 bits of x, in units of 2^-30; `None` where a sum could overflow.
///
/// * `rounded`: coefficient of a power in units of 2^-31, from its value
pub(super) fn short_product_bound(polynomial: &[i64], rounded: impl Fn(i64, usize) -> i64) -> Option<u32> {
    let mut sum = 0;
    let mut bound = 0;
    for (power, &value) in polynomial.iter().enumerate().skip(1).rev() {
        let coefficient = rounded(value, power).unsigned_abs();
        sum = next_sum(u32::try_from(coefficient).ok()?, sum)?;
        if is_by_16_bits(power, polynomial.len()) {
            bound += (sum >> (power + 1)) + 1;
        }
    }
    Some(bound)
}

/// Polynomial in units of 2^-62.
#[cfg(test)]
pub(super) fn polynomial_q62<const N: usize>(values: [f64; N]) -> [i64; N] {
    values.map(|value| (value / TABLE_UNIT) as i64)
}

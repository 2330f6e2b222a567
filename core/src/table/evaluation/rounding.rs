//! Rounding of polynomials to the coefficients of a table, and the range of the sums of Horner's rule.

/// Fraction bits of the polynomials from which the coefficients are rounded.
pub(in crate::table) const TABLE_BITS: u32 = 62;
/// Unit of these polynomials, 2^-62.
pub(in crate::table) const TABLE_UNIT: f64 = 1.0 / (1_u64 << TABLE_BITS) as f64;

/// Upper bound on a sum of Horner's rule, in units of 2^-31: its coefficient plus half of the sum before, rounded up. `None` where a tick could
/// overflow.
pub(in crate::table) const fn next_sum(coefficient: u32, before: u32) -> Option<u32> {
    let sum = coefficient.saturating_add(before.div_ceil(2));
    if sum <= i32::MAX as u32 { Some(sum) } else { None }
}

/// Whether no sum of Horner's rule can overflow. The last sum saturates.
///
/// * `rounded`: coefficient of a power in units of 2^-31, from its value
pub(super) fn sums_fit(polynomial: &[i64], rounded: impl Fn(i64, usize) -> i64) -> bool {
    let powers = polynomial.iter().enumerate().skip(1).rev();
    let coefficients = powers.map(|(power, &value)| u32::try_from(rounded(value, power).unsigned_abs()));
    let next = |before, coefficient: Result<u32, _>| next_sum(coefficient.ok()?, before);
    coefficients.into_iter().try_fold(0, next).is_some()
}

/// Polynomial in units of 2^-62.
#[cfg(test)]
pub(super) fn polynomial_q62<const N: usize>(values: [f64; N]) -> [i64; N] {
    values.map(|value| (value / TABLE_UNIT) as i64)
}

//! Ranges of the numbers of a table, within which no integer of a tick overflows. A table that a set-up makes is within them for s up to 5e29 m in
//! `f32` and fixed point, and up to 5e59 m in `f64`.

/// Largest rate, length or coefficient in `f64`. Products of three such numbers and of powers of two stay finite.
pub(in crate::table) const MAX_F64: f64 = 1e60;
/// Largest rate or length in `f32`. Only the velocity of the tip, a product of two such numbers, may become infinite.
pub(in crate::table) const MAX_F32: f64 = 1e30_f32 as f64;
/// Whether no number is NaN or of a larger size.
pub(in crate::table) const fn all_at_most(mut numbers: &[f64], greatest: f64) -> bool {
    while let [number, rest @ ..] = numbers {
        if number.is_nan() || number.abs() > greatest {
            return false;
        }
        numbers = rest;
    }
    true
}

/// Whether all numbers are finite.
pub(in crate::table) const fn all_finite(numbers: &[f64]) -> bool {
    all_at_most(numbers, f64::MAX)
}

/// Whether a tick can compute with these coefficients.
pub(in crate::table) const fn are_safe_f64(coefficients: &[f64]) -> bool {
    all_at_most(coefficients, MAX_F64)
}

/// Upper bound on a sum of Horner's rule, in units of 2^-31: its coefficient plus half of the sum before, rounded up. `None` where a tick could
/// overflow.
const fn next_sum(coefficient: u32, before: u32) -> Option<u32> {
    let sum = coefficient.saturating_add(before.div_ceil(2));
    if sum <= i32::MAX as u32 { Some(sum) } else { None }
}

/// Whether the sums of Horner's rule stay in range, from the highest power of four polynomials down. The last sum saturates.
macro_rules! sums_in_range {
    ($name:ident, $coefficient:ident, $fraction_bits:literal) => {
        pub(in crate::table) const fn $name(coefficients: &[$coefficient]) -> bool {
            let [_, _, _, _, powers @ ..] = coefficients else { return true };
            let mut powers = powers;
            let mut sums = [0; 4];
            while let [rest @ .., coefficient] = powers {
                let [a, b, c, before] = sums;
                let in_sums = (coefficient.unsigned_abs() as u32) << (31 - $fraction_bits);
                let Some(sum) = next_sum(in_sums, before) else { return false };
                (powers, sums) = (rest, [sum, a, b, c]);
            }
            true
        }
    };
}

sums_in_range!(are_safe_i32, i32, 31);
#[cfg(feature = "fixed")]
sums_in_range!(are_safe_i16, i16, 15);

//! Range checks of literal data: in a tick no sum of integers overflows, and no floating-point number becomes
//! infinite except the velocity of the tip.
//!
//! Data written by set-up always pass.

/// Largest rate, length or coefficient in `f64`. Products of three such numbers and of powers of two stay finite.
const GREATEST_DOUBLE: f64 = 1e60;
/// Largest rate or length in `f32`. Only the velocity of the tip, a product of two such numbers, may become infinite.
const GREATEST_SINGLE: f32 = 1e30;
/// Largest 32-bit sum. The smallest chip computes a product from the halves of its factors, which allows no larger sum.
const GREATEST_SUM: u64 = (1 << 31) - (1 << 15);
/// Largest 32-bit sum for 16-bit coefficients.
#[cfg(feature = "fixed")]
const GREATEST_SHORT_SUM: u64 = 1 << 31;

/// Whether no number is NaN or of a larger size.
const fn within(mut numbers: &[f64], greatest: f64) -> bool {
    while let [number, rest @ ..] = numbers {
        if number.is_nan() || number.abs() > greatest {
            return false;
        }
        numbers = rest;
    }
    true
}

/// Whether all numbers are finite.
pub(crate) const fn finite(numbers: &[f64]) -> bool {
    within(numbers, f64::MAX)
}

/// Whether a tick can compute with these rates, lengths or coefficients.
pub(crate) const fn f64(numbers: &[f64]) -> bool {
    within(numbers, GREATEST_DOUBLE)
}

/// Whether a tick can compute with these rates or lengths.
pub(crate) const fn f32(mut numbers: &[f32]) -> bool {
    while let [number, rest @ ..] = numbers {
        if number.is_nan() || number.abs() > GREATEST_SINGLE {
            return false;
        }
        numbers = rest;
    }
    true
}

/// Whether the sums of Horner's rule stay in range, from the highest power of four polynomials down. The constants are left out: the last
/// sum saturates and needs no check.
macro_rules! sums_in_range {
    ($coefficient:ident, $greatest:ident, $next:ident) => {
        pub(crate) const fn $coefficient(coefficients: &[$coefficient]) -> bool {
            let [_, _, _, _, powers @ ..] = coefficients else { return true };
            let (mut powers, mut sums) = (powers, [0; 4]);
            while let [rest @ .., coefficient] = powers {
                let [a, b, c, sum] = sums;
                let sum = $next(sum, *coefficient);
                if sum >= $greatest {
                    return false;
                }
                (powers, sums) = (rest, [sum, a, b, c]);
            }
            true
        }
    };
}

sums_in_range!(i32, GREATEST_SUM, next);
#[cfg(feature = "fixed")]
sums_in_range!(i16, GREATEST_SHORT_SUM, next_short);

/// Upper bound on the magnitude of the next sum: half of the previous sum, rounded away from 0, plus the coefficient.
const fn next(sum: u64, coefficient: i32) -> u64 {
    coefficient.unsigned_abs() as u64 + sum.div_ceil(2)
}

/// Upper bound on the magnitude of the next sum, where the 16 upper bits of the previous sum are multiplied by up to
/// 2^15.
#[cfg(feature = "fixed")]
const fn next_short(sum: u64, coefficient: i16) -> u64 {
    ((coefficient.unsigned_abs() as u64) << 16) + (((sum >> 16) + 1) << 15)
}

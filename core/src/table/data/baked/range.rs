//! Range checks of literal data: in a tick no sum of integers overflows, and no floating-point number becomes
//! infinite except the velocity of the tip.
//!
//! Data written by set-up always pass. Other data may have a correct checksum by accident or by intent.

/// Largest rate, length or coefficient in `f64`. Products of three such numbers and of powers of two stay finite.
const GREATEST_DOUBLE: f64 = 1e60;
/// Largest rate or length in `f32`. Only the velocity of the tip is a product of two such numbers; it alone may become infinite, and
/// set-up writes no such data.
const GREATEST_SINGLE: f32 = 1e30;
/// Largest 32-bit sum. The smallest chip computes a product from the halves of its factors, which allows no larger sum.
const GREATEST_SUM: u64 = (1 << 31) - (1 << 15);
/// Largest 32-bit sum for 16-bit coefficients.
#[cfg(feature = "fixed")]
const GREATEST_SHORT_SUM: u64 = 1 << 31;

/// Whether x is neither NaN nor too large.
pub(crate) const fn f64(x: f64) -> bool {
    x >= -GREATEST_DOUBLE && x <= GREATEST_DOUBLE
}

/// Whether x is neither NaN nor too large.
pub(crate) const fn f32(x: f32) -> bool {
    x >= -GREATEST_SINGLE && x <= GREATEST_SINGLE
}

/// Whether both parts of a pair are finite.
pub(crate) const fn finite([hi, lo]: [f64; 2]) -> bool {
    hi.is_finite() && lo.is_finite()
}

/// Whether all coefficients of a segment are in range.
pub(crate) const fn double_terms(mut terms: &[[f64; 4]]) -> bool {
    while let [[a, b, c, d], rest @ ..] = terms {
        if !(f64(*a) && f64(*b) && f64(*c) && f64(*d)) {
            return false;
        }
        terms = rest;
    }
    true
}

/// Whether the sums of Horner's rule on a segment stay in range, from the highest power down. The last sum saturates
/// and needs no check.
pub(crate) const fn long_terms(mut terms: &[[i32; 4]]) -> bool {
    let mut sums = [0; 4];
    while let [_, .., coefficients] = terms {
        let ([a, b, c, d], [e, f, g, h]) = (sums, *coefficients);
        sums = [after(a, e), after(b, f), after(c, g), after(d, h)];
        if !all_below(sums, GREATEST_SUM) {
            return false;
        }
        terms = shorter(terms);
    }
    true
}

/// Whether the sums of Horner's rule on a segment with coefficients of 16 bits stay in range.
#[cfg(feature = "fixed")]
pub(crate) const fn short_terms(mut terms: &[[i16; 4]]) -> bool {
    let mut sums = [0; 4];
    while let [_, .., coefficients] = terms {
        let ([a, b, c, d], [e, f, g, h]) = (sums, *coefficients);
        sums = [after_short(a, e), after_short(b, f), after_short(c, g), after_short(d, h)];
        if !all_below(sums, GREATEST_SHORT_SUM) {
            return false;
        }
        terms = shorter(terms);
    }
    true
}

/// All elements but the last.
const fn shorter<C>(terms: &[[C; 4]]) -> &[[C; 4]] {
    match terms {
        [rest @ .., _] => rest,
        [] => terms,
    }
}

const fn all_below([a, b, c, d]: [u64; 4], greatest: u64) -> bool {
    a < greatest && b < greatest && c < greatest && d < greatest
}

/// Upper bound on the magnitude of the next sum: half of the previous sum, rounded away from 0, plus the coefficient.
const fn after(sum: u64, coefficient: i32) -> u64 {
    coefficient.unsigned_abs() as u64 + sum.div_ceil(2)
}

/// Upper bound on the magnitude of the next sum, where the 16 upper bits of the previous sum are multiplied by up to
/// 2^15.
#[cfg(feature = "fixed")]
const fn after_short(sum: u64, coefficient: i16) -> u64 {
    ((coefficient.unsigned_abs() as u64) << 16) + (((sum >> 16) + 1) << 15)
}

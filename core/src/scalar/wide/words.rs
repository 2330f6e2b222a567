//! Integers of several words of 64 bits, the most significant first.

use crate::integer::{product_u32, product_u64};
use core::mem::replace;

#[inline(always)]
pub(super) fn leading(words: &[u64]) -> u64 {
    words.first().map_or(0, |word| *word)
}

/// Shifts to the left by less than 64 bits.
#[inline(always)]
pub(super) fn shift_left(words: &mut [u64], bits: u32) {
    let mut carry = 0;
    for word in words.iter_mut().rev() {
        // in two steps, because a shift by 64 bits is none
        (*word, carry) = (*word << bits | carry, *word >> 1 >> (63 - bits));
    }
}

/// Shifts to the right by any number of bits.
#[inline(always)]
pub(super) fn shift_right(words: &mut [u64], bits: u32) {
    for _ in 0..(bits / 64).min(words.len() as u32) {
        words.iter_mut().fold(0, |before, word| replace(word, before));
    }
    let mut carry = 0;
    for word in words.iter_mut() {
        (*word, carry) = (*word >> (bits % 64) | carry, *word << 1 << (63 - bits % 64));
    }
}

/// Adds another number, or subtracts it, by the operation on one word. Returns the carry.
#[inline(always)]
pub(super) fn add(words: &mut [u64], other: &[u64], operation: impl Fn(u64, u64) -> (u64, bool)) -> bool {
    words.iter_mut().zip(other).rev().fold(false, |carry, (word, other)| {
        let (sum, first) = operation(*word, *other);
        let (sum, second) = operation(sum, carry.into());
        *word = sum;
        first || second
    })
}

/// Adds one word. Returns the carry.
#[inline(always)]
pub(super) fn add_word(words: &mut [u64], other: u64) -> u64 {
    words.iter_mut().rev().fold(other, |carry, word| {
        let (sum, overflow) = word.overflowing_add(carry);
        *word = sum;
        overflow.into()
    })
}

/// Product: upper and lower half.
#[inline(always)]
pub(super) fn product<const WORDS: usize>(a: &[u64; WORDS], b: &[u64; WORDS]) -> [[u64; WORDS]; 2] {
    let mut upper = [0; WORDS];
    let mut lower = [0; WORDS];
    for (factor, complete) in b.iter().zip(&mut lower).rev() {
        let mut carry = 0;
        for (word, sum) in a.iter().zip(&mut upper).rev() {
            let [high, low] = product_u64(*word, *factor);
            let (low, first) = low.overflowing_add(*sum);
            let (low, second) = low.overflowing_add(carry);
            (*sum, carry) = (low, high + u64::from(first) + u64::from(second));
        }
        *complete = upper.iter_mut().fold(carry, |before, word| replace(word, before));
    }
    [upper, lower]
}

/// Quotient a/b of numbers with the leading bit set, times 2^(56 (WORDS + 1)).
///
/// The quotient is computed in WORDS + 1 digits of 56 bits. Each digit is at most 4 too small.
#[inline(always)]
pub(super) fn quotient<const WORDS: usize>(a: &[u64; WORDS], b: &[u64; WORDS]) -> [[u64; WORDS]; 2] {
    // at most the true one
    let inverse = reciprocal_u64(leading(b)) - 16;
    let mut above = 0;
    let mut remainder = *a;
    let mut quotient = [[0; WORDS]; 2];
    for _ in 0..=WORDS {
        above = above << 56 | leading(&remainder) >> 8;
        shift_left(&mut remainder, 56);
        let [digit, _] = product_u64(above << 5 | leading(&remainder) >> 59, inverse);
        let digit = digit >> 3;
        let borrow = remainder.iter_mut().zip(b).rev().fold(0, |borrow, (word, factor)| {
            let [high, low] = product_u64(digit, *factor);
            let (low, first) = low.overflowing_add(borrow);
            let (difference, second) = word.overflowing_sub(low);
            *word = difference;
            high + u64::from(first) + u64::from(second)
        });
        above -= borrow;
        shift_left(quotient.as_flattened_mut(), 56);
        add_word(quotient.as_flattened_mut(), digit);
    }
    quotient
}

/// Reciprocal 2^126/d of a divisor in [2^63, 2^64), with 60 correct bits, by Newton's method.
#[inline(never)]
fn reciprocal_u64(divisor: u64) -> u64 {
    let word = (divisor >> 32) as u32;
    // tells the compiler that the divisor is not 0
    let first = u32::MAX / ((word >> 16) | (1 << 15));
    // 2^48 less the product of word and inverse, which is nearly 2^48
    let remainder = (1_i64 << 48) - product_u32(word, first) as i64;
    let second = (i64::from(first) << 15) + ((i64::from(first) * (remainder >> 4)) >> 29);
    let second = u32::try_from(second).unwrap_or(u32::MAX);
    // 2^63 less the product, which is nearly 2^63
    let product = product_u32(word, second) + (product_u32(divisor as u32, second) >> 32);
    let remainder = (1_u64 << 63).wrapping_sub(product) as i64;
    let third = (u64::from(second) << 31).wrapping_add_signed((i64::from(second) * (remainder >> 6)) >> 26);
    // 2^62 less the product, which is a small number
    let remainder = (1_u64 << 62).wrapping_sub(high_product_u64(divisor, third)) as i64;
    third.wrapping_add_signed((remainder * (third >> 54) as i64) >> 8)
}

/// Inverse root 2^94/√x of a number in [2^62, 2^64), with 52 correct bits, by Newton's method.
#[inline(never)]
pub(super) fn inverse_root_u64(number: u64) -> u64 {
    let word = (number >> 32) as u32;
    // 2^30 times 2.2 - 1.2 x, whose relative error is at most a seventh
    let line = 2_362_232_012 - (product_u32(word, 1_288_490_189) >> 32) as u32;
    let short = (0..4).fold(line, |inverse, _| {
        let square = (product_u32(inverse, inverse) >> 32) as u32;
        // 2^28 times the product of number and square, which is nearly 1
        let product = (product_u32(word, square) >> 32) as u32;
        (product_u32(inverse, (3 << 28) - product) >> 29) as u32
    });
    let inverse = u64::from(short) << 32;
    let square = high_product_u64(inverse, inverse);
    // 2^60 times the product, which is nearly 1
    let product = high_product_u64(number, square);
    high_product_u64(inverse, (3 << 60) - product) << 3
}

/// Upper 64 bits of the product of two unsigned numbers.
fn high_product_u64(a: u64, b: u64) -> u64 {
    let [high, _] = product_u64(a, b);
    high
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Extended, Float, Ring};

    /// The first approximations have the stated accuracy over their whole range.
    #[test]
    fn reciprocals_and_roots_begin_well() {
        let whole = |number: u64| Extended::from_integer(number.into(), 0, false);
        let power = |exponent| Extended::from_integer(1, exponent, false);
        let (mut worst, steps) = ([0.0_f64; 2], if cfg!(miri) { 300 } else { 100_000 });
        for k in 0..=steps {
            let divisor = (1 << 63) + k * ((u64::MAX >> 1) / steps);
            let exact = power(126) / whole(divisor);
            let found = whole(reciprocal_u64(divisor));
            let number = (1 << 62) + k * ((u64::MAX - (1 << 62)) / steps);
            let root = whole(inverse_root_u64(number));
            let square = root * root * whole(number) / power(126);
            let errors =
                [found / exact - Extended::ONE, square.halved().halved() - Extended::from(2_f64.powi(60))];
            let [reciprocal, root] = errors.map(|error| error.abs().to_f64());
            worst = [worst[0].max(reciprocal), worst[1].max(root * 2_f64.powi(-61))];
        }
        assert!((1e-20..8e-19).contains(&worst[0]) && (1e-18..3e-16).contains(&worst[1]), "{worst:?}");
    }
}

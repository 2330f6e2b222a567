//! Integers of several words of 64 bits, the most significant first.

use super::newton::short_reciprocal;
use crate::product::product_of_long;

/// Leading word.
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
        words.iter_mut().fold(0, |before, word| core::mem::replace(word, before));
    }
    let mut carry = 0;
    for word in words.iter_mut() {
        (*word, carry) = (*word >> (bits % 64) | carry, *word << 1 << (63 - bits % 64));
    }
}

/// Adds another number. Returns the carry.
#[inline(always)]
pub(super) fn add(words: &mut [u64], other: &[u64]) -> bool {
    words.iter_mut().zip(other).rev().fold(false, |carry, (word, other)| {
        let (sum, first) = word.overflowing_add(*other);
        let (sum, second) = sum.overflowing_add(carry.into());
        *word = sum;
        first || second
    })
}

/// Subtracts a smaller number.
#[inline(always)]
pub(super) fn subtract(words: &mut [u64], other: &[u64]) {
    words.iter_mut().zip(other).rev().fold(false, |borrow, (word, other)| {
        let (difference, first) = word.overflowing_sub(*other);
        let (difference, second) = difference.overflowing_sub(borrow.into());
        *word = difference;
        first || second
    });
}

/// Complete product: upper and lower half.
#[inline(always)]
pub(super) fn product<const WORDS: usize>(a: &[u64; WORDS], b: &[u64; WORDS]) -> [[u64; WORDS]; 2] {
    // the product with each word of b is added to the words from there on; the lowest of them is then complete
    let (mut upper, mut lower) = ([0; WORDS], [0; WORDS]);
    for (factor, complete) in b.iter().zip(&mut lower).rev() {
        let mut carry = 0;
        for (word, sum) in a.iter().zip(&mut upper).rev() {
            let [high, low] = product_of_long(*word, *factor);
            let (low, first) = low.overflowing_add(*sum);
            let (low, second) = low.overflowing_add(carry);
            (*sum, carry) = (low, high + u64::from(first) + u64::from(second));
        }
        *complete = upper.iter_mut().fold(carry, |before, word| core::mem::replace(word, before));
    }
    [upper, lower]
}

/// Quotient a/b of numbers with the leading bit set, times 2^(56 (WORDS + 1)): digits of 56 bits, each computed from the reciprocal of
/// the leading word of b and at most 4 too small.
#[inline(always)]
pub(super) fn quotient<const WORDS: usize>(a: &[u64; WORDS], b: &[u64; WORDS]) -> [[u64; WORDS]; 2] {
    // at most the true one
    let inverse = short_reciprocal(leading(b)) - 16;
    let (mut above, mut rest, mut quotient) = (0, *a, [[0; WORDS]; 2]);
    for _ in 0..=WORDS {
        above = above << 56 | leading(&rest) >> 8;
        shift_left(&mut rest, 56);
        let [digit, _] = product_of_long(above << 5 | leading(&rest) >> 59, inverse);
        let digit = digit >> 3;
        let borrow = rest.iter_mut().zip(b).rev().fold(0, |borrow, (word, factor)| {
            let [high, low] = product_of_long(digit, *factor);
            let (low, first) = low.overflowing_add(borrow);
            let (difference, second) = word.overflowing_sub(low);
            *word = difference;
            high + u64::from(first) + u64::from(second)
        });
        above -= borrow;
        let quotient = quotient.as_flattened_mut();
        shift_left(quotient, 56);
        quotient.iter_mut().rev().fold(digit, |carry, word| {
            let (sum, overflow) = word.overflowing_add(carry);
            *word = sum;
            overflow.into()
        });
    }
    quotient
}

//! Numbers of twice as many words, which hold a product exactly.

use super::number::Wide;
use super::words::{add, leading, product, shift_left, shift_right, subtract};

/// Number ±s · 2^exponent, where the leading bit of s is set, or s is 0.
pub(super) struct Exact<const WORDS: usize> {
    /// Upper and lower half of s.
    words: [[u64; WORDS]; 2],
    exponent: i32,
    negative: bool,
}

/// Leading bit of a word.
const LEADING: u64 = 1 << 63;

impl<const WORDS: usize> From<Wide<WORDS>> for Exact<WORDS> {
    #[inline(always)]
    fn from(Wide { significand, exponent, negative }: Wide<WORDS>) -> Self {
        Self { words: [significand, [0; WORDS]], exponent, negative }
    }
}

impl<const WORDS: usize> Exact<WORDS> {
    /// Number from words that have leading zeros.
    #[inline(always)]
    pub(super) fn new(words: [[u64; WORDS]; 2], exponent: i32, negative: bool) -> Self {
        let mut number = Self { words, exponent, negative };
        number.normalise();
        number
    }

    /// Exact product.
    #[inline(always)]
    pub(super) fn product(a: &Wide<WORDS>, b: &Wide<WORDS>) -> Self {
        let mut words = product(&a.significand, &b.significand);
        let mut exponent = a.exponent + b.exponent;
        if leading(words.as_flattened()) < LEADING {
            shift_left(words.as_flattened_mut(), 1);
            exponent -= 1;
        }
        Self { words, exponent, negative: a.negative != b.negative }
    }

    /// Key of the order of magnitudes.
    #[inline(always)]
    fn magnitude(&self) -> (bool, i32, &[u64]) {
        let words = self.words.as_flattened();
        (leading(words) != 0, self.exponent, words)
    }

    #[inline(always)]
    fn normalise(&mut self) {
        let words = self.words.as_flattened_mut();
        for _ in 1..2 * WORDS {
            if leading(words) == 0 {
                words.iter_mut().rev().fold(0, |before, word| core::mem::replace(word, before));
                self.exponent -= 64;
            }
        }
        let spare = leading(words).leading_zeros() % 64;
        shift_left(words, spare);
        self.exponent -= spare as i32;
    }

    /// Sum, rounded to the nearest.
    #[inline(never)] // a call, because a copy in each operation would take much of a chip's flash
    pub(super) fn plus(self, other: Self) -> Wide<WORDS> {
        let (mut sum, mut smaller) =
            if self.magnitude() < other.magnitude() { (other, self) } else { (self, other) };
        let distance = (sum.exponent - smaller.exponent).unsigned_abs();
        shift_right(smaller.words.as_flattened_mut(), distance);
        let words = sum.words.as_flattened_mut();
        if sum.negative != smaller.negative {
            subtract(words, smaller.words.as_flattened());
            sum.normalise();
        } else if add(words, smaller.words.as_flattened()) {
            shift_right(words, 1);
            if let Some(first) = words.first_mut() {
                *first |= LEADING;
            }
            sum.exponent += 1;
        }
        sum.rounded()
    }

    /// Nearest number of half as many words.
    #[inline(always)]
    pub(super) fn rounded(self) -> Wide<WORDS> {
        let Self { words: [mut significand, below], mut exponent, negative } = self;
        if leading(&significand) == 0 {
            return Wide { significand: [0; WORDS], exponent: 0, negative: false };
        }
        let up = leading(&below) >> 63;
        let carry = significand.iter_mut().rev().fold(up, |carry, word| {
            let (sum, overflow) = word.overflowing_add(carry);
            *word = sum;
            overflow.into()
        });
        if carry != 0 {
            // all other words are 0
            significand = [0; WORDS];
            if let Some(first) = significand.first_mut() {
                *first = LEADING;
            }
            exponent += 1;
        }
        Wide { significand, exponent, negative }
    }
}

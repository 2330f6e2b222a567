//! Floating-point numbers of one or two words of 64 bits, in integers.
//!
//! In 128 bits the small differences of a launch keep their digits.

mod words;

mod arithmetic;

mod conversion;

use self::words::{add, add_word, leading, product, shift_left, shift_right};
use core::mem::replace;

/// Number ±s · 2^exponent with a significand s in [1/2, 1) of `WORDS` words. The relative error of an operation is at most
/// 1.1 · 2^(-64 WORDS).
///
/// Infinity and NaN become 0. A quotient by 0 is 0 for 0, and otherwise larger in size than every `f64`.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Wide<const WORDS: usize> {
    /// Words of s, the most significant first. The leading bit is set, or all bits of the number are 0.
    significand: [u64; WORDS],
    exponent: i32,
    negative: bool,
}

/// Number of 128 bits, some 38 digits.
pub type Extended = Wide<2>;

impl<const WORDS: usize> Wide<WORDS> {
    fn is_zero(&self) -> bool {
        leading(&self.significand) == 0
    }

    /// Number with this exponent instead; 0 stays 0.
    fn with_exponent(self, exponent: i32) -> Self {
        if self.is_zero() { self } else { Self { exponent, ..self } }
    }

    /// Product with a power of two.
    #[must_use]
    pub fn ldexp(self, exponent: i32) -> Self {
        self.with_exponent(self.exponent.saturating_add(exponent))
    }

    /// Number value · 2^(exponent - 128), rounded to the nearest, for a value with the leading bit set.
    #[allow(clippy::indexing_slicing)] // in a constant, an index out of range does not compile
    const fn constant(value: u128, exponent: i32) -> Self {
        let value = if WORDS == 1 { value + (value & 1 << 63) } else { value };
        let mut significand = [0; WORDS];
        significand[0] = (value >> 64) as u64;
        if WORDS > 1 {
            significand[1] = value as u64;
        }
        Self { significand, exponent, negative: false }
    }
}

/// Number ±s · 2^exponent with twice as many words, where the leading bit of s is set, or s is 0.
struct DoubleWidth<const WORDS: usize> {
    /// Upper and lower half of s.
    words: [[u64; WORDS]; 2],
    exponent: i32,
    negative: bool,
}

const LEADING: u64 = 1 << 63;

impl<const WORDS: usize> From<Wide<WORDS>> for DoubleWidth<WORDS> {
    #[inline(always)]
    fn from(Wide { significand, exponent, negative }: Wide<WORDS>) -> Self {
        Self { words: [significand, [0; WORDS]], exponent, negative }
    }
}

impl<const WORDS: usize> DoubleWidth<WORDS> {
    /// Number from words that have leading zeros.
    #[inline(always)]
    fn new(words: [[u64; WORDS]; 2], exponent: i32, negative: bool) -> Self {
        let mut number = Self { words, exponent, negative };
        number.normalise();
        number
    }

    #[inline(always)]
    fn product(a: &Wide<WORDS>, b: &Wide<WORDS>) -> Self {
        let mut words = product(&a.significand, &b.significand);
        let mut exponent = a.exponent + b.exponent;
        if leading(words.as_flattened()) < LEADING {
            shift_left(words.as_flattened_mut(), 1);
            exponent -= 1;
        }
        Self { words, exponent, negative: a.negative != b.negative }
    }

    /// Key by which magnitudes are compared.
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
                words.iter_mut().rev().fold(0, |before, word| replace(word, before));
                self.exponent -= 64;
            }
        }
        let spare = leading(words).leading_zeros() % 64;
        shift_left(words, spare);
        self.exponent -= spare as i32;
    }

    /// Sum, rounded to the nearest.
    fn plus(self, other: Self) -> Wide<WORDS> {
        let (mut sum, mut smaller) =
            if self.magnitude() < other.magnitude() { (other, self) } else { (self, other) };
        let distance = (sum.exponent - smaller.exponent).unsigned_abs();
        shift_right(smaller.words.as_flattened_mut(), distance);
        let words = sum.words.as_flattened_mut();
        if sum.negative != smaller.negative {
            add(words, smaller.words.as_flattened(), u64::overflowing_sub);
            sum.normalise();
        } else if add(words, smaller.words.as_flattened(), u64::overflowing_add) {
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
    fn rounded(self) -> Wide<WORDS> {
        let Self { words: [mut significand, below], mut exponent, negative } = self;
        if leading(&significand) == 0 {
            return Wide { significand: [0; WORDS], exponent: 0, negative: false };
        }
        if add_word(&mut significand, leading(&below) >> 63) != 0 {
            // all words are 0
            if let Some(first) = significand.first_mut() {
                *first = LEADING;
            }
            exponent += 1;
        }
        Wide { significand, exponent, negative }
    }
}

//! Type of the wide numbers, and its numbers that need no arithmetic.

use super::words::leading;
use crate::scalar::power_of_two;

/// Number ±s · 2^exponent with a significand s in [1/2, 1) of `WORDS` words. The relative error of an operation is half a unit in the
/// last place, 2^(-64 WORDS), or a little more.
///
/// No result of a launch leaves the range. Infinity and NaN become 0, and a quotient by 0 a number larger than every `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Wide<const WORDS: usize> {
    /// Words of s, the most significant first. The leading bit is set, or all bits of the number are 0.
    pub(super) significand: [u64; WORDS],
    pub(super) exponent: i32,
    /// Whether the number is below 0.
    pub(super) negative: bool,
}

/// Number of 128 bits, some 38 digits.
pub type Extended = Wide<2>;

/// Number of 64 bits, some 19 digits.
pub type Extended64 = Wide<1>;

impl<const WORDS: usize> Wide<WORDS> {
    /// Upper bound on the relative error of one sum, product, quotient or root.
    pub(crate) const OPERATION_ERROR: f64 = 1.1 * power_of_two(-64 * WORDS as i32);

    pub(super) fn is_zero(&self) -> bool {
        leading(&self.significand) == 0
    }

    /// Number with this exponent instead; 0 stays 0.
    pub(super) fn with_exponent(self, exponent: i32) -> Self {
        if self.is_zero() { self } else { Self { exponent, ..self } }
    }

    /// Number value · 2^(exponent - 128), rounded to the nearest, for a value with the leading bit set.
    #[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
    pub(super) const fn constant(value: u128, exponent: i32) -> Self {
        let value = if WORDS == 1 { value + (value & 1 << 63) } else { value };
        let mut significand = [0; WORDS];
        significand[0] = (value >> 64) as u64;
        if WORDS > 1 {
            significand[1] = value as u64;
        }
        Self { significand, exponent, negative: false }
    }

    /// Number value · 2^exponent, exact.
    #[inline(never)]
    pub(crate) fn from_integer(value: u64, exponent: i32) -> Self {
        let (mut significand, spare) = ([0; WORDS], value.leading_zeros());
        match significand.first_mut() {
            Some(first) if value != 0 => *first = value << spare,
            _ => return Self { significand, exponent: 0, negative: false },
        }
        Self { significand, exponent: exponent + 64 - spare as i32, negative: false }
    }
}

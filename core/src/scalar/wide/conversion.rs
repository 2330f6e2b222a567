//! Wide numbers from and to `f64`, phases, integers and other widths.

use super::{DoubleWidth, Wide};
use crate::integer::mantissa_and_exponent;
use crate::phase::{FRACTION_BITS, Phase};
use crate::scalar::{Float, Ring};
use core::fmt;

impl<const WORDS: usize> Wide<WORDS> {
    /// 2π.
    pub const TWO_PI: Self = Self::constant(0xc90f_daa2_2168_c234_c4c6_628b_80dc_1cd1, 3);

    /// Angle in turns, from an angle in rad.
    pub fn radians_to_turns(self) -> Self {
        const { assert!(WORDS <= 2) }
        self * Self::constant(0xa2f9_836e_4e44_1529_fc27_57d1_f534_ddc0, -2)
    }

    /// Number ±value · 2^exponent, rounded to the nearest.
    #[inline(never)]
    pub(super) fn from_integer(value: u128, exponent: i32, negative: bool) -> Self {
        let mut words = [[0; WORDS]; 2];
        let mut remainder = value;
        for word in words.as_flattened_mut() {
            (*word, remainder) = ((remainder >> 64) as u64, remainder << 64);
        }
        DoubleWidth::new(words, exponent + 128, negative).rounded()
    }

    fn leading_128_bits(&self) -> u128 {
        let mut words = self.significand.iter();
        let mut next = || words.next().map_or(0, |word| u128::from(*word));
        next() << 64 | next()
    }

    /// Number of another width, rounded to the nearest.
    pub(crate) fn resized<const OTHER: usize>(number: Wide<OTHER>) -> Self {
        Self::from_integer(number.leading_128_bits(), number.exponent - 128, number.negative)
    }

    /// Phase of this number of turns, modulo 2^32 turns, rounded to the nearest.
    pub fn to_phase(self) -> Phase {
        let magnitude = self.leading_128_bits();
        let bits = match self.exponent - (128 - FRACTION_BITS) {
            128.. => 0,
            shift @ 0.. => magnitude << shift,
            shift @ -127.. => (magnitude >> -shift) + ((magnitude >> (-shift - 1)) & 1),
            -128 => magnitude >> 127,
            _ => 0,
        };
        Phase::from_bits(if self.negative { bits.wrapping_neg() } else { bits } as i128)
    }

    /// Number from two parts, their sum.
    pub fn from_f64_pair([a, b]: [f64; 2]) -> Self {
        Self::from(a) + Self::from(b)
    }

    /// Nearest `f64`, and the `f64` nearest to the remainder.
    pub fn to_f64_pair(self) -> [f64; 2] {
        let leading = self.to_f64();
        [leading, (self - leading.into()).to_f64()]
    }

    /// Floor modulo 2^128, and the remainder in [0, 1).
    pub(crate) fn floor_and_fraction(self) -> (i128, Self) {
        let upper = self.leading_128_bits();
        let exponent = self.exponent;
        let whole = match 128 - exponent {
            shift @ 0.. => upper.checked_shr(shift as u32),
            shift => upper.checked_shl(shift.unsigned_abs()),
        };
        let whole = whole.unwrap_or(0) as i128;
        let remainder = match exponent {
            1.. => Self::from_integer(upper.checked_shl(exponent as u32).unwrap_or(0), -128, false),
            _ => self.abs(),
        };
        if !self.negative {
            return (whole, remainder);
        }
        let remainder = Self::ONE - remainder;
        if remainder < Self::ONE { (!whole, remainder) } else { (whole.wrapping_neg(), Self::ZERO) }
    }
}

/// Two `f64`: see [`Wide::to_f64_pair`].
impl<const WORDS: usize> fmt::Debug for Wide<WORDS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.to_f64_pair().fmt(f)
    }
}

impl<const WORDS: usize> From<f64> for Wide<WORDS> {
    fn from(x: f64) -> Self {
        let (mantissa, exponent) = mantissa_and_exponent(x);
        Self::from_integer(mantissa.unsigned_abs().into(), exponent, mantissa < 0)
    }
}

impl<const WORDS: usize> From<i64> for Wide<WORDS> {
    fn from(number: i64) -> Self {
        Self::from_integer(number.unsigned_abs().into(), 0, number < 0)
    }
}

impl<const WORDS: usize> From<Phase> for Wide<WORDS> {
    /// Number of turns, whole turns included.
    fn from(phase: Phase) -> Self {
        let bits = phase.to_bits();
        Self::from_integer(bits.unsigned_abs(), -FRACTION_BITS, bits < 0)
    }
}

#[cfg(test)]
mod tests {
    use crate::phase::Phase;
    use crate::scalar::{Extended, Float};

    #[test]
    fn a_turn_has_a_phase() {
        assert_eq!(Extended::from(-3.25).to_phase(), Phase::from_turns(-3.25));
        assert_eq!(Extended::from(Phase::from_turns(-3.25)).to_f64(), -3.25);
        assert_eq!((Extended::TWO_PI * 0.25.into()).radians_to_turns().to_phase(), Phase::QUARTER);
        let (whole, remainder) = Extended::from_f64_pair([1e20, 0.75]).floor_and_fraction();
        assert_eq!((whole, remainder.to_f64()), (10_i128.pow(20), 0.75));
        for (x, floor, left) in [
            (-2.25, -3, 0.75),
            (-2.0, -2, 0.0),
            (-0.5, -1, 0.5),
            (-1e-60, 0, 0.0),
            (0.0, 0, 0.0),
            (1e300, 0, 0.0),
        ] {
            let (whole, remainder) = Extended::from(x).floor_and_fraction();
            assert_eq!((whole, remainder.to_f64()), (floor, left), "{x}");
        }
    }
}

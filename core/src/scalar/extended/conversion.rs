//! Extended numbers from and to `f64`, phases and whole numbers.

use super::{BITS, Extended};
use crate::phase::{FRACTION_BITS, Phase, integer_parts, shifted};
use crate::scalar::{Float, Ring};

impl Extended {
    /// Angle in turns, from an angle in rad.
    pub(crate) fn in_turns(self) -> Self {
        const PER_TURN: Extended = Extended::of(0x145f_306d_c9c8_82a5_3f84_eafa_3ea6_9bb8, -2 - BITS);
        self * PER_TURN
    }

    /// Phase of this number of turns, modulo 2^32 turns, rounded to the nearest.
    #[must_use]
    pub fn to_phase(self) -> Phase {
        Phase::from_bits(shifted(self.significand(), self.exponent.saturating_add(FRACTION_BITS)))
    }

    /// Sum of two `f64`, exact unless one is below 2^-72 of the other.
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        Self::from(a) + Self::from(b)
    }

    /// Product of two `f64`, exact.
    #[must_use]
    pub fn product(a: f64, b: f64) -> Self {
        Self::from(a) * Self::from(b)
    }

    /// Nearest `f64`, and the `f64` nearest to the rest: 106 bits or more.
    #[must_use]
    pub fn parts(self) -> [f64; 2] {
        let leading = self.to_f64();
        [leading, (self - leading.into()).to_f64()]
    }

    /// Upper 62 bits and the other 63, whose products with those of another number are exact.
    pub(crate) fn halves(self) -> [Self; 2] {
        let lower = self.significand() & ((1 << (BITS - 62)) - 1);
        let upper = self.significand() - lower;
        // 0 and a negative power of two must be normalised again
        [Self::normalised(upper, self.exponent), Self::normalised(lower, self.exponent)]
    }

    /// Largest whole number not above this one, as the sum of two whole `f64`, and the remainder in [0, 1).
    pub(crate) fn floor_and_rest(self) -> ([f64; 2], Self) {
        let [leading, low] = self.parts();
        let (whole, low_whole) = (libm::floor(leading), libm::floor(low));
        let rest = (self - whole.into()) - low_whole.into();
        if rest < Self::ONE {
            ([whole, low_whole], rest)
        } else {
            ([whole, low_whole + 1.0], rest - Self::ONE)
        }
    }
}

impl From<f64> for Extended {
    #[inline(never)]
    fn from(x: f64) -> Self {
        /// Difference of the numbers of bits.
        const MORE: i32 = BITS - 53;
        let (mantissa, exponent) = integer_parts(x);
        Self::nearly_normalised(i128::from(mantissa) << MORE, exponent - MORE)
    }
}

impl From<i64> for Extended {
    /// Whole number, exact.
    fn from(number: i64) -> Self {
        Self::normalised(number.into(), 0)
    }
}

impl From<Phase> for Extended {
    /// Number of turns, whole turns included; exact below 2^28 turns.
    fn from(phase: Phase) -> Self {
        Self::normalised(phase.to_bits(), -FRACTION_BITS)
    }
}

/// Nearest `f64` to significand · 2^exponent, ties to even; infinity beyond the range of `f64`, and 0 below the normal
/// numbers.
pub(super) fn nearest(significand: i128, exponent: i32) -> f64 {
    const DROPPED: i32 = BITS - 53;
    const HALF: u128 = 1 << (DROPPED - 1);
    let magnitude = significand.unsigned_abs();
    let (kept, rest) = ((magnitude >> DROPPED) as u64, magnitude & (2 * HALF - 1));
    let rounded = kept + u64::from(rest > HALF || (rest == HALF && kept & 1 == 1));
    // the leading bit of the significand adds 1 to the exponent's field
    let field = i64::from(exponent) + i64::from(DROPPED) + 1074;
    let bits = match field {
        ..0 => 0,
        2046.. => f64::INFINITY.to_bits(),
        _ => ((field as u64) << 52) + rounded,
    };
    let size = f64::from_bits(bits);
    if significand < 0 { -size } else { size }
}

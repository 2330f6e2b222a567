//! Phases as integers: whole turns and 96 bits of fraction.
//!
//! Sums are exact, and whole turns are dropped with the upper bits.

mod wrapped;

pub(crate) use wrapped::WrappedPhase;

use crate::integer::{ldexp_i128, mantissa_and_exponent, product_u64};
use core::ops::{Add, AddAssign, Mul, Neg, Sub};

/// Phase in turns: a signed integer in units of 2^-96.
///
/// ```text
/// 127          96 95                                        0
/// | whole turns  | fraction of a turn                        |
///                | 64 leading bits            |
/// ```
///
/// Resolution: 2^-96 turns (8e-29 rad). Sums wrap at ±2^31 whole turns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Phase(i128);

/// Number of fraction bits.
pub(crate) const FRACTION_BITS: i32 = 96;

impl Phase {
    /// Smallest difference of two phases, in turns.
    pub(crate) const RESOLUTION: f64 = 1.0 / (1_u128 << FRACTION_BITS) as f64;
    /// Zero phase.
    pub const ZERO: Self = Self(0);
    /// Quarter of a turn, π/2 rad.
    pub const QUARTER: Self = Self(1 << (FRACTION_BITS - 2));
    /// Half a turn, π rad.
    pub const HALF: Self = Self(1 << (FRACTION_BITS - 1));
    /// One turn, 2π rad.
    pub const TURN: Self = Self(1 << FRACTION_BITS);

    /// Phase from a number of turns, modulo 2^32 turns; 0 if it is not finite.
    pub fn from_turns(turns: f64) -> Self {
        let (mantissa, exponent) = mantissa_and_exponent(turns);
        Self(ldexp_i128(mantissa.into(), exponent + FRACTION_BITS))
    }

    /// Phase of an angle in radians, with a relative error of 2^-52; 0 if it is not finite.
    pub fn from_radians(angle: f64) -> Self {
        Self::from_turns(angle * (0.5 * core::f64::consts::FRAC_1_PI))
    }

    /// Phase of bits · 2^-96 turns.
    pub const fn from_bits(bits: i128) -> Self {
        Self(bits)
    }

    /// Phase in [0, 1) turn from its [`leading_bits`](Self::leading_bits).
    pub(crate) fn from_leading_bits(leading: u64) -> Self {
        Self(i128::from(leading) << (FRACTION_BITS - 64))
    }

    /// Phase as an integer, in units of 2^-96 turns.
    pub const fn to_bits(self) -> i128 {
        self.0
    }

    /// Words of 32 bits of the integer, lowest first.
    pub(crate) const fn words(self) -> [u32; 4] {
        let bits = self.0;
        [bits as u32, (bits >> 32) as u32, (bits >> 64) as u32, (bits >> 96) as u32]
    }

    /// Phase from the words of its integer.
    #[inline(always)]
    pub(crate) const fn from_words([a, b, c, d]: [u32; 4]) -> Self {
        Self((a as i128) | (b as i128) << 32 | (c as i128) << 64 | (d as i128) << 96)
    }

    /// Product with a fraction in [0, 1), given as a part of a turn. Error below 2^-62 turns.
    #[inline(always)]
    pub(crate) fn times_fraction(self, fraction: Self) -> Self {
        let whole_turns = (self.0 >> FRACTION_BITS) as i64;
        let [leading, _] = product_u64(self.leading_bits(), fraction.leading_bits());
        fraction * whole_turns + Self::from_leading_bits(leading)
    }

    /// Number of turns, with a relative error of 2^-53.
    pub fn to_turns(self) -> f64 {
        self.0 as f64 * Self::RESOLUTION
    }

    /// Angle in radians, with a relative error of 2^-52.
    pub fn to_radians(self) -> f64 {
        self.to_turns() * (2.0 * core::f64::consts::PI)
    }

    /// Phase of the same direction in (-1/2, 1/2] turn.
    #[must_use]
    pub fn principal(self) -> Self {
        let shift = 128 - FRACTION_BITS;
        let wrapped = Self(self.0.wrapping_shl(shift as u32) >> shift);
        if wrapped.0 == -Self::HALF.0 { Self::HALF } else { wrapped }
    }

    /// Number of whole half turns, and the remainder in [0, 1/2) turn.
    pub fn split_half_turns(self) -> (i64, Self) {
        let half_turns = self.0 >> (FRACTION_BITS - 1);
        (half_turns as i64, Self(self.0.wrapping_sub(half_turns << (FRACTION_BITS - 1))))
    }

    /// Nearest quarter turn, modulo 4 in the two lowest bits, and the remainder in [-1/8, 1/8) turn.
    pub fn quadrant(self) -> (u32, Self) {
        let quarter = self.0.wrapping_add(1 << (FRACTION_BITS - 3)) >> (FRACTION_BITS - 2);
        (quarter as u32, Self(self.0.wrapping_sub(quarter << (FRACTION_BITS - 2))))
    }

    /// Leading 64 bits of the phase without whole turns, in units of 2^-64 turns.
    #[inline]
    pub fn leading_bits(self) -> u64 {
        (self.0 >> (FRACTION_BITS - 64)) as u64
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Phase {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=f64} turns", self.to_turns());
    }
}

impl Add for Phase {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }
}

impl Sub for Phase {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0.wrapping_sub(other.0))
    }
}

impl Neg for Phase {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.wrapping_neg())
    }
}

/// Multiple, modulo 2^32 turns.
impl Mul<i64> for Phase {
    type Output = Self;
    #[inline]
    fn mul(self, n: i64) -> Self {
        Self(self.0.wrapping_mul(n.into()))
    }
}

impl AddAssign for Phase {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversion_is_exact() {
        for x in [0.0, 0.25, -0.75, 1e-9, 123.456, -2e9, 1.0 / (1_u128 << 90) as f64] {
            assert_eq!(Phase::from_turns(x).to_turns(), x);
        }
        assert_eq!(Phase::from_turns(f64::NAN), Phase::ZERO);
        assert_eq!(Phase::from_turns(f64::INFINITY), Phase::ZERO);
        assert_eq!(Phase::from_turns(0.5), Phase::HALF);
    }

    /// Conversion rounds to units of 2^-96 turns, halves upwards; a number far below the unit becomes 0.
    #[test]
    fn conversion_rounds_to_the_nearest() {
        for (units, rounded) in
            [(0.25, 0), (0.5, 1), (0.75, 1), (1.25, 1), (1.5, 2), (-0.5, 0), (-0.75, -1), (-1.25, -1)]
        {
            assert_eq!(Phase::from_turns(units / (1_u128 << 96) as f64).to_bits(), rounded, "{units}");
        }
        assert_eq!([1, 1 << 51].map(|bits| Phase::from_turns(f64::from_bits(bits))), [Phase::ZERO; 2]);
    }

    #[test]
    fn the_principal_value_is_within_half_a_turn() {
        assert_eq!(Phase::from_turns(7.25).principal(), Phase::QUARTER);
        assert_eq!(Phase::from_turns(-0.5).principal(), Phase::HALF);
        assert_eq!(Phase::from_turns(-3.25).principal().to_turns(), -0.25);
    }
}

//! Phases as integers: whole turns and 96 bits of fraction.
//!
//! An angle kept in radians loses digits as it grows and needs a reduction before its sine; a phase in turns does
//! neither. Sums are exact, and dropping the whole turns is taking the lower bits.

use crate::real::DoubleDouble;
use core::ops::{Add, AddAssign, Neg, Sub};

/// A phase in turns: a signed fixed-point number with 96 bits after the point.
///
/// Resolution 2^-96 turns (8e-29 rad). Sums are exact; they wrap after ±2^31 whole turns, which the sine never notices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Turns(i128);

/// Bits after the point.
const FRACTION_BITS: i32 = 96;

impl Turns {
    /// The smallest difference of two phases, in turns.
    pub const RESOLUTION: f64 = 1.0 / (1_u128 << FRACTION_BITS) as f64;
    /// No turn at all.
    pub const ZERO: Self = Self(0);
    /// A quarter of a turn, π/2 rad.
    pub const QUARTER: Self = Self(1 << (FRACTION_BITS - 2));
    /// Half a turn, π rad.
    pub const HALF: Self = Self(1 << (FRACTION_BITS - 1));
    /// One turn, 2π rad.
    pub const ONE: Self = Self(1 << FRACTION_BITS);

    /// From turns in `f64`: exact down to the last of the 96 bits, modulo 2^32 turns. Numbers that are not finite give
    /// no turn, so that a tick cannot fail.
    #[must_use]
    pub fn new(turns: f64) -> Self {
        let (mantissa, exponent) = integer_parts(turns);
        Self(shifted(mantissa.into(), exponent + FRACTION_BITS))
    }

    /// From radians. Error: 2^-52 relative, of the product and of 1/2π.
    #[must_use]
    pub fn from_radians(angle: f64) -> Self {
        Self::new(angle * (0.5 * core::f64::consts::FRAC_1_PI))
    }

    /// From turns in double-double, modulo 2^32 turns.
    #[must_use]
    pub fn of(turns: DoubleDouble) -> Self {
        Self::new(turns.hi()) + Self::new(turns.lo())
    }

    /// From the number itself: bits · 2^-96 turns.
    #[must_use]
    pub const fn from_bits(bits: i128) -> Self {
        Self(bits)
    }

    /// The number itself, in units of 2^-96 turns.
    #[must_use]
    pub const fn to_bits(self) -> i128 {
        self.0
    }

    /// In turns, the whole ones included: 2^-53 relative.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.0 as f64 * Self::RESOLUTION
    }

    /// In radians, the whole turns included: 2^-52 relative.
    #[must_use]
    pub fn to_radians(self) -> f64 {
        self.to_f64() * (2.0 * core::f64::consts::PI)
    }

    /// The same direction within half a turn: in (-1/2, 1/2].
    #[must_use]
    pub fn principal(self) -> Self {
        let shift = 128 - FRACTION_BITS;
        let wrapped = Self(self.0.wrapping_shl(shift as u32) >> shift);
        if wrapped.0 == -Self::HALF.0 { Self::HALF } else { wrapped }
    }

    /// n times the phase, modulo 2^32 turns.
    #[must_use]
    pub fn times(self, n: i64) -> Self {
        Self(self.0.wrapping_mul(n.into()))
    }

    /// Whole half turns, and the rest in [0, 1/2) turn.
    pub(crate) fn halves(self) -> (i64, Self) {
        let halves = self.0 >> (FRACTION_BITS - 1);
        (halves as i64, Self(self.0.wrapping_sub(halves << (FRACTION_BITS - 1))))
    }

    /// The nearest multiple of a quarter turn, modulo 4 (in its two lowest bits), and the rest in [-1/8, 1/8).
    pub(crate) fn quadrant(self) -> (u32, Self) {
        let quarter = self.0.wrapping_add(1 << (FRACTION_BITS - 3)) >> (FRACTION_BITS - 2);
        (quarter as u32, Self(self.0.wrapping_sub(quarter << (FRACTION_BITS - 2))))
    }

    /// The 64 leading bits of the fraction, an unsigned share of a turn: what a sine is taken of.
    #[inline]
    #[must_use]
    pub fn fraction(self) -> u64 {
        (self.0 >> (FRACTION_BITS - 64)) as u64
    }
}

impl Add for Turns {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }
}

impl Sub for Turns {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0.wrapping_sub(other.0))
    }
}

impl Neg for Turns {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.wrapping_neg())
    }
}

impl AddAssign for Turns {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// A constant rate of turning, kept to 63 bits whatever its size, so that a phase that only ever grows at this rate is
/// as good after a long time as after a short one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rate {
    /// Turns per unit time = mantissa · 2^exponent.
    mantissa: i64,
    exponent: i32,
}

impl Rate {
    /// From turns per unit time given as a sum of two `f64`, leading part first.
    #[must_use]
    pub fn new(leading: f64, rest: f64) -> Self {
        let (mantissa, exponent) = integer_parts(leading);
        if mantissa == 0 {
            return Self::default();
        }
        // 53 bits become 62: the nine new ones come from the rest.
        const EXTRA_BITS: i32 = 9;
        let (small, small_exponent) = integer_parts(rest);
        let exponent = exponent - EXTRA_BITS;
        let rest = shifted(small.into(), small_exponent - exponent) as i64;
        Self { mantissa: (mantissa << EXTRA_BITS).wrapping_add(rest), exponent }
    }

    /// rate × dt, exact down to the 2^-96 turn (and modulo 2^32 turns); dt not finite gives no turn.
    #[must_use]
    pub fn over(self, dt: f64) -> Turns {
        let (time, exponent) = integer_parts(dt);
        let product = i128::from(self.mantissa) * i128::from(time);
        Turns(shifted(product, self.exponent + exponent + FRACTION_BITS))
    }
}

/// 2π to 32 digits.
pub(crate) fn two_pi() -> DoubleDouble {
    DoubleDouble::new(2.0 * core::f64::consts::PI, 2.4492935982947064e-16)
}

/// Radians as turns.
pub(crate) fn in_turns(radians: DoubleDouble) -> DoubleDouble {
    radians / two_pi()
}

/// x = mantissa · 2^exponent with |mantissa| < 2^53; 0 where x is not finite.
fn integer_parts(x: f64) -> (i64, i32) {
    const MANTISSA_BITS: u32 = 52;
    const BIAS: i32 = 1075; // 1023 + 52
    let bits = x.to_bits();
    let fraction = (bits & ((1 << MANTISSA_BITS) - 1)) as i64;
    let magnitude = ((bits >> MANTISSA_BITS) & 0x7ff) as i32;
    let (mantissa, exponent) = match magnitude {
        0 => (fraction, 1 - BIAS),
        0x7ff => (0, 0),
        _ => (fraction | (1 << MANTISSA_BITS), magnitude - BIAS),
    };
    (if bits >> 63 == 1 { -mantissa } else { mantissa }, exponent)
}

/// value · 2^shift rounded to the nearest integer, modulo 2^128.
fn shifted(value: i128, shift: i32) -> i128 {
    match shift {
        128.. => 0,
        0.. => value << shift,
        -126.. => ((value >> (-shift - 1)) + 1) >> 1,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversion_is_exact() {
        for x in [0.0, 0.25, -0.75, 1e-9, 123.456, -2e9, 1.0 / (1_u128 << 90) as f64] {
            assert_eq!(Turns::new(x).to_f64(), x);
        }
        assert_eq!(Turns::new(f64::NAN), Turns::ZERO);
        assert_eq!(Turns::new(f64::INFINITY), Turns::ZERO);
        assert_eq!(Turns::new(0.5), Turns::HALF);
    }

    /// To units of 2^-96 turns, the half upwards; what is much smaller is nothing.
    #[test]
    fn conversion_rounds_to_the_nearest() {
        for (units, rounded) in
            [(0.25, 0), (0.5, 1), (0.75, 1), (1.25, 1), (1.5, 2), (-0.5, 0), (-0.75, -1), (-1.25, -1)]
        {
            assert_eq!(Turns::new(units / (1_u128 << 96) as f64).to_bits(), rounded, "{units}");
        }
        assert_eq!([1, 1 << 51].map(|bits| Turns::new(f64::from_bits(bits))), [Turns::ZERO; 2]);
    }

    #[test]
    fn the_principal_value_is_within_half_a_turn() {
        assert_eq!(Turns::new(7.25).principal(), Turns::QUARTER);
        assert_eq!(Turns::new(-0.5).principal(), Turns::HALF);
        assert_eq!(Turns::new(-3.25).principal().to_f64(), -0.25);
    }

    #[test]
    fn a_rate_over_a_long_time_loses_nothing() {
        // 1/3 turn a second, for 3·2^30 s: 2^30 turns; the leading f64 alone would be off by 6e-8 turns.
        let third = Rate::new(1.0 / 3.0, 1.850371707708594e-17);
        let rest = third.over(3.0 * (1_u64 << 30) as f64) - Turns::new((1_u64 << 30) as f64);
        assert!(rest.to_f64().abs() < 6e-8 / 256.0, "{}", rest.to_f64());
        assert_eq!(third.over(-3.0).to_f64(), -third.over(3.0).to_f64());
        assert_eq!(third.over(f64::NAN), Turns::ZERO);
    }
}

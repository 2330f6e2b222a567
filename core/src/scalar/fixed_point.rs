//! Numbers of the crate `fixed` as scalars: [`I2F30`] and [`I2F14`], both with the range [-2, 2) (feature `fixed`).
//!
//! These types have no square root and no division: they can evaluate a tick, not set up an ephemeris. The quantities
//! of a tick that they represent are at most 1 in magnitude: α, β, u, the axis, and the tip in units of s.

use crate::phase::Phase;
use crate::product::high_product;
use crate::scalar::{Extended64, Ring, Scalar, sine_cosine_q31};
use fixed::types::{I2F14, I2F30};

impl Ring for I2F30 {
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;

    /// Wrapping sum x + x: only products that occur in no motion leave the range when doubled.
    #[inline(always)]
    fn doubled(self) -> Self {
        self.wrapping_add(self)
    }

    /// Product rounded down to 2^-28: it is made of the upper word of the 64-bit product only.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Self::from_bits(high_product(self.to_bits(), other.to_bits()) << 2)
    }

    #[inline(always)]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self::from_bits(
            high_product(a.to_bits(), c.to_bits()).wrapping_add(high_product(b.to_bits(), d.to_bits())) << 2,
        )
    }

    #[inline(always)]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self::from_bits(
            high_product(a.to_bits(), d.to_bits()).wrapping_sub(high_product(b.to_bits(), c.to_bits())) << 2,
        )
    }
}

impl Scalar for I2F30 {
    type Rates = Extended64;
    const ROUNDING: f64 = 1.0 / (1_u64 << 31) as f64;

    #[inline]
    fn sine_cosine(phase: Phase) -> (Self, Self) {
        let (sine, cosine) = sine_cosine_q31((phase.fraction() >> 32) as u32);
        (Self::from_bits((sine >> 1) + (sine & 1)), Self::from_bits((cosine >> 1) + (cosine & 1)))
    }
}

impl Ring for I2F14 {
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;

    /// Wrapping sum x + x: only products that occur in no motion leave the range when doubled.
    #[inline(always)]
    fn doubled(self) -> Self {
        self.wrapping_add(self)
    }

    /// Product rounded down to 2^-14.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Self::from_bits(((self.to_bits() as i32 * other.to_bits() as i32) >> 14) as i16)
    }

    #[inline(always)]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        let product = |x: Self, y: Self| x.to_bits() as i32 * y.to_bits() as i32;
        Self::from_bits((product(a, c).wrapping_add(product(b, d)) >> 14) as i16)
    }

    #[inline(always)]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        let product = |x: Self, y: Self| x.to_bits() as i32 * y.to_bits() as i32;
        Self::from_bits((product(a, d).wrapping_sub(product(b, c)) >> 14) as i16)
    }
}

impl Scalar for I2F14 {
    type Rates = Extended64;
    const ROUNDING: f64 = 1.0 / (1_u64 << 15) as f64;

    #[inline]
    fn sine_cosine(phase: Phase) -> (Self, Self) {
        let (sine, cosine) = sine_cosine_q31((phase.fraction() >> 32) as u32);
        let short = |x: i32| Self::from_bits((((x >> 16) + 1) >> 1) as i16);
        (short(sine), short(cosine))
    }
}

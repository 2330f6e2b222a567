//! [`I2F30`] and [`I2F14`] of the crate `fixed` as scalars. The quantities of a tick are at most 1, and the range is [-2, 2).

use crate::phase::Phase;
use crate::scalar::{Q30, Ring, Scalar, sine_cosine_q31};
use fixed::types::{I2F14, I2F30};

fn q30(x: I2F30) -> Q30 {
    Q30(x.to_bits())
}

impl Ring for I2F30 {
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;

    /// Sum x + x, which cannot wrap: |x| <= 1.
    #[inline(always)]
    fn doubled(self) -> Self {
        self.wrapping_add(self)
    }

    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Self::from_bits(q30(self).product(q30(other)).0)
    }

    #[inline(always)]
    fn inner(x: [Self; 2], y: [Self; 2]) -> Self {
        Self::from_bits(Q30::inner(x.map(q30), y.map(q30)).0)
    }

    #[inline(always)]
    fn determinant(x: [Self; 2], y: [Self; 2]) -> Self {
        Self::from_bits(Q30::determinant(x.map(q30), y.map(q30)).0)
    }
}

impl Scalar for I2F30 {
    const ROUNDING: f64 = 1.0 / (1_u64 << 31) as f64;

    #[inline]
    fn sine_cosine(phase: Phase) -> (Self, Self) {
        let half_rounded_up = |sine: i32| Self::from_bits((sine >> 1) + (sine & 1));
        let (sine, cosine) = sine_cosine_q31((phase.leading_bits() >> 32) as u32);
        (half_rounded_up(sine), half_rounded_up(cosine))
    }
}

impl Ring for I2F14 {
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;

    /// Sum x + x, which cannot wrap: |x| <= 1.
    #[inline(always)]
    fn doubled(self) -> Self {
        self.wrapping_add(self)
    }

    /// Product, rounded down.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Self::from_bits((exact_product(self, other) >> 14) as i16)
    }

    #[inline(always)]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self::from_bits((exact_product(a, c).wrapping_add(exact_product(b, d)) >> 14) as i16)
    }

    #[inline(always)]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self::from_bits((exact_product(a, d).wrapping_sub(exact_product(b, c)) >> 14) as i16)
    }
}

/// Product in units of 2^-28.
#[inline(always)]
fn exact_product(a: I2F14, b: I2F14) -> i32 {
    i32::from(a.to_bits()) * i32::from(b.to_bits())
}

impl Scalar for I2F14 {
    const ROUNDING: f64 = 1.0 / (1_u64 << 15) as f64;

    #[inline]
    fn sine_cosine(phase: Phase) -> (Self, Self) {
        let rounded = |sine: i32| Self::from_bits((((sine >> 16) + 1) >> 1) as i16);
        let (sine, cosine) = sine_cosine_q31((phase.leading_bits() >> 32) as u32);
        (rounded(sine), rounded(cosine))
    }
}

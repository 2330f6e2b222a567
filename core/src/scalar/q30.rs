//! Fixed point of 32 bits, in which a tick in `f32` and in fixed point computes.

use crate::integer::high_product;
use crate::scalar::{Ring, sealed::Sealed};
use core::ops::{Add, Mul, Neg, Sub};

/// Integer multiple of 2^-30 in [-2, 2). Sums and products wrap, which happens only with invalid table data.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Q30(pub(crate) i32);

impl Sealed for Q30 {}

impl Ring for Q30 {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1 << 30);

    /// Sum of two products with one shift, in units of 2^-28.
    #[inline(always)]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self(high_product(a.0, c.0).wrapping_add(high_product(b.0, d.0)) << 2)
    }

    #[inline(always)]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        Self(high_product(a.0, d.0).wrapping_sub(high_product(b.0, c.0)) << 2)
    }
}

impl Add for Q30 {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }
}

impl Sub for Q30 {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0.wrapping_sub(other.0))
    }
}

impl Mul for Q30 {
    type Output = Self;
    /// Product rounded down to 2^-28.
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        // the upper word of the product of two numbers in units of 2^-30 is in units of 2^-28
        Self(high_product(self.0, other.0).wrapping_shl(2))
    }
}

impl Neg for Q30 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.wrapping_neg())
    }
}

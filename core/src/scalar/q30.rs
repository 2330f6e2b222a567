//! Fixed point of 32 bits, in which a tick in `f32` and in `I2F30` computes.

use crate::integer::high_product;
use crate::scalar::{Ring, sealed::Sealed};
use core::ops::{Add, Mul, Neg, Sub};

/// Integer multiple of 2^-30 in [-2, 2). Sums and products wrap, which happens only with invalid table data.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Q30(pub(crate) i32);

impl Sealed for Q30 {}

/// Whether the target has no `f32` unit.
const SOFT_FLOAT: bool = cfg!(any(
    all(target_arch = "arm", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", not(target_feature = "f"))
));

/// Nearest `f32`.
impl From<Q30> for f32 {
    #[inline(always)]
    fn from(Q30(number): Q30) -> Self {
        if SOFT_FLOAT {
            // the same bits as the product below: a product with a power of two is exact
            let converted = (number as Self).to_bits();
            return if number == 0 { 0.0 } else { Self::from_bits(converted - (30 << 23)) };
        }
        number as Self * (1.0 / (1_u32 << 30) as Self)
    }
}

impl Ring for Q30 {
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1 << 30);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_rounded_to_f32() {
        for number in [1 << 30, -3, i32::MAX, 1, i32::MIN, 0, -1] {
            let exact = f64::from(number as f32) * libm::exp2(-30.0);
            assert_eq!(f64::from(f32::from(Q30(number))), exact, "{number}");
        }
    }
}

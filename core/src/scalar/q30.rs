//! Fixed point of 32 bits, in which a tick in `f32` and in fixed point computes.

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

impl Q30 {
    /// This number times 2^exponent, rounded to `f32`; 0 for an exponent below -95, at which it could be subnormal.
    #[inline(always)]
    pub(crate) fn to_f32(self, exponent: i32) -> f32 {
        let number = if exponent < -95 { 0 } else { self.0 };
        let exponent = exponent.max(-95) - 30;
        if SOFT_FLOAT {
            // the same bits as the product below: a product with a power of two is exact
            let converted = (number as f32).to_bits();
            return if number == 0 {
                0.0
            } else {
                f32::from_bits(converted.wrapping_add_signed(exponent << 23))
            };
        }
        number as f32 * f32::from_bits(((exponent + 127) as u32) << 23)
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_two_is_exact() {
        for (number, exponent) in [(1 << 30, 0), (-3, 30), (i32::MAX, 119), (1, -95), (i32::MIN, -27)] {
            let exact = f64::from(number as f32) * libm::exp2(f64::from(exponent - 30));
            assert_eq!(f64::from(Q30(number).to_f32(exponent)), exact, "{number} {exponent}");
        }
        let zeros = [(0, 73), (1 << 30, -96), (5, -167)];
        assert_eq!(zeros.map(|(number, exponent)| Q30(number).to_f32(exponent)), [0.0; 3]);
    }
}

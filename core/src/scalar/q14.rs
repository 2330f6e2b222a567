//! Fixed point of 16 bits, in which a tick in `I2F14` computes.

use crate::scalar::{Ring, sealed::Sealed};
use fixed::{Wrapping, types::I2F14};

/// Integer multiple of 2^-14 in [-2, 2). Sums and products wrap, which happens only with invalid table data.
pub(crate) type Q14 = Wrapping<I2F14>;

impl Sealed for Q14 {}

impl Ring for Q14 {
    const ZERO: Self = Wrapping(I2F14::ZERO);
    const ONE: Self = Wrapping(I2F14::ONE);

    #[inline(always)]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        rounded_down(exact_product(a, c).wrapping_add(exact_product(b, d)))
    }

    #[inline(always)]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        rounded_down(exact_product(a, d).wrapping_sub(exact_product(b, c)))
    }
}

/// Product in units of 2^-28.
#[inline(always)]
fn exact_product(Wrapping(a): Q14, Wrapping(b): Q14) -> i32 {
    i32::from(a.to_bits()) * i32::from(b.to_bits())
}

#[inline(always)]
fn rounded_down(product: i32) -> Q14 {
    Wrapping(I2F14::from_bits((product >> 14) as i16))
}

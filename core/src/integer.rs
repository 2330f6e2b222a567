//! Integers wider than a chip's word, and floating-point numbers as integers times powers of two.
//!
//! | integer | used by | reason for its width |
//! |---|---|---|
//! | upper half of 32 x 32 bits | ticks in `f32` and fixed point | one instruction of a Cortex-M4 |
//! | [`Limbs`] of 30 bits | series of a set-up | sums of products need no carry on a chip of 32 bits |
//! | `i128` | [`Phase`](crate::Phase) | whole turns and 96 bits of fraction, with exact sums |
//! | three words of 32 bits | [`WrappedPhase`](crate::phase::WrappedPhase) | a fraction alone, with less work at a tick |
//! | words of 64 bits | [`Wide`](crate::scalar::Wide) | as many bits as the set-up of a scalar needs |

mod product;

mod limbs;

mod power_of_two;

pub(crate) use limbs::{LIMB_BITS, Limbs};
pub(crate) use power_of_two::{
    exponent, ldexp, ldexp_i128, mantissa_and_exponent, power_of_two, shifted_right, to_units, u64_to_f32,
};
pub(crate) use product::{
    high_product, product_32x16, product_i32, product_u32, product_u64, wrapping_product,
};

/// Next random bits of a test, from those before.
#[cfg(test)]
pub(crate) const fn next_random(bits: u64) -> u64 {
    bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f)
}

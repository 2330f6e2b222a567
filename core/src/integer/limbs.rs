//! Integers in two limbs of 30 bits: a sum of sixteen products of two limbs needs no carry, which saves time on a chip of 32 bits.

use super::product_i32;

/// Bits of the lower limb.
pub(crate) const LIMB_BITS: u32 = 30;

/// Integer high · 2^30 + low of up to 60 bits besides its sign, with low in [0, 2^30).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limbs {
    pub(crate) high: i32,
    low: i32,
}

impl Limbs {
    pub(crate) const ZERO: Self = Self { high: 0, low: 0 };

    pub(crate) const fn new(value: i64) -> Self {
        Self { high: (value >> LIMB_BITS) as i32, low: value as i32 & ((1 << LIMB_BITS) - 1) }
    }

    pub(crate) fn value(self) -> i64 {
        (i64::from(self.high) << LIMB_BITS) + i64::from(self.low)
    }

    /// Product with a factor of 32 bits over 2^SHIFT, for a SHIFT below 30, rounded to the nearest.
    pub(crate) fn times_word<const SHIFT: u32>(self, factor: i32) -> i64 {
        let half = 1 << (SHIFT - 1);
        (product_i32(self.high, factor) << (LIMB_BITS - SHIFT))
            + ((product_i32(self.low, factor) + half) >> SHIFT)
    }

    /// Product with a factor of 60 bits over 2^SHIFT, for a SHIFT of 54 to 60, rounded to the nearest.
    #[inline(never)]
    pub(crate) fn times<const SHIFT: u32>(self, factor: i64) -> i64 {
        let factor = Self::new(factor);
        let lower = product_i32(self.low, factor.low) >> LIMB_BITS;
        let mixed = product_i32(self.high, factor.low) + product_i32(self.low, factor.high) + lower;
        let half = 1 << (SHIFT - LIMB_BITS - 1);
        (product_i32(self.high, factor.high) << (2 * LIMB_BITS - SHIFT))
            + ((mixed + half) >> (SHIFT - LIMB_BITS))
    }

    /// Sum of up to sixteen products of numbers below 2^58, rounded down to upper · 2^60 + lower · 2^30, with lower in [0, 2^30).
    #[inline(always)]
    pub(crate) fn sum_of_products<'a>(factors: impl Iterator<Item = (&'a Self, &'a Self)>) -> (i64, u32) {
        let mut upper = 0;
        let mut mixed = 0;
        let mut lower = 0_u64;
        for (a, b) in factors {
            upper += product_i32(a.high, b.high);
            mixed += product_i32(a.high, b.low) + product_i32(a.low, b.high);
            lower += product_i32(a.low, b.low) as u64;
        }
        mixed += (lower >> LIMB_BITS) as i64;
        (upper + (mixed >> LIMB_BITS), mixed as u32 & ((1 << LIMB_BITS) - 1))
    }
}

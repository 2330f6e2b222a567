//! [`I2F30`] and [`I2F14`] of the crate `fixed` as scalars. The quantities of a tick are at most 1, and the range is [-2, 2).

use crate::integer::high_product;
use crate::phase::Phase;
use crate::scalar::{Ring, Scalar, sine_cosine_q31};
use fixed::types::{I2F14, I2F30};

/// Half of a number, rounded up.
const fn half_rounded_up(sine: i32) -> i32 {
    (sine >> 1) + (sine & 1)
}

/// Scalar traits of a type of fixed point. `$high` makes a product from bits, `$kept` the bits of a number from a sum of
/// products, and `$short` those from a sine in units of 2^-31.
macro_rules! fixed_scalar {
    ($fixed:ty, $rounding:expr, $high:expr, $kept:expr, $short:expr) => {
        impl Ring for $fixed {
            const ZERO: Self = Self::ZERO;
            const ONE: Self = Self::ONE;

            /// Sum x + x. No motion has numbers for which it wraps.
            #[inline(always)]
            fn doubled(self) -> Self {
                self.wrapping_add(self)
            }

            /// Product, rounded down.
            #[inline(always)]
            fn product(self, other: Self) -> Self {
                Self::from_bits($kept($high(self.to_bits(), other.to_bits())))
            }

            #[inline(always)]
            fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
                let (first, second) = ($high(a.to_bits(), c.to_bits()), $high(b.to_bits(), d.to_bits()));
                Self::from_bits($kept(first.wrapping_add(second)))
            }

            #[inline(always)]
            fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
                let (first, second) = ($high(a.to_bits(), d.to_bits()), $high(b.to_bits(), c.to_bits()));
                Self::from_bits($kept(first.wrapping_sub(second)))
            }
        }

        impl Scalar for $fixed {
            const ROUNDING: f64 = $rounding;

            #[inline]
            fn sine_cosine(phase: Phase) -> (Self, Self) {
                let (sine, cosine) = sine_cosine_q31((phase.leading_bits() >> 32) as u32);
                (Self::from_bits($short(sine)), Self::from_bits($short(cosine)))
            }
        }
    };
}

fixed_scalar!(I2F30, 1.0 / (1_u64 << 31) as f64, high_product, |high: i32| high << 2, half_rounded_up);
fixed_scalar!(
    I2F14,
    1.0 / (1_u64 << 15) as f64,
    |a: i16, b: i16| i32::from(a) * i32::from(b),
    |product: i32| (product >> 14) as i16,
    |sine: i32| (((sine >> 16) + 1) >> 1) as i16
);

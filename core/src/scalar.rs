//! Scalars: number types, and the traits that the algorithms require of them.
//!
//! Without fused multiply-add and `std` maths, a host and a chip agree to the bit.
//!
//! | trait | requires | `f32` `f64` | [`Wide`] | fixed point of a tick |
//! |---|---|---|---|---|
//! | [`Ring`] | `+ - *`, order, 0 and 1 | yes | yes | yes |
//! | [`Float`] | division, square root, conversion: what launch and *set-up* need | yes | yes | no |
//! | [`Real`] | sine, cosine, arctangent and exponential: what a *stepper* and a fit need; the type of a table's lengths and rates | yes | no | no |

mod wide;

pub(crate) mod sine;

mod q30;

#[cfg(feature = "fixed")]
mod q14;

mod numeric_struct;

pub(crate) use numeric_struct::numeric_struct;
#[cfg(feature = "fixed")]
pub(crate) use q14::Q14;
pub(crate) use q30::Q30;
#[cfg(feature = "fixed")]
pub(crate) use sine::coarse_sine_cosine_q30;
pub(crate) use sine::{
    SINE_BITS, fraction_of_word, short_sine_cosine_q31, sine_cosine_f64, sine_cosine_of_phase,
    sine_cosine_of_radians, sine_cosine_q31, sine_cosine_q57,
};

pub use wide::{Extended, Wide};

use crate::phase::Phase;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Sums, differences and products. Sealed.
pub trait Ring:
    sealed::Sealed
    + Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// Inner product of two pairs, ac + bd.
    #[inline(always)]
    #[must_use]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        a * c + b * d
    }

    /// Determinant of two pairs, ad - bc.
    #[inline(always)]
    #[must_use]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        a * d - b * c
    }

    /// Square, x².
    #[inline]
    #[must_use]
    fn squared(self) -> Self {
        self * self
    }

    /// Double, x + x: exact in binary floating point.
    #[inline]
    #[must_use]
    fn doubled(self) -> Self {
        self + self
    }

    /// Larger of two numbers, or NaN if one of them is NaN.
    #[inline]
    #[must_use]
    fn larger_or_nan(self, other: Self) -> Self {
        if other <= self || self.partial_cmp(&self).is_none() { self } else { other }
    }
}

/// Number type of a set-up: with division and square root.
pub trait Float: Ring + Div<Output = Self> {
    /// Upper bound on the relative error of one sum, product, quotient or root.
    const OPERATION_ERROR: f64;

    /// Nearest value of this type.
    fn from_f64(x: f64) -> Self;
    /// Nearest value of this type.
    fn from_extended(x: Extended) -> Self;
    /// This number in 128 bits.
    fn to_extended(self) -> Extended;
    /// Nearest `f64`.
    fn to_f64(self) -> f64;
    /// Square root; 0 for a negative number and for NaN.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Absolute value, |x|.
    #[must_use]
    fn abs(self) -> Self;

    /// Half, x / 2: exact in binary floating point.
    #[inline]
    #[must_use]
    fn halved(self) -> Self {
        self * Self::from_f64(0.5)
    }
}

/// Number type of a stepper and of a fit, with sine, cosine, arctangent and exponential.
pub trait Real: Float {
    /// Largest finite number.
    const MAX: Self;

    /// (sin 2πx, cos 2πx) of a phase of x turns. Error in `f32`: below 3.2e-8. In `f64`: below 2e-16, relative near the zeros.
    fn sine_cosine(phase: Phase) -> (Self, Self);
    /// Angle of the point (x, y) in rad, in [-π, π].
    fn atan2(y: Self, x: Self) -> Self;
    /// eˣ - 1, with a small relative error also where x is small.
    #[must_use]
    fn exp_minus_one(self) -> Self;
}

macro_rules! float_scalar {
    ($float:ident, $sine_cosine:path, $sqrt:path, $atan2:path, $exp_minus_one:path) => {
        impl Ring for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
        }

        impl Float for $float {
            const OPERATION_ERROR: f64 = $float::EPSILON as f64 / 2.0;

            #[inline]
            fn from_f64(x: f64) -> Self {
                x as Self
            }
            #[inline]
            fn from_extended(x: Extended) -> Self {
                x.to_f64() as Self
            }
            #[inline]
            fn to_extended(self) -> Extended {
                Extended::from(f64::from(self))
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline]
            fn sqrt(self) -> Self {
                if self > 0.0 { $sqrt(self) } else { 0.0 }
            }
            #[inline]
            fn abs(self) -> Self {
                // clears the sign bit without a call
                <$float>::abs(self)
            }
        }

        impl Real for $float {
            const MAX: Self = <$float>::MAX;

            #[inline]
            fn sine_cosine(phase: Phase) -> (Self, Self) {
                $sine_cosine(phase)
            }
            #[inline]
            fn atan2(y: Self, x: Self) -> Self {
                $atan2(y, x)
            }
            #[inline]
            fn exp_minus_one(self) -> Self {
                $exp_minus_one(self)
            }
        }
    };
}

float_scalar!(f32, sine_cosine_f32, libm::sqrtf, libm::atan2f, libm::expm1f);
float_scalar!(f64, sine_cosine_of_phase, libm::sqrt, libm::atan2, libm::expm1);

#[inline]
fn sine_cosine_f32(phase: Phase) -> (f32, f32) {
    const UNIT: f32 = 1.0 / (1_u64 << 31) as f32;
    let (sine, cosine) = sine_cosine_q31((phase.leading_bits() >> 32) as u32);
    (sine as f32 * UNIT, cosine as f32 * UNIT)
}

/// Supertrait that seals the scalar traits.
pub(crate) mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    impl<const WORDS: usize> Sealed for crate::scalar::Wide<WORDS> {}
    #[cfg(feature = "fixed")]
    impl Sealed for fixed::types::I2F30 {}
    #[cfg(feature = "fixed")]
    impl Sealed for fixed::types::I2F14 {}
}

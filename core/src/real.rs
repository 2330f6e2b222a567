//! The numbers: what a scalar must be able to do, and the types that can.
//!
//! Three small traits, because no single one fits all: fixed point has no division, and double-double has no sine.
//!
//! | trait | asks for | `f32` `f64` | [`DoubleDouble`] | fixed point, micromath |
//! |---|---|---|---|---|
//! | [`Ring`] | `+ - *`, order, 0 and 1 | yes | yes | can |
//! | [`Scalar`] | sine and cosine of an integer phase: all that a *tick* needs | yes | no | can |
//! | [`Float`] | division, square root, conversion: what *set-up* needs | yes | yes | micromath only |
//!
//! [`Real`] is both at once plus an arctangent. No trait has a fused multiply-add, and no method here calls `std`, so
//! that results agree to the bit between a host and a chip.

#[cfg(feature = "fixed")]
mod arctangent;
mod double_double;
#[cfg(feature = "fixed")]
mod fixed_point;
mod float;
mod product;
mod sine;

#[cfg(feature = "fixed")]
pub(crate) use arctangent::angle;
pub use double_double::DoubleDouble;
pub(crate) use product::{
    high_product, high_product_of_less, long_product, short_product, short_product_by_constant,
    wrapping_product,
};
pub(crate) use sine::sine_cosine_f64;
#[cfg(feature = "fixed")]
pub use sine::sine_cosine_q15;
pub use sine::{SINE_CONSTANTS, SineConstants, sine_cosine_q26, sine_cosine_q31};

use crate::turns::Turns;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Sums, differences and products.
pub trait Ring:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;

    /// The product: `*`, unless a type's own is slow on chips without a long multiplication.
    #[inline(always)]
    #[must_use]
    fn product(self, other: Self) -> Self {
        self * other
    }

    /// The inner product of two pairs, ac + bd.
    #[inline(always)]
    #[must_use]
    fn inner([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        a.product(c) + b.product(d)
    }

    /// The determinant of two pairs, ad - bc.
    #[inline(always)]
    #[must_use]
    fn determinant([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        a.product(d) - b.product(c)
    }

    /// x².
    #[inline]
    #[must_use]
    fn squared(self) -> Self {
        self.product(self)
    }

    /// x + x: exact in binary floating point.
    #[inline]
    #[must_use]
    fn doubled(self) -> Self {
        self + self
    }
}

/// What a tick needs: a ring with the sine and cosine of an integer phase.
pub trait Scalar: Ring {
    /// (sin 2πx, cos 2πx) of a phase of x turns; the whole turns are dropped exactly.
    ///
    /// Error: below 3.2e-8 in `f32`; below 2e-16 in `f64`, and there relative to the result near its zeros.
    fn sine_cosine(phase: Turns) -> (Self, Self);

    /// Half a unit in the last place of 1: what one operation can round off (a product in fixed point eight times as much).
    const ROUNDING: f64;
}

/// What set-up needs: division and square root. Never asked of fixed point.
pub trait Float: Ring + Div<Output = Self> {
    /// The nearest value of this type.
    fn from_f64(x: f64) -> Self;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// The square root of a number that is not negative; 0 where rounding made it so.
    #[must_use]
    fn sqrt(self) -> Self;

    /// |x|.
    #[inline]
    #[must_use]
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    /// x / 2: exact in binary floating point.
    #[inline]
    #[must_use]
    fn halved(self) -> Self {
        self * Self::from_f64(0.5)
    }
}

/// A float that can also tick, and find an angle from its sine and cosine.
pub trait Real: Scalar + Float {
    /// The angle of the point (x, y) in rad, in [-π, π].
    fn atan2(y: Self, x: Self) -> Self;
    /// eˣ.
    #[must_use]
    fn exp(self) -> Self;
    /// eˣ - 1, with all its digits where x is small.
    #[must_use]
    fn exp_minus_one(self) -> Self;
}

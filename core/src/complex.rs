//! Complex numbers over any [`Ring`], fixed point included.

use crate::phase::Phase;
use crate::scalar::{Float, Real, Ring};
use core::ops::{Add, Mul, Neg, Sub};

/// Complex number re + i im.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Complex<R> {
    /// Real part.
    pub re: R,
    /// Imaginary part.
    pub im: R,
}

impl<R> Complex<R> {
    /// Complex number re + i im.
    pub const fn new(re: R, im: R) -> Self {
        Self { re, im }
    }
}

impl<R: Copy> Complex<R> {
    /// Complex number whose parts are converted.
    #[inline(always)]
    pub fn map<G>(self, convert: impl Fn(R) -> G) -> Complex<G> {
        Complex::new(convert(self.re), convert(self.im))
    }
}

impl<R: Ring> Complex<R> {
    /// Zero.
    pub const ZERO: Self = Self { re: R::ZERO, im: R::ZERO };
    /// One.
    pub const ONE: Self = Self { re: R::ONE, im: R::ZERO };

    /// Complex conjugate, re - i im.
    #[must_use]
    pub fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// Squared modulus, |z|².
    pub fn norm_squared(self) -> R {
        R::inner([self.re, self.im], [self.re, self.im])
    }

    /// Product i z.
    #[must_use]
    pub fn times_i(self) -> Self {
        Self { re: -self.im, im: self.re }
    }

    /// Product x z with a real x.
    #[must_use]
    pub fn scaled(self, x: R) -> Self {
        Self { re: self.re * x, im: self.im * x }
    }
}

impl<R: Float> Complex<R> {
    /// Modulus, |z|.
    pub fn modulus(self) -> R {
        self.norm_squared().sqrt()
    }
}

impl<R: Real> Complex<R> {
    /// Unit complex number e^{2πix} for a phase of x turns.
    #[inline]
    pub fn cis(phase: Phase) -> Self {
        let (im, re) = R::sine_cosine(phase);
        Self { re, im }
    }

    /// Argument in rad, in [-π, π]; 0 for z = 0.
    pub fn arg(self) -> R {
        R::atan2(self.im, self.re)
    }
}

impl<R: Ring> Add for Complex<R> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<R: Ring> Sub for Complex<R> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<R: Ring> Mul for Complex<R> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            re: R::determinant([self.re, self.im], [other.im, other.re]),
            im: R::inner([self.re, self.im], [other.im, other.re]),
        }
    }
}

impl<R: Ring> Neg for Complex<R> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

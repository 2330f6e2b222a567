//! Möbius transformations of the Riemann sphere (section 2.2): SL(2, C) acts by conformal maps, its subgroup SU(2) by
//! rotations.
//!
//! [`Orientation::moebius`] is the action of an orientation. This module has the whole group, so that the paper's
//! statements about it can be tested: the action is a homomorphism with kernel {1, -1}, it is conformal, and it is
//! isometric exactly for δ = ᾱ, γ = -β̄.

use crate::complex::Complex;
use crate::scalar::Float;
use crate::su2::{Orientation, quotient};

/// Transformation z ↦ (αz + β)/(γz + δ) with αδ - βγ = 1 (equation (2.5) of the paper). `None` stands for the point
/// at infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moebius<R> {
    /// Coefficient α.
    pub alpha: Complex<R>,
    /// Coefficient β.
    pub beta: Complex<R>,
    /// Coefficient γ.
    pub gamma: Complex<R>,
    /// Coefficient δ.
    pub delta: Complex<R>,
}

impl<R: Float> Moebius<R> {
    /// Determinant αδ - βγ, which is 1 in SL(2, C). Constructors do not normalise.
    #[must_use]
    pub fn determinant(&self) -> Complex<R> {
        self.alpha * self.delta - self.beta * self.gamma
    }

    /// Image of z.
    #[must_use]
    pub fn at(&self, z: Option<Complex<R>>) -> Option<Complex<R>> {
        match z {
            Some(z) => quotient(self.alpha * z + self.beta, self.gamma * z + self.delta),
            None => quotient(self.alpha, self.gamma),
        }
    }

    /// Matrix product: the transformation `other` followed by `self`.
    #[must_use]
    pub fn compose(&self, other: &Self) -> Self {
        Self {
            alpha: self.alpha * other.alpha + self.beta * other.gamma,
            beta: self.alpha * other.beta + self.beta * other.delta,
            gamma: self.gamma * other.alpha + self.delta * other.gamma,
            delta: self.gamma * other.beta + self.delta * other.delta,
        }
    }

    /// Derivative 1/(γz + δ)². It is a complex number, so the map rotates and scales all directions equally. `None`
    /// where the image is infinite.
    #[must_use]
    pub fn derivative(&self, z: Complex<R>) -> Option<Complex<R>> {
        let denominator = self.gamma * z + self.delta;
        quotient(self.determinant(), denominator * denominator)
    }
}

impl<R: Float> From<Orientation<R>> for Moebius<R> {
    fn from(orientation: Orientation<R>) -> Self {
        let Orientation { alpha, beta } = orientation;
        Self { alpha, beta, gamma: orientation.gamma(), delta: orientation.delta() }
    }
}

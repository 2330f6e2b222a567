//! Möbius transformations of the Riemann sphere (section 2.2): SL(2, C) acts by conformal maps, its subgroup SU(2) by
//! rotations.
//!
//! [`Orientation::moebius`] is the action of an orientation. This module has the whole group, so that the paper's
//! statements about it can be tested: the action is a homomorphism with kernel {1, -1}, it is conformal, and it is
//! isometric exactly for δ = ᾱ, γ = -β̄.

use crate::complex::Complex;
use crate::scalar::Float;
use crate::su2::{Orientation, dot, quotient, sphere_point};

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

    /// Distance from a rotation, |δ - ᾱ|² + |γ + β̄|²: 0 exactly for a rotation.
    #[must_use]
    pub fn distance_from_rotation(&self) -> R {
        (self.delta - self.alpha.conj()).norm_squared() + (self.gamma + self.beta.conj()).norm_squared()
    }
}

impl<R: Float> From<Orientation<R>> for Moebius<R> {
    fn from(orientation: Orientation<R>) -> Self {
        let Orientation { alpha, beta } = orientation;
        Self { alpha, beta, gamma: orientation.gamma(), delta: orientation.delta() }
    }
}

/// Euclidean distance of the points of the unit sphere over z and w (equation (2.4) of the paper), in [0, 2].
pub fn chordal_distance<R: Float>(z: Option<Complex<R>>, w: Option<Complex<R>>) -> R {
    let ([x1, x2, x3], [y1, y2, y3]) = (sphere_point(z), sphere_point(w));
    let chord = [x1 - y1, x2 - y2, x3 - y3];
    dot(chord, chord).sqrt()
}

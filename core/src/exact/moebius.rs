//! Möbius transformations of the sphere of numbers (section 2.2): SL(2, C) acts by conformal maps, its subgroup SU(2) by
//! rotations.
//!
//! The orientation's own action is [`Phi::moebius`]; here is the group it sits in, so that what the paper says of
//! it can be tested: a homomorphism with kernel {1, -1}, conformal, isometric exactly for δ = ᾱ, γ = -β̄.

use crate::complex::Complex;
use crate::real::Float;
use crate::su2::{Phi, dot, quotient, sphere_point};

/// z ↦ (αz + β)/(γz + δ) with αδ - βγ = 1 (eqn:Moeb). The point at infinity is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moebius<R> {
    /// α.
    pub alpha: Complex<R>,
    /// β.
    pub beta: Complex<R>,
    /// γ.
    pub gamma: Complex<R>,
    /// δ.
    pub delta: Complex<R>,
}

impl<R: Float> Moebius<R> {
    /// αδ - βγ, which is 1 in SL(2, C). Constructors do not normalise.
    #[must_use]
    pub fn determinant(&self) -> Complex<R> {
        self.alpha * self.delta - self.beta * self.gamma
    }

    /// The image of z.
    #[must_use]
    pub fn at(&self, z: Option<Complex<R>>) -> Option<Complex<R>> {
        match z {
            Some(z) => quotient(self.alpha * z + self.beta, self.gamma * z + self.delta),
            None => quotient(self.alpha, self.gamma),
        }
    }

    /// The matrix product: first `other`, then `self`.
    #[must_use]
    pub fn compose(&self, other: &Self) -> Self {
        Self {
            alpha: self.alpha * other.alpha + self.beta * other.gamma,
            beta: self.alpha * other.beta + self.beta * other.delta,
            gamma: self.gamma * other.alpha + self.delta * other.gamma,
            delta: self.gamma * other.beta + self.delta * other.delta,
        }
    }

    /// The derivative 1/(γz + δ)²: a number, so the map turns and stretches all directions alike. `None` where the
    /// image is infinite.
    #[must_use]
    pub fn derivative(&self, z: Complex<R>) -> Option<Complex<R>> {
        let denominator = self.gamma * z + self.delta;
        quotient(self.determinant(), denominator * denominator)
    }

    /// |δ - ᾱ|² + |γ + β̄|²: 0 exactly for a rotation.
    #[must_use]
    pub fn distance_from_rotation(&self) -> R {
        (self.delta - self.alpha.conj()).norm_squared() + (self.gamma + self.beta.conj()).norm_squared()
    }
}

impl<R: Float> From<Phi<R>> for Moebius<R> {
    fn from(phi: Phi<R>) -> Self {
        Self { alpha: phi.alpha, beta: phi.beta, gamma: phi.gamma(), delta: phi.delta() }
    }
}

/// The distance in space of the points of the unit sphere over z and w (eqn:inerse-stereo-proj), in [0, 2].
pub fn chordal_distance<R: Float>(z: Option<Complex<R>>, w: Option<Complex<R>>) -> R {
    let ([x1, x2, x3], [y1, y2, y3]) = (sphere_point(z), sphere_point(w));
    let chord = [x1 - y1, x2 - y2, x3 - y3];
    dot(chord, chord).sqrt()
}

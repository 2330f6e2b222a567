//! SU(2) and its Lie algebra: the orientation of the top and the vectors it turns (section 2 of the paper).
//!
//! A vector x of R³ stands for the matrix ½ ((i x₃, -x₂ + i x₁), (x₂ + i x₁, -i x₃)) of su(2); with this factor ½ the
//! Lie bracket is the cross product and ⟨x, y⟩ = -2 Tr(x y). A body vector X is turned into the fixed frame by
//! x = Φ X Φ⁻¹; the third body axis points from the tip to the centre of mass, the third fixed axis upward.
//!
//! Φ and -Φ are the same rotation. This crate keeps the sign: it is continuous in time.

use crate::complex::Complex;
use crate::real::{Float, Real, Ring};
use crate::turns::Turns;

/// A vector of R³, read as an element of su(2).
pub type Vector<R> = [R; 3];

/// ⟨x, y⟩ = -2 Tr(x y).
pub fn dot<R: Ring>(x: Vector<R>, y: Vector<R>) -> R {
    let [x1, x2, x3] = x;
    let [y1, y2, y3] = y;
    x1 * y1 + x2 * y2 + x3 * y3
}

/// [x, y], the Lie bracket: the cross product x × y.
pub fn bracket<R: Ring>(x: Vector<R>, y: Vector<R>) -> Vector<R> {
    let [x1, x2, x3] = x;
    let [y1, y2, y3] = y;
    [x2 * y3 - x3 * y2, x3 * y1 - x1 * y3, x1 * y2 - x2 * y1]
}

/// An orientation: the matrix Φ = ((α, β), (γ, δ)) of SU(2) in Cayley-Klein parameters.
///
/// γ = -β̄ and δ = ᾱ follow. Constructors do not normalise: |α|² + |β|² = 1 is the caller's.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Phi<R> {
    /// α, with 1 + u = 2 |α|².
    pub alpha: Complex<R>,
    /// β, with 1 - u = 2 |β|².
    pub beta: Complex<R>,
}

impl<R: Ring> Default for Phi<R> {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<R: Ring> Phi<R> {
    /// No rotation: the axis upright.
    pub const IDENTITY: Self = Self { alpha: Complex::ONE, beta: Complex::ZERO };

    /// γ = -β̄.
    #[must_use]
    pub fn gamma(&self) -> Complex<R> {
        -self.beta.conj()
    }

    /// δ = ᾱ.
    #[must_use]
    pub fn delta(&self) -> Complex<R> {
        self.alpha.conj()
    }

    /// |α|² + |β|², the determinant.
    #[must_use]
    pub fn norm_squared(&self) -> R {
        self.alpha.norm_squared() + self.beta.norm_squared()
    }

    /// Φ⁻¹ = ((δ, -β), (-γ, α)).
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { alpha: self.alpha.conj(), beta: -self.beta }
    }

    /// The product Φ Ψ: first Ψ, then Φ.
    #[must_use]
    pub fn compose(&self, psi: &Self) -> Self {
        Self {
            alpha: self.alpha * psi.alpha + self.beta * psi.gamma(),
            beta: self.alpha * psi.beta + self.beta * psi.delta(),
        }
    }

    /// The adjoint action Ad_Φ: body coordinates X to fixed coordinates Φ X Φ⁻¹.
    #[must_use]
    pub fn adjoint(&self, body: Vector<R>) -> Vector<R> {
        // The right column of Φ X Φ⁻¹, with w = X₁ + i X₂:
        //   x₁ + i x₂ = α² w - β² w̄ - 2 αβ X₃,   x₃ = (|α|² - |β|²) X₃ + 2 Re(α β̄ w)
        let [x1, x2, x3] = body;
        let w = Complex::new(x1, x2);
        let (alpha, beta) = (self.alpha, self.beta);
        // |αβ| <= 1/2: doubled last, it stays within a fixed-point range of ±2
        let along = (alpha * beta).scaled(x3);
        let across = alpha * alpha * w - beta * beta * w.conj();
        let vertical =
            (alpha.norm_squared() - beta.norm_squared()) * x3 + (alpha * beta.conj() * w).re.doubled();
        [across.re - along.re.doubled(), across.im - along.im.doubled(), vertical]
    }

    /// r = Φ e₃ Φ⁻¹, the symmetry axis from the tip to the centre of mass: r₁ + i r₂ = -2αβ, r₃ = |α|² - |β|².
    #[must_use]
    pub fn axis(&self) -> Vector<R> {
        // |αβ| <= 1/2, so that this stays within a fixed-point range of ±2
        let product = self.alpha * self.beta;
        [-product.re.doubled(), -product.im.doubled(), self.u()]
    }

    /// The same rotation as a unit quaternion w + x i + y j + z k, as [w, x, y, z]: body to fixed frame, sign included.
    #[must_use]
    pub fn quaternion(&self) -> [R; 4] {
        let Self { alpha, beta } = *self;
        [alpha.re, beta.im, -beta.re, alpha.im]
    }

    /// The reverse of [`Phi::quaternion`]; not normalised either.
    #[must_use]
    pub fn from_quaternion([w, x, y, z]: [R; 4]) -> Self {
        Self { alpha: Complex::new(w, z), beta: Complex::new(-y, x) }
    }

    /// Ad_Φ as a matrix, row by row: fixed coordinates are its product with the column of body coordinates. The third column is
    /// the axis.
    #[must_use]
    pub fn matrix(&self) -> [Vector<R>; 3] {
        let (zero, one) = (R::ZERO, R::ONE);
        let [a, b] = [[one, zero, zero], [zero, one, zero]].map(|body| self.adjoint(body));
        let ([a1, a2, a3], [b1, b2, b3], [r1, r2, r3]) = (a, b, self.axis());
        [[a1, b1, r1], [a2, b2, r2], [a3, b3, r3]]
    }

    /// u = |α|² - |β|², the cosine of the tilt: the real part of (α + β)(ᾱ - β̄), two products instead of four.
    #[must_use]
    pub fn u(&self) -> R {
        let (sum, difference) = (self.alpha + self.beta, self.alpha - self.beta);
        R::inner([sum.re, sum.im], [difference.re, difference.im])
    }
}

impl<R: Float> Phi<R> {
    /// Φ / √(|α|² + |β|²).
    #[must_use]
    pub fn normalised(&self) -> Self {
        let scale = R::ONE / self.norm_squared().sqrt();
        Self { alpha: self.alpha.scaled(scale), beta: self.beta.scaled(scale) }
    }

    /// The Möbius transformation z ↦ (αz + β)/(γz + δ): the rotation seen in the stereographic plane
    /// ([`stereographic`]). The point at infinity is `None`, on both sides.
    #[must_use]
    pub fn moebius(&self, z: Option<Complex<R>>) -> Option<Complex<R>> {
        match z {
            Some(z) => quotient(self.alpha * z + self.beta, self.gamma() * z + self.delta()),
            None => quotient(self.alpha, self.gamma()),
        }
    }
}

impl<R: Real> Phi<R> {
    /// exp of an element of su(2): the rotation by |x| rad about x. `Turns` carry a large angle, a series a small one, so any
    /// size is exact to some roundings of the scalar, of |x| itself and of the result.
    #[must_use]
    pub fn exp(x: Vector<R>) -> Self {
        /// Below it the sine of `f32`, good to 2^-32 turns, would be short of digits.
        const SMALL: f64 = 1.0 / 16.0;
        let square = dot(x, x);
        let (scale, cosine) = if square < R::from_f64(SMALL * SMALL) {
            small_half_angle(square * R::from_f64(0.25))
        } else {
            let angle = square.sqrt();
            let (sine, cosine) = R::sine_cosine(Turns::from_radians(0.5 * angle.to_f64()));
            (sine / angle, cosine)
        };
        let [x1, x2, x3] = x.map(|component| component * scale);
        Self { alpha: Complex::new(cosine, x3), beta: Complex::new(-x2, x1) }
    }
}

/// sin h/2h and cos h from h² <= 2^-10: what the series leave out is below 2^-61.
fn small_half_angle<R: Real>(square: R) -> (R, R) {
    // 1 - h²/d₁ (1 - h²/d₂ (1 - ...)), the divisors last to first
    let series = |divisors: [f64; 4]| {
        divisors.into_iter().fold(R::ONE, |sum, divisor| R::ONE - square * R::from_f64(1.0 / divisor) * sum)
    };
    let (sine, cosine) = (series([72.0, 42.0, 20.0, 6.0]), series([56.0, 30.0, 12.0, 2.0]));
    (sine * R::from_f64(0.5), cosine)
}

/// Φ and its rate of change: everything about one instant follows from these two by products alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PhiRate<R> {
    /// α', per unit time.
    pub alpha: Complex<R>,
    /// β', per unit time.
    pub beta: Complex<R>,
}

impl<R: Ring> PhiRate<R> {
    /// Φ' = ω Φ, for ω in the fixed frame.
    #[must_use]
    pub fn from_fixed(phi: &Phi<R>, omega: Vector<R>) -> Self
    where
        R: Float,
    {
        let [w1, w2, w3] = omega.map(Float::halved);
        let (diagonal, upper) = (Complex::new(R::ZERO, w3), Complex::new(-w2, w1));
        Self {
            alpha: diagonal * phi.alpha + upper * phi.gamma(),
            beta: diagonal * phi.beta + upper * phi.delta(),
        }
    }

    /// ω = Φ' Φ⁻¹ in the fixed frame (eqn:omega, with the printed slip corrected).
    #[must_use]
    pub fn omega_fixed(&self, phi: &Phi<R>) -> Vector<R> {
        let diagonal = self.alpha * phi.delta() - self.beta * phi.gamma();
        let upper = self.beta * phi.alpha - self.alpha * phi.beta;
        [upper.im.doubled(), -upper.re.doubled(), diagonal.im.doubled()]
    }

    /// Ω = Φ⁻¹ Φ' in the body frame (eqn:Omega, with the printed slip corrected).
    #[must_use]
    pub fn omega_body(&self, phi: &Phi<R>) -> Vector<R> {
        let (gamma, delta) = (-self.beta.conj(), self.alpha.conj());
        let diagonal = phi.delta() * self.alpha - phi.beta * gamma;
        let upper = phi.delta() * self.beta - phi.beta * delta;
        [upper.im.doubled(), -upper.re.doubled(), diagonal.im.doubled()]
    }

    /// u' = d(|α|² - |β|²)/dt.
    #[must_use]
    pub fn udot(&self, phi: &Phi<R>) -> R {
        ((phi.alpha.conj() * self.alpha).re - (phi.beta.conj() * self.beta).re).doubled()
    }
}

/// The stereographic projection from the north pole, z = (ξ + iη)/(1 - ζ); `None` is the point at infinity.
pub fn stereographic<R: Float>(point: Vector<R>) -> Option<Complex<R>> {
    let [xi, eta, zeta] = point;
    quotient(Complex::new(xi, eta), Complex::new(R::ONE - zeta, R::ZERO))
}

/// The point of the unit sphere over z (eqn:inerse-stereo-proj): (2 Re z, 2 Im z, |z|² - 1)/(|z|² + 1).
pub fn sphere_point<R: Float>(z: Option<Complex<R>>) -> Vector<R> {
    let Some(z) = z else { return [R::ZERO, R::ZERO, R::ONE] };
    let scale = R::ONE / (z.norm_squared() + R::ONE);
    [z.re.doubled() * scale, z.im.doubled() * scale, (z.norm_squared() - R::ONE) * scale]
}

/// a / b, `None` for b = 0.
pub(crate) fn quotient<R: Float>(a: Complex<R>, b: Complex<R>) -> Option<Complex<R>> {
    let norm = b.norm_squared();
    (norm > R::ZERO).then(|| (a * b.conj()).scaled(R::ONE / norm))
}

//! SU(2) and its Lie algebra: orientations and the vectors that they rotate (paper, section 2.1).
//!
//! A vector x of R³ stands for the matrix ½ ((i x₃, -x₂ + i x₁), (x₂ + i x₁, -i x₃)) of su(2), whose Lie bracket is the cross
//! product.

#[cfg(feature = "nalgebra")]
mod nalgebra;

use crate::complex::Complex;
use crate::scalar::{Float, Real, Ring};
use core::ops::Neg;

/// Vector of R³, identified with an element of su(2).
pub type Vector<R> = [R; 3];

/// Scalar product ⟨x, y⟩ = -2 Tr(x y).
pub fn dot<R: Ring>(x: Vector<R>, y: Vector<R>) -> R {
    let [x1, x2, x3] = x;
    let [y1, y2, y3] = y;
    x1 * y1 + x2 * y2 + x3 * y3
}

/// Cross product x × y, the Lie bracket of su(2).
pub fn cross<R: Ring>(x: Vector<R>, y: Vector<R>) -> Vector<R> {
    let [x1, x2, x3] = x;
    let [y1, y2, y3] = y;
    [x2 * y3 - x3 * y2, x3 * y1 - x1 * y3, x1 * y2 - x2 * y1]
}

/// Sum x + f y.
pub fn add_scaled<R: Ring>([x1, x2, x3]: Vector<R>, [y1, y2, y3]: Vector<R>, f: R) -> Vector<R> {
    [x1 + f * y1, x2 + f * y2, x3 + f * y3]
}

/// Product f x.
pub fn scaled<R: Ring>(x: Vector<R>, f: R) -> Vector<R> {
    x.map(|component| f * component)
}

/// Orientation: the matrix Φ = ((α, β), (γ, δ)) of SU(2), with γ = -β̄, δ = ᾱ and |α|² + |β|² = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Orientation<R> {
    /// Cayley-Klein parameter α, with 2 |α|² = 1 + u.
    pub alpha: Complex<R>,
    /// Cayley-Klein parameter β, with 2 |β|² = 1 - u.
    pub beta: Complex<R>,
}

impl<R: Copy> Orientation<R> {
    /// Orientation whose four numbers are converted.
    #[inline(always)]
    pub fn map<G>(&self, convert: impl Fn(R) -> G) -> Orientation<G> {
        Orientation { alpha: self.alpha.map(&convert), beta: self.beta.map(&convert) }
    }

    /// Unit quaternion [w, x, y, z] from body to fixed coordinates. Φ and -Φ give opposite signs.
    pub fn quaternion(&self) -> [R; 4]
    where
        R: Neg<Output = R>,
    {
        let Self { alpha, beta } = *self;
        [alpha.re, beta.im, -beta.re, alpha.im]
    }
}

impl<R: Ring> Default for Orientation<R> {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<R: Ring> Orientation<R> {
    /// Identity: the axis points upward.
    pub const IDENTITY: Self = Self { alpha: Complex::ONE, beta: Complex::ZERO };

    /// Cayley-Klein parameter γ = -β̄.
    pub fn gamma(&self) -> Complex<R> {
        -self.beta.conj()
    }

    /// Cayley-Klein parameter δ = ᾱ.
    pub fn delta(&self) -> Complex<R> {
        self.alpha.conj()
    }

    /// Determinant |α|² + |β|².
    pub fn norm_squared(&self) -> R {
        self.alpha.norm_squared() + self.beta.norm_squared()
    }

    /// Inverse Φ⁻¹ = ((δ, -β), (-γ, α)).
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { alpha: self.alpha.conj(), beta: -self.beta }
    }

    /// Product Φ Ψ: the rotation Ψ followed by Φ.
    #[must_use]
    pub fn compose(&self, psi: &Self) -> Self {
        Self {
            alpha: self.alpha * psi.alpha + self.beta * psi.gamma(),
            beta: self.alpha * psi.beta + self.beta * psi.delta(),
        }
    }

    /// Adjoint action Ad_Φ: fixed coordinates Φ X Φ⁻¹ of the vector with body coordinates X.
    pub fn adjoint(&self, body: Vector<R>) -> Vector<R> {
        // with w = X₁ + i X₂ and Φ X = ½ i ((q, p), ...), p = αw - βX₃ and q = αX₃ + βw̄:
        //   x₁ + i x₂ = αp - βq,   x₃ = Re(ᾱq + β̄p)
        let [x1, x2, x3] = body;
        let w = Complex::new(x1, x2);
        let alpha = self.alpha;
        let beta = self.beta;
        let p = alpha * w - beta.scaled(x3);
        let q = alpha.scaled(x3) + beta * w.conj();
        let horizontal = alpha * p - beta * q;
        let vertical =
            R::inner([alpha.re, alpha.im], [q.re, q.im]) + R::inner([beta.re, beta.im], [p.re, p.im]);
        [horizontal.re, horizontal.im, vertical]
    }

    /// Symmetry axis r = Φ e₃ Φ⁻¹, from the tip to the centre of mass: r₁ + i r₂ = -2αβ, r₃ = u.
    pub fn axis(&self) -> Vector<R> {
        let tip = self.tip_over_s();
        [-tip.re, -tip.im, self.u()]
    }

    /// Rate r' = Φ (Ω × e₃) Φ⁻¹ of the symmetry axis in the fixed frame, from Ω in the body frame.
    pub fn axis_rate(&self, [x1, x2, _]: Vector<R>) -> Vector<R> {
        self.adjoint([x2, -x1, R::ZERO])
    }

    /// Orientation from a quaternion, the inverse of [`Orientation::quaternion`]. It is not normalised.
    pub fn from_quaternion([w, x, y, z]: [R; 4]) -> Self {
        Self { alpha: Complex::new(w, z), beta: Complex::new(-y, x) }
    }

    /// Tip position 2αβ in units of s, x + iy, from the point below the centre of mass.
    #[inline]
    pub fn tip_over_s(&self) -> Complex<R> {
        let product = self.alpha * self.beta;
        Complex::new(product.re.doubled(), product.im.doubled())
    }

    /// Rotation matrix Ad_Φ by rows, from body to fixed coordinates. The third column is the axis.
    pub fn matrix(&self) -> [Vector<R>; 3] {
        let zero = R::ZERO;
        let one = R::ONE;
        let [a, b] = [[one, zero, zero], [zero, one, zero]].map(|body| self.adjoint(body));
        let [a1, a2, a3] = a;
        let [b1, b2, b3] = b;
        let [r1, r2, r3] = self.axis();
        [[a1, b1, r1], [a2, b2, r2], [a3, b3, r3]]
    }

    /// Cosine of the tilt, u = |α|² - |β|² = Re((α + β)(ᾱ - β̄)). A rounding can take it past ±1.
    pub fn u(&self) -> R {
        let sum = self.alpha + self.beta;
        let difference = self.alpha - self.beta;
        R::inner([sum.re, sum.im], [difference.re, difference.im])
    }
}

impl<R: Float> Orientation<R> {
    /// Distance 2 √(|Δα|² + |Δβ|²), rad: the angle between two orientations, if small. Φ and -Φ are 4 rad apart.
    pub fn distance(&self, other: &Self) -> R {
        let difference = Self { alpha: self.alpha - other.alpha, beta: self.beta - other.beta };
        difference.norm_squared().sqrt().doubled()
    }

    /// Orientation of unit norm, Φ / √(|α|² + |β|²).
    #[must_use]
    pub fn normalised(&self) -> Self {
        let scale = R::ONE / self.norm_squared().sqrt();
        Self { alpha: self.alpha.scaled(scale), beta: self.beta.scaled(scale) }
    }
}

impl<R: Real> Orientation<R> {
    /// Exponential of an element of su(2): the rotation by |x| rad about x; the identity where a component is not finite.
    pub fn exp(x: Vector<R>) -> Self {
        let [a, b, c] = x.map(R::abs);
        let size = a.larger_or_nan(b).larger_or_nan(c);
        let is_finite = x.iter().all(|component| component.to_f64().is_finite());
        if !is_finite || size == R::ZERO {
            return Self::IDENTITY;
        }
        // a square of x could leave the range
        let direction = x.map(|component| component / size);
        let length = dot(direction, direction).sqrt();
        // libm reduces also an angle that `Extended` cannot
        let (sine, cosine) = libm::sincos(0.5 * length.to_f64() * size.to_f64());
        let scale = R::from_f64(sine) / length;
        let [x1, x2, x3] = direction.map(|component| component * scale);
        Self::from_quaternion([R::from_f64(cosine), x1, x2, x3])
    }
}

/// Rate of change Φ' of an orientation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OrientationRate<R> {
    /// Rate α', per unit time.
    pub alpha: Complex<R>,
    /// Rate β', per unit time.
    pub beta: Complex<R>,
}

/// Orientation and its rate at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AttitudeState<R> {
    /// Orientation Φ.
    pub orientation: Orientation<R>,
    /// Rate Φ' of the orientation, per unit time.
    pub rate: OrientationRate<R>,
}

impl<R: Float> AttitudeState<R> {
    /// State from Φ and the angular velocity ω in the fixed frame: Φ' = ω Φ.
    pub fn from_fixed(orientation: Orientation<R>, omega: Vector<R>) -> Self {
        Self::new(orientation, matrix_of(omega).compose(&orientation))
    }

    /// State from Φ and the angular velocity Ω in the body frame: Φ' = Φ Ω.
    pub fn from_body(orientation: Orientation<R>, omega: Vector<R>) -> Self {
        Self::new(orientation, orientation.compose(&matrix_of(omega)))
    }

    fn new(orientation: Orientation<R>, Orientation { alpha, beta }: Orientation<R>) -> Self {
        Self { orientation, rate: OrientationRate { alpha, beta } }
    }
}

/// Matrix of su(2) that stands for a vector. Their product is the product of orientations.
fn matrix_of<R: Float>(vector: Vector<R>) -> Orientation<R> {
    let [x, y, z] = vector.map(Float::halved);
    Orientation::from_quaternion([R::ZERO, x, y, z])
}

impl<R: Ring> AttitudeState<R> {
    /// Rate u' = d(|α|² - |β|²)/dt of the cosine of the tilt, per unit time.
    pub fn udot(&self) -> R {
        let Self { orientation: phi, rate } = self;
        ((phi.alpha.conj() * rate.alpha).re - (phi.beta.conj() * rate.beta).re).doubled()
    }

    /// Angular velocity ω = Φ' Φ⁻¹ in the fixed frame, rad/s: equation (2.2) of the paper, erratum 1 corrected.
    pub fn omega(&self) -> Vector<R> {
        let Self { orientation: phi, rate } = self;
        let diagonal = rate.alpha * phi.delta() - rate.beta * phi.gamma();
        let upper = rate.beta * phi.alpha - rate.alpha * phi.beta;
        [upper.im.doubled(), -upper.re.doubled(), diagonal.im.doubled()]
    }

    /// Angular velocity Ω = Φ⁻¹ Φ' in the body frame, rad/s: equation (2.3) of the paper, erratum 2 corrected.
    pub fn omega_body(&self) -> Vector<R> {
        let Self { orientation: phi, rate } = self;
        let gamma = -rate.beta.conj();
        let delta = rate.alpha.conj();
        let diagonal = phi.delta() * rate.alpha - phi.beta * gamma;
        let upper = phi.delta() * rate.beta - phi.beta * delta;
        [upper.im.doubled(), -upper.re.doubled(), diagonal.im.doubled()]
    }
}

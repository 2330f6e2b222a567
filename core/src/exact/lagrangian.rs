//! Lagrangian formulation (section 3.1): T, V, L, the momentum m = ∂L/∂ω and the equations of motion in (Φ, m).
//!
//! The tangent space is trivialised by right multiplication, Φ' = ωΦ, so ω and m are vectors of the fixed frame. With
//! r = ΦkΦ⁻¹ and q = [r, k]:
//!
//! ```text
//! T  = A⟨ω, ω⟩/2 + (C - A)⟨ω, r⟩²/2 + ps⟨q, ω⟩²/2        V = pg⟨r, k⟩        L = T + K⟨ω, r⟩ - V
//! m  = Aω + ((C - A)⟨ω, r⟩ + K) r + ps⟨q, ω⟩ q
//! DL = ((C - A)⟨ω, r⟩ + K) [r, ω] + ps⟨q, ω⟩ [r, [k, ω]] - pg q        (printed with + in front of the last term)
//! m' = [ω, m] + DL                                               (equation (3.1))
//! ```
//!
//! The momentum K of a rotor in the body, which the paper does not treat, adds K⟨ω, r⟩ to L (Routh's function of the
//! rotor's angle).

use crate::scalar::Float;
use crate::su2::{Orientation, Vector, bracket, dot};
use crate::top::{Quantities, Top};

/// Lagrangian L = T - V of a top. A fixed tip is the case s = 0, with moments of inertia about the tip.
///
/// Its error is the rounding of about thirty operations of the number type: `f32`, `f64`, or
/// [`Extended`](crate::scalar::Extended), in which a numerical derivative has twenty correct digits.
#[derive(Clone, Copy, Debug)]
pub struct Lagrangian<F> {
    a: F,
    c: F,
    /// Product p s, kg m².
    ps: F,
    /// Product p g, kg m²/s².
    pg: F,
    k: F,
}

/// Upward vertical k = e₃.
fn up<F: Float>() -> Vector<F> {
    [F::ZERO, F::ZERO, F::ONE]
}

fn sum<F: Float>(x: Vector<F>, y: Vector<F>) -> Vector<F> {
    let ([x1, x2, x3], [y1, y2, y3]) = (x, y);
    [x1 + y1, x2 + y2, x3 + y3]
}

fn times<F: Float>(factor: F, x: Vector<F>) -> Vector<F> {
    x.map(|component| factor * component)
}

impl<F: Float> Lagrangian<F> {
    /// Lagrangian of a top, whose parameters count as exact.
    #[must_use]
    pub fn new(top: &Top) -> Self {
        let Quantities { a, c, s, p, g, k } = Quantities::as_given(top);
        Self { a, c, ps: p * s, pg: p * g, k }
    }

    /// Kinetic energy T(Φ, ω), J: the rotation about the centre of mass, and (last term) the vertical motion of the
    /// centre of mass.
    #[must_use]
    pub fn kinetic(&self, phi: &Orientation<F>, omega: Vector<F>) -> F {
        let (r, q) = axis_and_normal(phi);
        let squares = self.a * dot(omega, omega)
            + (self.c - self.a) * dot(omega, r).squared()
            + self.ps * dot(q, omega).squared();
        squares.halved()
    }

    /// Potential energy V(Φ) = pg u, J: 0 where the centre of mass is at the height of the tip.
    #[must_use]
    pub fn potential(&self, phi: &Orientation<F>) -> F {
        self.pg * phi.u()
    }

    /// Lagrangian L = T + K⟨ω, r⟩ - V, J.
    #[must_use]
    pub fn value(&self, phi: &Orientation<F>, omega: Vector<F>) -> F {
        self.kinetic(phi, omega) + self.k * dot(omega, phi.axis()) - self.potential(phi)
    }

    /// Energy h = T + V, J.
    #[must_use]
    pub fn energy(&self, phi: &Orientation<F>, omega: Vector<F>) -> F {
        self.kinetic(phi, omega) + self.potential(phi)
    }

    /// Momentum m = ∂L/∂ω, kg m²/s. Its vertical and axial components are the first integrals l = ⟨m, k⟩ and n = ⟨m,
    /// r⟩.
    #[must_use]
    pub fn momentum(&self, phi: &Orientation<F>, omega: Vector<F>) -> Vector<F> {
        let (r, q) = axis_and_normal(phi);
        let axial = times(self.beyond_sphere(r, omega), r);
        let rising = times(self.ps * dot(q, omega), q);
        sum(times(self.a, omega), sum(axial, rising))
    }

    /// Angular velocity ω of a momentum: the inverse of [`Lagrangian::momentum`]. No matrix is inverted, because ⟨m,
    /// r⟩ = C⟨ω, r⟩ + K and ⟨m, q⟩ = (A + ps|q|²)⟨ω, q⟩. Where C = 0 the momentum does not determine ⟨ω, r⟩, which is then 0.
    #[must_use]
    pub fn omega(&self, phi: &Orientation<F>, m: Vector<F>) -> Vector<F> {
        let (r, q) = axis_and_normal(phi);
        let spin = if self.c > F::ZERO { (dot(m, r) - self.k) / self.c } else { F::ZERO };
        let axial = times(-((self.c - self.a) * spin + self.k), r);
        let rising = times(-(self.ps * dot(m, q) / (self.a + self.ps * dot(q, q))), q);
        times(F::ONE / self.a, sum(m, sum(axial, rising)))
    }

    /// Derivative DL with respect to the orientation: ⟨DL, η⟩ = d/dε L(e^{εη}Φ, ω) at ε = 0, J/rad.
    #[must_use]
    pub fn derivative(&self, phi: &Orientation<F>, omega: Vector<F>) -> Vector<F> {
        let (r, q) = axis_and_normal(phi);
        let axial = times(self.beyond_sphere(r, omega), bracket(r, omega));
        let rising = times(self.ps * dot(q, omega), bracket(r, bracket(up(), omega)));
        sum(sum(axial, rising), times(-self.pg, q))
    }

    /// Rate m' = [ω, m] + DL of the momentum (equation (3.1) of the paper), kg m²/s². The rate of the orientation, Φ'
    /// = ωΦ, is [`OrientationRate::from_fixed`](crate::su2::OrientationRate::from_fixed).
    #[must_use]
    pub fn momentum_rate(&self, phi: &Orientation<F>, omega: Vector<F>) -> Vector<F> {
        sum(bracket(omega, self.momentum(phi, omega)), self.derivative(phi, omega))
    }

    /// Axial momentum beyond that of a sphere with the moment of inertia A: (C - A)⟨ω, r⟩ + K, kg m²/s.
    fn beyond_sphere(&self, r: Vector<F>, omega: Vector<F>) -> F {
        (self.c - self.a) * dot(omega, r) + self.k
    }
}

/// Vectors r and q = [r, k].
fn axis_and_normal<F: Float>(phi: &Orientation<F>) -> (Vector<F>, Vector<F>) {
    let r = phi.axis();
    (r, bracket(r, up()))
}

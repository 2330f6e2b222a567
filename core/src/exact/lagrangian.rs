//! The Lagrangian side (section 3.1): T, V, L, the momentum m = ∂L/∂ω and the equations of motion in (Φ, m).
//!
//! The tangent space is trivialised by right multiplication, Φ' = ωΦ, so ω and m are vectors of the fixed frame. With
//! r = ΦkΦ⁻¹ and q = [r, k]:
//!
//! ```text
//! T  = A⟨ω, ω⟩/2 + (C - A)⟨ω, r⟩²/2 + ps⟨q, ω⟩²/2        V = pg⟨r, k⟩        L = T - V
//! m  = Aω + (C - A)⟨ω, r⟩ r + ps⟨q, ω⟩ q
//! DL = (C - A)⟨ω, r⟩ [r, ω] + ps⟨q, ω⟩ [r, [k, ω]] - pg q        (printed with + in front of the last term)
//! m' = [ω, m] + DL                                               (eqn:motion)
//! ```

use crate::real::Float;
use crate::su2::{Phi, Vector, bracket, dot};
use crate::top::{Quantities, Top};

/// L = T - V of a top. The fixed tip is the case s = 0, with inertias about the tip.
///
/// Exact but for the rounding of some thirty operations of the scalar: `f32`, `f64`, or
/// [`DoubleDouble`](crate::real::DoubleDouble), in which numerical differentiation has twenty digits left.
#[derive(Clone, Copy, Debug)]
pub struct Lagrangian<F> {
    a: F,
    c: F,
    /// p s, kg m².
    ps: F,
    /// p g, kg m²/s².
    pg: F,
}

/// k = e₃, the upward vertical.
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
    /// Of a top, its numbers taken as exact.
    #[must_use]
    pub fn new(top: &Top) -> Self {
        let Quantities { a, c, s, p, g } = Quantities::of(top);
        Self { a, c, ps: p * s, pg: p * g }
    }

    /// T(Φ, ω) (eqn:kinetic), J: the rotation about the centre of mass, and (last term) its rise and fall.
    #[must_use]
    pub fn kinetic(&self, phi: &Phi<F>, omega: Vector<F>) -> F {
        let (r, q) = axis_and_normal(phi);
        let squares = self.a * dot(omega, omega)
            + (self.c - self.a) * dot(omega, r).squared()
            + self.ps * dot(q, omega).squared();
        squares.halved()
    }

    /// V(Φ) = pg u, J: 0 with the centre of mass in the plane of the tip.
    #[must_use]
    pub fn potential(&self, phi: &Phi<F>) -> F {
        self.pg * phi.u()
    }

    /// L = T - V (eqn:lagrange), J.
    #[must_use]
    pub fn value(&self, phi: &Phi<F>, omega: Vector<F>) -> F {
        self.kinetic(phi, omega) - self.potential(phi)
    }

    /// The energy h = T + V, J.
    #[must_use]
    pub fn energy(&self, phi: &Phi<F>, omega: Vector<F>) -> F {
        self.kinetic(phi, omega) + self.potential(phi)
    }

    /// m = ∂L/∂ω, kg m²/s. Its vertical and axial parts are the integrals l = ⟨m, k⟩ and n = ⟨m, r⟩.
    #[must_use]
    pub fn momentum(&self, phi: &Phi<F>, omega: Vector<F>) -> Vector<F> {
        let (r, q) = axis_and_normal(phi);
        let axial = times((self.c - self.a) * dot(omega, r), r);
        let rising = times(self.ps * dot(q, omega), q);
        sum(times(self.a, omega), sum(axial, rising))
    }

    /// ω of a momentum: the inverse of [`Lagrangian::momentum`], with no matrix to invert, since
    /// ⟨m, r⟩ = C⟨ω, r⟩ and ⟨m, q⟩ = (A + ps|q|²)⟨ω, q⟩.
    #[must_use]
    pub fn omega(&self, phi: &Phi<F>, m: Vector<F>) -> Vector<F> {
        let (r, q) = axis_and_normal(phi);
        let axial = times(-((self.c - self.a) / self.c * dot(m, r)), r);
        let rising = times(-(self.ps * dot(m, q) / (self.a + self.ps * dot(q, q))), q);
        times(F::ONE / self.a, sum(m, sum(axial, rising)))
    }

    /// DL, the derivative by the first argument: ⟨DL, η⟩ = d/dε L(e^{εη}Φ, ω) at ε = 0, J/rad.
    #[must_use]
    pub fn derivative(&self, phi: &Phi<F>, omega: Vector<F>) -> Vector<F> {
        let (r, q) = axis_and_normal(phi);
        let axial = times((self.c - self.a) * dot(omega, r), bracket(r, omega));
        let rising = times(self.ps * dot(q, omega), bracket(r, bracket(up(), omega)));
        sum(sum(axial, rising), times(-self.pg, q))
    }

    /// m' = [ω, m] + DL (eqn:motion), kg m²/s²; the other half, Φ' = ωΦ, is
    /// [`PhiRate::from_fixed`](crate::su2::PhiRate::from_fixed).
    #[must_use]
    pub fn momentum_rate(&self, phi: &Phi<F>, omega: Vector<F>) -> Vector<F> {
        sum(bracket(omega, self.momentum(phi, omega)), self.derivative(phi, omega))
    }
}

/// r and q = [r, k].
fn axis_and_normal<F: Float>(phi: &Phi<F>) -> (Vector<F>, Vector<F>) {
    let r = phi.axis();
    (r, bracket(r, up()))
}

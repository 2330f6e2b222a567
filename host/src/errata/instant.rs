//! Generic motion at one time, with all quantities in the formulas of sections 2 to 4.

use crate::full_equations::full_solver::{Equations, FullState, FullTop, cross, dot};
use num_complex::Complex64 as C;
use toytop::{Complex, Orientation};

/// Generic top for sections 2 to 4, with g = 1.
pub(super) const TOP: FullTop = FullTop { a: 1.1, c: 0.8, s: 0.6, p: 0.9, g: 1.0, k: 0.0 };

/// Generic motion at one time. Φ' follows from the full equations.
pub(super) struct Instant {
    pub(super) state: FullState,
    /// Parameters α, β, γ, δ.
    pub(super) phi: [C; 4],
    /// Rates α', β', γ', δ'.
    pub(super) rate: [C; 4],
    /// Angular velocity ω in the fixed frame.
    pub(super) omega: [f64; 3],
    /// Angular velocity Ω in the body frame.
    pub(super) body: [f64; 3],
    /// Axis r.
    pub(super) axis: [f64; 3],
    /// Vector [r, k].
    pub(super) normal: [f64; 3],
    pub(super) l: f64,
    pub(super) n: f64,
    pub(super) u: f64,
    pub(super) udot: f64,
}

impl Instant {
    /// Instant that all formulas are evaluated at.
    pub(super) fn generic() -> Self {
        let norm = 0.74_f64.sqrt();
        let state = FullState {
            alpha: [0.6, 0.3].map(|x| x / norm),
            beta: [-0.2, 0.5].map(|x| x / norm),
            omega: [0.4, -0.7, 1.3],
        };
        let equations = Equations::of(&TOP, &state);
        let [m1, m2, m3] = equations.momentum(&state);
        let ([a, b], [c, d]) = (state.alpha, state.beta);
        let slope = equations.derivative(&[a, b, c, d, m1, m2, m3]);
        let four = |[a, b, c, d]: [f64; 4]| {
            let (alpha, beta) = (C::new(a, b), C::new(c, d));
            [alpha, beta, -beta.conj(), alpha.conj()]
        };
        let axis = state.axis();
        let (l, n, _) = TOP.first_integrals(&state);
        let phi = Orientation { alpha: Complex::new(a, b), beta: Complex::new(c, d) };
        Self {
            state,
            phi: four([a, b, c, d]),
            rate: four([slope[0], slope[1], slope[2], slope[3]]),
            omega: state.omega,
            body: phi.inverse().adjoint(state.omega),
            axis,
            normal: cross(axis, [0.0, 0.0, 1.0]),
            l,
            n,
            u: axis[2],
            udot: state.axis_height_rate(),
        }
    }

    /// Axial angular velocity ⟨ω, r⟩.
    pub(super) fn spin(&self) -> f64 {
        dot(self.omega, self.axis)
    }

    /// Rate τ = (1/C - 1/A) n.
    pub(super) fn tau(&self) -> f64 {
        (1.0 / TOP.c - 1.0 / TOP.a) * self.n
    }
}

/// Square of the branch point e₄.
pub(super) fn e4_squared() -> f64 {
    1.0 + TOP.a / (TOP.p * TOP.s)
}

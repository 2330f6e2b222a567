//! First integrals of a state, and its point of the reduced curve.

use crate::body::{State, Top};
use crate::constants::FirstIntegrals;
use crate::scalar::{Extended, Float, Ring};
use crate::su2::{cross, dot};

/// Point (u, u') of the reduced curve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReducedPoint {
    pub(crate) u: Extended,
    pub(crate) one_minus_u: Extended,
    pub(crate) one_plus_u: Extended,
    pub(crate) udot: Extended,
    /// Kinetic energy of the axis, (A |ω × r|² + p s u'²)/2, in units of [`Top::energy_unit`].
    pub(crate) scaled_axis_energy: Extended,
}

impl ReducedPoint {
    /// Whether the axis is upright and does not move.
    pub(crate) fn is_sleeping(&self) -> bool {
        self.one_minus_u == Extended::ZERO && self.scaled_axis_energy == Extended::ZERO
    }

    /// Difference l - n u without cancellation.
    pub(crate) fn l_minus_nu(&self, integrals: &FirstIntegrals<Extended>) -> Extended {
        let FirstIntegrals { n, l_plus_n, l_minus_n, .. } = *integrals;
        if self.u > Extended::ZERO {
            l_minus_n + n * self.one_minus_u
        } else {
            l_plus_n - n * self.one_plus_u
        }
    }

    /// Angular momentum |m| without torque: |m|² = n² + A²|ω × r|².
    pub(crate) fn momentum(&self, a: Extended, n: Extended) -> Extended {
        ((a * self.scaled_axis_energy).doubled() + n.squared()).sqrt()
    }
}

impl FirstIntegrals {
    /// First integrals of a state. Error: one `f64` rounding of the result.
    pub fn from_state(top: &Top, state: &State) -> Self {
        FirstIntegrals::from_state_with_point(top, state, &mut || {}).0.map(Float::to_f64)
    }
}

impl FirstIntegrals<Extended> {
    /// First integrals in extended precision, and the point of the reduced curve.
    #[inline(never)]
    pub(crate) fn from_state_with_point(
        top: &Top,
        state: &State,
        pause: &mut dyn FnMut(),
    ) -> (Self, ReducedPoint) {
        let Top { a, c, s, p, g, k, .. } = *top;
        let unit = top.energy_unit();
        let (phi, omega) = state.to_extended();
        // without a square root a simple fraction remains exact, and so does the vertical, where n = C ω₃
        let norm = phi.norm_squared();
        let one_minus_u = phi.beta.norm_squared().doubled() / norm;
        let one_plus_u = phi.alpha.norm_squared().doubled() / norm;
        let r = phi.axis().map(|component| component / norm);
        let [r1, r2, u] = r;
        let [w1, w2, _] = omega;
        pause();
        let spin = dot(omega, r);
        let n = c * spin + k;
        let udot = w1 * r2 - w2 * r1;
        let r_dot = cross(omega, r);
        let (l_minus_n, l_plus_n) = if c > Extended::ZERO {
            // l ∓ n = A ⟨ω, k ∓ r⟩ ∓ ((C - A) ⟨ω, r⟩ + K) (1 ∓ u), without cancellation
            let excess_momentum = (c - a) * spin + k;
            (
                a * dot(omega, [-r1, -r2, one_minus_u]) - excess_momentum * one_minus_u,
                a * dot(omega, [r1, r2, one_plus_u]) + excess_momentum * one_plus_u,
            )
        } else {
            // l ∓ n = A ⟨r × r', k⟩ ∓ K (1 ∓ u): the axial rate of a rod may be far greater
            let [x, y, _] = r_dot;
            let about_k = a * (r1 * y - r2 * x);
            (about_k - k * one_minus_u, about_k + k * one_plus_u)
        };

        let scaled_axis_energy = (a * dot(r_dot, r_dot) + p * s * udot.squared()) / unit.doubled();
        let h = (c * spin.squared()).halved() + p * g * u + unit * scaled_axis_energy;

        let integrals = Self { l: (l_plus_n + l_minus_n).halved(), n, h, spin, l_plus_n, l_minus_n };
        (integrals, ReducedPoint { u, one_minus_u, one_plus_u, udot, scaled_axis_energy })
    }
}

//! First integrals l, n and h (Proposition 1 of the paper), and the signs of l + n and l - n.

use crate::body::{State, Top};
use crate::constants::ReducedPoint;
use crate::scalar::{Extended, Float, Ring, numeric_struct};
use crate::su2::{cross, dot};

numeric_struct! {
    /// First integrals l, n and h: two components of the angular momentum, and the energy. The other numbers follow from
    /// them, except `spin` where C = 0.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    #[non_exhaustive]
    pub struct FirstIntegrals<F = f64> {
        /// Vertical angular momentum l = ⟨m, k⟩, kg m²/s.
        pub l,
        /// Axial angular momentum n = ⟨m, r⟩ = C ⟨ω, r⟩ + K, kg m²/s.
        pub n,
        /// Energy h = T + V, J; V = 0 at the height of the tip. The constant energy of a rotor relative to the body is left out.
        pub h,
        /// Axial rate ⟨ω, r⟩ of the body, rad/s: (n - K)/C; a further constant where C = 0.
        pub spin,
        /// Sum l + n, kg m²/s.
        pub l_plus_n,
        /// Difference l - n, kg m²/s.
        pub l_minus_n,
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

    /// Difference l - n u at a point, without cancellation.
    pub(crate) fn l_minus_nu(&self, point: &ReducedPoint) -> Extended {
        if point.u > Extended::ZERO {
            self.l_minus_n + self.n * point.one_minus_u
        } else {
            self.l_plus_n - self.n * point.one_plus_u
        }
    }
}

impl<F: Float> FirstIntegrals<F> {
    /// Signs of l + n and l - n; + where the number is 0.
    pub fn signs(&self) -> Signs {
        Signs { l_plus_n: Sign::new(self.l_plus_n), l_minus_n: Sign::new(self.l_minus_n) }
    }
}

/// Sign, + or -.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Sign {
    /// Positive, +.
    #[default]
    Plus,
    /// Negative, -.
    Minus,
}

impl Sign {
    /// Sign of x; + for 0.
    pub fn new<R: Ring>(x: R) -> Self {
        if x < R::ZERO { Self::Minus } else { Self::Plus }
    }

    /// Product ±x.
    pub fn times<R: Ring>(self, x: R) -> R {
        match self {
            Self::Plus => x,
            Self::Minus => -x,
        }
    }

    /// Integer ±1.
    pub fn as_i32(self) -> i32 {
        match self {
            Self::Plus => 1,
            Self::Minus => -1,
        }
    }
}

/// Signs of l + n and l - n. They are equal if |l| > |n|. In a launch from a state, 0 counts as +.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Signs {
    /// Sign of l + n.
    pub l_plus_n: Sign,
    /// Sign of l - n.
    pub l_minus_n: Sign,
}

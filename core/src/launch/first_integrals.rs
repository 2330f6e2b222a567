//! l, n and h of a state (Proposition 1 of the paper).

use super::State;
use crate::real::{DoubleDouble, Float, Ring};
use crate::su2::{bracket, dot};
use crate::top::{Quantities, Top};

/// A sign, + or -.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Sign {
    /// +
    #[default]
    Plus,
    /// -
    Minus,
}

impl Sign {
    /// The sign of x; + for 0.
    pub fn of<R: Ring>(x: R) -> Self {
        if x < R::ZERO { Self::Minus } else { Self::Plus }
    }

    /// ±x.
    pub fn times<R: Ring>(self, x: R) -> R {
        match self {
            Self::Plus => x,
            Self::Minus => -x,
        }
    }

    /// ±1.
    #[must_use]
    pub fn factor(self) -> i32 {
        match self {
            Self::Plus => 1,
            Self::Minus => -1,
        }
    }
}

/// The signs of l + n and of l - n: what (e₁, e₂, e₃) leave open of a motion.
///
/// Equal signs mean |l| > |n|, unequal ones |l| < |n|. Where one of the two combinations vanishes its sign is free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Signs {
    /// The sign of l + n.
    pub l_plus_n: Sign,
    /// The sign of l - n.
    pub l_minus_n: Sign,
}

/// The first integrals: two angular momenta and the energy.
///
/// l + n and l - n are kept beside l and n: near the vertical one of them is small, and a difference of rounded numbers
/// would lose it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FirstIntegrals<F = f64> {
    /// l = ⟨m, k⟩, the vertical angular momentum, kg m²/s.
    pub l: F,
    /// n = ⟨m, r⟩ = C ⟨ω, r⟩, the axial angular momentum, kg m²/s.
    pub n: F,
    /// h = T + V, the energy, kg m²/s²; V = 0 with the centre of mass in the plane of the tip.
    pub h: F,
    /// l + n.
    pub l_plus_n: F,
    /// l - n.
    pub l_minus_n: F,
}

/// Where the axis is on its reduced curve (u, u'), and what the cubic needs to know there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReducedPoint<F> {
    pub(crate) u: F,
    pub(crate) one_minus_u: F,
    pub(crate) one_plus_u: F,
    pub(crate) udot: F,
    /// K = (A |ω × r|² + p s u'²)/(2 p g), the kinetic energy of the axis in units of p g.
    pub(crate) excess: F,
}

impl FirstIntegrals {
    /// l, n, h of a state. Error: a rounding of the result; computed in double-double.
    #[must_use]
    pub fn of(top: &Top, state: &State) -> Self {
        FirstIntegrals::<DoubleDouble>::with_point(top, state).0.to_f64()
    }
}

impl<F: Float> FirstIntegrals<F> {
    /// The integrals of a state, and the point on the reduced curve it is at.
    pub(crate) fn with_point(top: &Top, state: &State) -> (Self, ReducedPoint<F>) {
        let Quantities { a, c, s, p, g } = Quantities::<F>::of(top);
        let (phi, omega) = state.exact::<F>();
        let r = phi.axis();
        let [r1, r2, u] = r;
        let one_minus_u = phi.beta.norm_squared().doubled();
        let one_plus_u = phi.alpha.norm_squared().doubled();

        let spin = dot(omega, r);
        let n = c * spin;
        // l ∓ n = A ⟨ω, k ∓ r⟩ ∓ (C - A) ⟨ω, r⟩ (1 ∓ u), without the cancellation of l ∓ n itself
        let l_minus_n = a * dot(omega, [-r1, -r2, one_minus_u]) - (c - a) * spin * one_minus_u;
        let l_plus_n = a * dot(omega, [r1, r2, one_plus_u]) + (c - a) * spin * one_plus_u;

        let [w1, w2, _] = omega;
        let udot = w1 * r2 - w2 * r1;
        let r_dot = bracket(omega, r);
        let excess = (a * dot(r_dot, r_dot) + p * s * udot.squared()) / (p * g).doubled();
        let h = n.squared() / c.doubled() + p * g * (u + excess);

        let integrals = Self { l: (l_plus_n + l_minus_n).halved(), n, h, l_plus_n, l_minus_n };
        (integrals, ReducedPoint { u, one_minus_u, one_plus_u, udot, excess })
    }

    /// Rounded to `f64`, each entry by itself.
    #[must_use]
    pub fn to_f64(&self) -> FirstIntegrals {
        FirstIntegrals {
            l: self.l.to_f64(),
            n: self.n.to_f64(),
            h: self.h.to_f64(),
            l_plus_n: self.l_plus_n.to_f64(),
            l_minus_n: self.l_minus_n.to_f64(),
        }
    }

    /// The signs of l + n and l - n; + where one vanishes.
    #[must_use]
    pub fn signs(&self) -> Signs {
        Signs { l_plus_n: Sign::of(self.l_plus_n), l_minus_n: Sign::of(self.l_minus_n) }
    }
}

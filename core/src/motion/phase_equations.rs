//! Phase equations: rates of χ, ψ_α and ψ_β.
//!
//! With sin²χ = (u - e₁)/(e₂ - e₁) they are smooth at the turning points and at the vertical:
//!
//! ```text
//! χ' = √( g (e₃ - u) / (2 D) ),    D(u) = A/p + s (1 - u²)
//! √2 α = [√(1+e₁) cos χ + i s₊ √(1+e₂) sin χ] e^{iλ_α},    λ_α = λ_α(0) + ψ_α + τt/2
//! √2 β = [√(1-e₁) cos χ + i s₋ √(1-e₂) sin χ] e^{iλ_β},    λ_β = λ_β(0) + ψ_β - τt/2
//! ```
//!
//! s₊ and s₋ are the signs of l + n and l - n. The ellipses absorb the factors 1/(1 ± u) of the paper's integrals (equation (3.10)).

use crate::body::Top;
use crate::constants::{BranchPoints, Signs};
use crate::integer::exponent;
use crate::scalar::{Extended, Float, Ring, numeric_struct};

numeric_struct! {
    /// Rates of the three phases, rad/s.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub(crate) struct PhaseRates<F> {
        /// Rate χ'.
        pub(crate) chi,
        /// Rate ψ_α'.
        pub(crate) psi_alpha,
        /// Rate ψ_β'.
        pub(crate) psi_beta,
    }
}

numeric_struct! {
    /// Constants of the equations of one motion. The unit of length is a power of two near A/p.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub(crate) struct PhaseEquations<F> {
        pub(crate) one_plus_e1,
        pub(crate) one_minus_e2,
        pub(crate) e2_minus_e1,
        pub(crate) e3_minus_e2,
        /// Length A/p.
        pub(crate) a_over_p,
        /// Length A/(p (e₃ + 1)).
        pub(crate) a_over_p_by_e3_plus_one,
        pub(crate) s,
        /// Length s (e₃ - 1).
        pub(crate) s_times_e3_minus_one,
        /// Half gravity g/2.
        pub(crate) half_g,
        /// Rate (l + n)/(2A), rad/s.
        pub(crate) alpha_rate_factor,
        /// Coefficient 2 √(A/(2 p g (e₃ + 1))) of χ' in the denominator of ψ_α', s.
        pub(crate) alpha_chi_time,
        /// Rate s₋ √(2 A p g (1-e₁)(1-e₂))/(2A), rad/s.
        pub(crate) beta_rate_factor,
        /// Root √(e₃ - 1).
        pub(crate) root_e3_minus_one,
        /// Coefficient 2 √(A/(2 p g)) of χ' in the denominator of ψ_β', s.
        pub(crate) beta_chi_time,
    }
}

impl PhaseEquations<Extended> {
    /// Equations of a motion, with its rate χ' without torque.
    pub(crate) fn new(
        top: &Top,
        e: &BranchPoints<Extended>,
        l_plus_n: Extended,
        signs: Signs,
        torque_free_rate: Extended,
    ) -> Self {
        if top.is_torque_free() {
            Self::without_torque(torque_free_rate, e)
        } else {
            Self::with_torque(top, e, l_plus_n, signs)
        }
    }

    fn with_torque(top: &Top, e: &BranchPoints<Extended>, l_plus_n: Extended, signs: Signs) -> Self {
        let Top { a, s, p, g, .. } = *top;
        // with lengths near 1 the constants are in the range of `f32`
        let unit = exponent(a.to_f64()) - exponent(p.to_f64());
        let [a_over_p, s, g] = [a / p, s, g].map(|length| length.ldexp(-unit));
        let momentum = ((a * top.p * top.g).doubled() * e.one_minus_e1() * e.one_minus_e2).sqrt();
        let inverse_g = a_over_p / g.doubled();
        Self {
            one_plus_e1: e.one_plus_e1,
            one_minus_e2: e.one_minus_e2,
            e2_minus_e1: e.e2_minus_e1,
            e3_minus_e2: e.e3_minus_e2,
            a_over_p,
            a_over_p_by_e3_plus_one: a_over_p / e.one_plus_e3(),
            s,
            s_times_e3_minus_one: s * e.e3_minus_one,
            half_g: g.halved(),
            alpha_rate_factor: l_plus_n / a.doubled(),
            alpha_chi_time: (inverse_g / e.one_plus_e3()).sqrt().doubled(),
            beta_rate_factor: signs.l_minus_n.times(momentum / a.doubled()),
            root_e3_minus_one: e.e3_minus_one.sqrt(),
            beta_chi_time: inverse_g.sqrt().doubled(),
        }
    }

    /// Equations without torque, the limit e₃ → ∞: χ' is constant, and ψ_α' and ψ_β' are 0.
    ///
    /// With e₃ - u = D = 1 and g/2 = χ'² the formula of χ' gives the constant rate.
    fn without_torque(chi_rate: Extended, e: &BranchPoints<Extended>) -> Self {
        let one = Extended::ONE;
        Self {
            one_plus_e1: e.one_plus_e1,
            one_minus_e2: e.one_minus_e2,
            e3_minus_e2: one,
            a_over_p: one,
            half_g: chi_rate.squared(),
            root_e3_minus_one: one,
            ..Self::ZERO
        }
    }
}

/// Distances of a value of u from -1, 1 and e₃, and the inverse of D(u).
pub(crate) struct TiltDistances<F> {
    pub(crate) one_plus_u: F,
    pub(crate) one_minus_u: F,
    pub(crate) e3_minus_u: F,
    pub(crate) inverse_d: F,
}

impl<F: Float> PhaseEquations<F> {
    /// Distances at given sin χ and cos χ, without cancellation near the vertical.
    pub(crate) fn tilt_distances(&self, sine: F, cosine: F) -> TiltDistances<F> {
        let e2_minus_u = self.e2_minus_e1 * cosine.squared();
        let one_minus_u = self.one_minus_e2 + e2_minus_u;
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * sine.squared();
        let d = self.a_over_p + self.s * one_minus_u * one_plus_u;
        TiltDistances {
            one_plus_u,
            one_minus_u,
            e3_minus_u: self.e3_minus_e2 + e2_minus_u,
            inverse_d: F::ONE / d,
        }
    }

    /// Factors A/(p (e₃ + 1)) + s (1 - u) of ψ_α' and s (1 + u)(e₃ - 1) - A/p of ψ_β'.
    pub(super) fn psi_factors(&self, one_plus_u: F, one_minus_u: F) -> [F; 2] {
        [
            self.a_over_p_by_e3_plus_one + self.s * one_minus_u,
            self.s_times_e3_minus_one * one_plus_u - self.a_over_p,
        ]
    }

    /// Rates of χ, ψ_α and ψ_β at given sin χ and cos χ.
    pub(crate) fn rates(&self, sine: F, cosine: F) -> PhaseRates<F> {
        let TiltDistances { one_plus_u, one_minus_u, e3_minus_u, inverse_d } =
            self.tilt_distances(sine, cosine);
        let chi_rate = (self.half_g * e3_minus_u * inverse_d).sqrt();
        let [alpha, beta] = self.psi_factors(one_plus_u, one_minus_u);
        let beta_divisor = self.root_e3_minus_one + self.beta_chi_time * chi_rate;
        PhaseRates {
            chi: chi_rate,
            psi_alpha: self.alpha_rate_factor * alpha * inverse_d / (F::ONE + self.alpha_chi_time * chi_rate),
            // for e₂ = e₃ = 1 and u = 1 numerator and denominator are 0, and ψ_β' is 0
            psi_beta: if beta_divisor > F::ZERO {
                self.beta_rate_factor * beta * inverse_d / beta_divisor
            } else {
                F::ZERO
            },
        }
    }

    /// Rate v' = χ'/cos χ of an aperiodic motion (e₂ = e₃ = 1), rad/s.
    pub(crate) fn aperiodic_rate(&self, sine: F, cosine: F) -> F {
        (self.half_g * self.e2_minus_e1 * self.tilt_distances(sine, cosine).inverse_d).sqrt()
    }
}

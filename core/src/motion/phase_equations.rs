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
//! The ellipses absorb the factors 1/(1 ± u) of the paper's integrals (equation (3.10)).

use crate::body::{ScaledTop, Top};
use crate::complex::Complex;
use crate::constants::{BranchPoints, Signs};
use crate::scalar::{Float, Ring};

/// Rates of the three phases, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseRates<R> {
    /// Rate of the half phase: χ', or v' of an aperiodic motion.
    pub half_phase: R,
    /// Rate ψ_α'.
    pub psi_alpha: R,
    /// Rate ψ_β'.
    pub psi_beta: R,
}

impl<R: Ring> PhaseRates<R> {
    pub(crate) const ZERO: Self = Self { half_phase: R::ZERO, psi_alpha: R::ZERO, psi_beta: R::ZERO };
}

/// Constants of the equations of one motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseEquations<F> {
    pub(crate) one_plus_e1: F,
    pub(crate) one_minus_e2: F,
    pub(crate) e2_minus_e1: F,
    pub(crate) e3_minus_e2: F,
    /// Length A/p, m.
    pub(crate) a_over_p: F,
    /// Length A/(p (e₃ + 1)), m.
    pub(crate) a_over_p_by_e3_plus_one: F,
    pub(crate) s: F,
    /// Length s (e₃ - 1), m.
    pub(crate) s_times_e3_minus_one: F,
    /// Half gravity g/2, m/s².
    pub(crate) half_g: F,
    /// Rate (l + n)/(2A), rad/s.
    pub(crate) alpha_rate_factor: F,
    /// Coefficient 2 √(A/(2 p g (e₃ + 1))) of χ' in the denominator of ψ_α', s.
    pub(crate) alpha_chi_time: F,
    /// Rate s₋ √(2 A p g (1-e₁)(1-e₂))/(2A), rad/s.
    pub(crate) beta_rate_factor: F,
    /// Root √(e₃ - 1).
    pub(crate) root_e3_minus_one: F,
    /// Coefficient 2 √(A/(2 p g)) of χ' in the denominator of ψ_β', s.
    pub(crate) beta_chi_time: F,
}

impl<F: Float> PhaseEquations<F> {
    pub(crate) fn cast<R: Float>(&self) -> PhaseEquations<R> {
        self.map(|x| R::from_f64(x.to_f64()))
    }

    #[inline(never)]
    pub(crate) fn map<R>(&self, convert: fn(F) -> R) -> PhaseEquations<R> {
        PhaseEquations {
            one_plus_e1: convert(self.one_plus_e1),
            one_minus_e2: convert(self.one_minus_e2),
            e2_minus_e1: convert(self.e2_minus_e1),
            e3_minus_e2: convert(self.e3_minus_e2),
            a_over_p: convert(self.a_over_p),
            a_over_p_by_e3_plus_one: convert(self.a_over_p_by_e3_plus_one),
            s: convert(self.s),
            s_times_e3_minus_one: convert(self.s_times_e3_minus_one),
            half_g: convert(self.half_g),
            alpha_rate_factor: convert(self.alpha_rate_factor),
            alpha_chi_time: convert(self.alpha_chi_time),
            beta_rate_factor: convert(self.beta_rate_factor),
            root_e3_minus_one: convert(self.root_e3_minus_one),
            beta_chi_time: convert(self.beta_chi_time),
        }
    }

    /// Constants before they are computed.
    pub const ZERO: Self = Self {
        one_plus_e1: F::ZERO,
        one_minus_e2: F::ZERO,
        e2_minus_e1: F::ZERO,
        e3_minus_e2: F::ZERO,
        a_over_p: F::ZERO,
        a_over_p_by_e3_plus_one: F::ZERO,
        s: F::ZERO,
        s_times_e3_minus_one: F::ZERO,
        half_g: F::ZERO,
        alpha_rate_factor: F::ZERO,
        alpha_chi_time: F::ZERO,
        beta_rate_factor: F::ZERO,
        root_e3_minus_one: F::ZERO,
        beta_chi_time: F::ZERO,
    };

    pub(crate) fn new(top: &Top, e: &BranchPoints<F>, l_plus_n: F, signs: Signs) -> Self {
        let ScaledTop { a, s, p, g, .. } = ScaledTop::<F>::new(top);
        let a_over_p = a / p;
        let beta_rate_factor =
            ((a * p * g).doubled() * e.one_minus_e1() * e.one_minus_e2).sqrt() / a.doubled();
        let per_g = a_over_p / g.doubled();
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
            alpha_chi_time: (per_g / e.one_plus_e3()).sqrt().doubled(),
            beta_rate_factor: signs.l_minus_n.times(beta_rate_factor),
            root_e3_minus_one: e.e3_minus_one.sqrt(),
            beta_chi_time: per_g.sqrt().doubled(),
        }
    }

    /// Equations without torque, the limit e₃ → ∞: χ' is constant, and ψ_α' and ψ_β' are 0.
    ///
    /// With e₃ - u = D = 1 and g/2 = χ'² the formula of χ' gives the constant rate.
    pub(crate) fn torque_free(chi_rate: F, e: &BranchPoints<F>) -> Self {
        Self {
            one_plus_e1: e.one_plus_e1,
            one_minus_e2: e.one_minus_e2,
            e3_minus_e2: F::ONE,
            a_over_p: F::ONE,
            half_g: chi_rate.squared(),
            root_e3_minus_one: F::ONE,
            ..Self::ZERO
        }
    }

    /// 1 + u, 1 - u and 1/D(u) from sin χ and cos χ, without cancellation near the vertical.
    fn complements_and_per_d(&self, sine: F, cosine: F) -> [F; 3] {
        let one_minus_u = self.one_minus_e2 + self.e2_minus_e1 * cosine.squared();
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * sine.squared();
        [one_plus_u, one_minus_u, F::ONE / (self.a_over_p + self.s * one_minus_u * one_plus_u)]
    }

    /// Rates of χ, ψ_α and ψ_β at given sin χ and cos χ.
    pub fn rates(&self, sine: F, cosine: F) -> PhaseRates<F> {
        let [one_plus_u, one_minus_u, per_d] = self.complements_and_per_d(sine, cosine);
        let e3_minus_u = self.e3_minus_e2 + self.e2_minus_e1 * cosine.squared();
        let chi_rate = (self.half_g * e3_minus_u * per_d).sqrt();
        let beta_divisor = self.root_e3_minus_one + self.beta_chi_time * chi_rate;
        // for e₂ = e₃ = 1 and u = 1 numerator and denominator are 0, and ψ_β' is 0
        let psi_beta = if beta_divisor > F::ZERO {
            self.beta_rate_factor * (self.s_times_e3_minus_one * one_plus_u - self.a_over_p) * per_d
                / beta_divisor
        } else {
            F::ZERO
        };
        let psi_alpha = self.psi_alpha_rate(one_minus_u, per_d, chi_rate);
        PhaseRates { half_phase: chi_rate, psi_alpha, psi_beta }
    }

    fn psi_alpha_rate(&self, one_minus_u: F, per_d: F, chi_rate: F) -> F {
        self.alpha_rate_factor * (self.a_over_p_by_e3_plus_one + self.s * one_minus_u) * per_d
            / (F::ONE + self.alpha_chi_time * chi_rate)
    }

    /// Aperiodic motion (e₂ = e₃ = 1): rates of v and ψ_α at e^{iχ}. The rate of ψ_β is 0.
    pub(crate) fn aperiodic_rates(&self, cis_chi: Complex<F>) -> PhaseRates<F> {
        let [_, one_minus_u, per_d] = self.complements_and_per_d(cis_chi.im, cis_chi.re);
        let v_rate = (self.half_g * self.e2_minus_e1 * per_d).sqrt();
        // χ' = v' sech v
        let psi_alpha = self.psi_alpha_rate(one_minus_u, per_d, v_rate * cis_chi.re);
        PhaseRates { half_phase: v_rate, psi_alpha, psi_beta: F::ZERO }
    }
}

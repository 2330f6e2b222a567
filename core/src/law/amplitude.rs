//! Law with Jacobi's amplitude as the variable of integration: χ = am(v | m), m = (e₂ - e₁)/(e₃ - e₁).
//!
//! With r = √(g (e₃ - e₁)/2) and dn = dn v, dt/dv = √D/r and χ' = r dn/√D, so that the roots and divisions of the law
//! become one root and one division for each slow phase:
//!
//! ```text
//! dψ_A/dv = (l + n)/(2A) (A/(p (e₃ + 1)) + s (1 - u)) / (r (√D + k_A dn))
//! ```
//!
//! with k_A the smoothing time of the law times r, and likewise for ψ_B.

use crate::elliptic::jacobi::AmplitudeSquares;
use crate::law::Law;
use crate::scalar::Float;

/// Time and slow phases as functions of v, up to constant factors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AmplitudeLaw<F> {
    law: Law<F>,
    /// Rate r = √(g (e₃ - e₁)/2).
    rate: F,
    /// Terms of dn in the denominators of ψ_A and ψ_B.
    smoothing: [F; 2],
}

impl<F: Float> AmplitudeLaw<F> {
    pub(crate) fn new(law: &Law<F>) -> Self {
        let rate = (law.half_g * law.e3_minus_e1).sqrt();
        Self { law: *law, rate, smoothing: [law.alpha_smoothing * rate, law.beta_smoothing * rate] }
    }

    /// Derivatives dt/dv, dψ_A/dv and dψ_B/dv, each divided by its factor.
    pub(crate) fn at(&self, squares: &AmplitudeSquares<F>) -> [F; 3] {
        let Self { law, smoothing: [alpha_smoothing, beta_smoothing], .. } = self;
        let one_minus_u = law.one_minus_e2 + law.e2_minus_e1 * squares.cn;
        let one_plus_u = law.one_plus_e1 + law.e2_minus_e1 * squares.sn;
        let root = (law.a_over_p + law.s * one_minus_u * one_plus_u).sqrt();
        let alpha = (law.a_over_p_e3 + law.s * one_minus_u) / (root + *alpha_smoothing * squares.dn);
        let divisor = law.root_e3 * root + *beta_smoothing * squares.dn;
        let beta = (law.s_e3 * one_plus_u - law.a_over_p) / divisor;
        [root, alpha, beta]
    }

    /// Factors of the derivatives.
    pub(crate) fn factors(&self) -> [F; 3] {
        let per_rate = F::ONE / self.rate;
        [per_rate, self.law.alpha_scale * per_rate, self.law.beta_scale * per_rate]
    }
}

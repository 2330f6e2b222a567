//! Phase equations in an elliptic argument v.
//!
//! D = A/p + s (1 - u²) is the product of d₊ = E + √s u and d₋ = E - √s u, with E = √(A/p + s) = √s e₄. The elliptic functions
//! belong to the branch points -e₄, e₁, e₂ and the lesser of e₃ and e₄. With f = e₃ - u, or f = d₋ where e₄ < e₃:
//!
//! ```text
//! (u - e₁)/(e₂ - e₁) = d₊(e₁) sn² v/P,    (e₂ - u)/(e₂ - e₁) = d₊(e₂) cn² v/P,    P = d₊(e₁) sn² v + d₊(e₂) cn² v
//! m₁ = 1 - m = f(e₂) d₊(e₁)/(f(e₁) d₊(e₂)),    f = f(e₁) dn² v d₊/d₊(e₁)
//! e₃ <= e₄:   dt/dv = √(2/(g f(e₁) d₊(e₂))) √d₋ d₊,             χ' = √(g f(e₁)/(2 d₊(e₁))) dn v/√d₋
//! e₄ < e₃:    dt/dv = √(2/(g f(e₁) d₊(e₂))) d₋ d₊/√(e₃ - u),    χ' = √(g d₊(e₁)/(2 f(e₁))) √(e₃ - u)/(d₊ dn v)
//! ```
//!
//! v runs from 0 at u = e₁ to K at u = e₂. All singularities have the imaginary part K', so that the number of nodes grows as K/K'.

use super::landen::JacobiFractions;
use crate::motion::phase_equations::PhaseEquations;
use crate::scalar::Float;

/// Derivatives of t, ψ_α and ψ_β by v, up to constant factors.
#[derive(Clone, Copy, Debug)]
pub(super) struct EllipticEquations<'a, F> {
    equations: &'a PhaseEquations<F>,
    root_s: F,
    /// Difference E - √s, which is d₋ at u = 1 and d₊ at u = -1.
    d_at_vertical: F,
    /// Values of d₊ at e₁ and e₂.
    d_plus: [F; 2],
    /// Whether e₄ < e₃; f is then d₋.
    e4_is_nearer: bool,
    /// Factors of dn v, or of √(e₃ - u), in the denominators of ψ_α and ψ_β.
    chi_factors: [F; 2],
    /// Parameter m of the elliptic functions and m₁ = 1 - m.
    pub(super) parameters: [F; 2],
    /// Factors of the derivatives of t, ψ_α and ψ_β.
    pub(super) factors: [F; 3],
}

impl<'a, F: Float> EllipticEquations<'a, F> {
    #[inline(never)]
    pub(super) fn new(equations: &'a PhaseEquations<F>) -> Self {
        let PhaseEquations { a_over_p, s, e2_minus_e1, e3_minus_e2, half_g, .. } = *equations;
        let root_s = s.sqrt();
        let d_at_vertical = a_over_p / ((a_over_p + s).sqrt() + root_s);
        let at_e1 = d_at_vertical + root_s * equations.one_plus_e1;
        let at_e2 = at_e1 + root_s * e2_minus_e1;
        // e₄ - 1 < e₃ - 1, times s
        let e4_is_nearer = root_s * d_at_vertical < equations.s_times_e3_minus_one;
        // f at e₁ and e₂, and d₊ at the lesser of e₃ and e₄ in the unit of f
        let (f_at_e1, f_at_e2, d_at_nearest);
        if e4_is_nearer {
            f_at_e2 = d_at_vertical + root_s * equations.one_minus_e2;
            f_at_e1 = f_at_e2 + root_s * e2_minus_e1;
            d_at_nearest = (d_at_vertical + root_s).doubled() * root_s;
        } else {
            (f_at_e1, f_at_e2) = (e3_minus_e2 + e2_minus_e1, e3_minus_e2);
            d_at_nearest = at_e2 + root_s * e3_minus_e2;
        }
        let ratio = if e4_is_nearer { at_e1 / f_at_e1 } else { f_at_e1 / at_e1 };
        let rate = (half_g * ratio).sqrt();
        let inverse_whole = F::ONE / (f_at_e1 * at_e2);
        let factor = F::ONE / (half_g * f_at_e1 * at_e2).sqrt();
        Self {
            equations,
            root_s,
            d_at_vertical,
            d_plus: [at_e1, at_e2],
            e4_is_nearer,
            chi_factors: [equations.alpha_chi_time * rate, equations.beta_chi_time * rate],
            parameters: [e2_minus_e1 * d_at_nearest * inverse_whole, f_at_e2 * at_e1 * inverse_whole],
            factors: [factor, equations.alpha_rate_factor * factor, equations.beta_rate_factor * factor],
        }
    }

    /// Derivatives dt/dv, dψ_α/dv and dψ_β/dv, each divided by its factor.
    pub(super) fn at(&self, fractions: &JacobiFractions<F>) -> [F; 3] {
        let Self { equations, root_s, d_at_vertical, d_plus: [at_e1, at_e2], chi_factors, .. } = self;
        let JacobiFractions { sn_squared, cn_squared, dn_numerator, dn_denominator } = *fractions;
        let [low, high] = [*at_e1 * sn_squared, *at_e2 * cn_squared];
        let [alpha_chi, beta_chi] = *chi_factors;
        let sum = low + high;
        // one division for 1/P and dn
        let inverse_product = F::ONE / (sum * dn_denominator);
        let swing_per_p = equations.e2_minus_e1 * inverse_product * dn_denominator;
        let dn = dn_numerator * inverse_product * sum;
        let above_e1 = swing_per_p * low;
        let below_e2 = swing_per_p * high;
        let one_minus_u = equations.one_minus_e2 + below_e2;
        let one_plus_u = equations.one_plus_e1 + above_e1;
        let d_plus = *at_e1 + *root_s * above_e1;
        let d_minus = *d_at_vertical + *root_s * one_minus_u;
        let [alpha, beta] = equations.psi_factors(one_plus_u, one_minus_u);
        if self.e4_is_nearer {
            let root = (equations.e3_minus_e2 + below_e2).sqrt();
            let d_plus_dn = d_plus * dn;
            [
                d_minus * d_plus / root,
                alpha * d_plus_dn / (root * (d_plus_dn + alpha_chi * root)),
                beta * d_plus_dn / (root * (equations.root_e3_minus_one * d_plus_dn + beta_chi * root)),
            ]
        } else {
            let root = d_minus.sqrt();
            [
                root * d_plus,
                alpha / (root + alpha_chi * dn),
                beta / (equations.root_e3_minus_one * root + beta_chi * dn),
            ]
        }
    }
}

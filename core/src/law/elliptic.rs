//! Law with an elliptic argument v as the variable of integration, in which period and slow phases are integrals of
//! smooth periodic functions.
//!
//! D = A/p + s (1 - u²) is the product of d₊ = E + √s u and d₋ = E - √s u, with E = √(A/p + s) = √s e₄. The elliptic functions
//! belong to the four branch points -e₄, e₁, e₂, e₃:
//!
//! ```text
//! (u - e₁)/(e₂ - e₁) = d₊(e₁) sn² v/P,    (e₂ - u)/(e₂ - e₁) = d₊(e₂) cn² v/P,    P = d₊(e₁) sn² v + d₊(e₂) cn² v
//! m = (e₂ - e₁) d₊(e₃)/((e₃ - e₁) d₊(e₂)),    m₁ = 1 - m = (e₃ - e₂) d₊(e₁)/((e₃ - e₁) d₊(e₂))
//! dt/dv = √(2/(g (e₃ - e₁) d₊(e₂))) √d₋ d₊,    χ' = √(g (e₃ - e₁)/(2 d₊(e₁))) dn v/√d₋
//! ```
//!
//! v runs from 0 at u = e₁ to K at u = e₂. The integrands are analytic except at u = e₄ and u = ∞. There v has the imaginary part
//! K', as for all real u beyond e₃ and -e₄. Therefore the trapezoid rule converges as fast for e₄ near 1 and e₁ near -1 as elsewhere, and
//! K/K' alone tells how many nodes it needs. The formulas hold for s = 0, too, where e₄ is infinite.

use crate::elliptic::jacobi::{LandenSteps, SquaresOfWhole};
use crate::law::Law;
use crate::scalar::Float;

/// Time and slow phases as functions of v, up to constant factors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EllipticLaw<F> {
    law: Law<F>,
    root_s: F,
    /// Difference E - √s, which is d₋ at u = 1 and d₊ at u = -1.
    least_root: F,
    /// Values of d₊ at e₁ and e₂.
    roots: [F; 2],
    /// Terms of dn in the denominators of ψ_A and ψ_B.
    smoothing: [F; 2],
}

impl<F: Float> EllipticLaw<F> {
    #[inline(never)] // the stack frames of a launch must not add up
    pub(crate) fn new(law: &Law<F>) -> Self {
        let root_s = law.s.sqrt();
        let least_root = law.a_over_p / ((law.a_over_p + law.s).sqrt() + root_s);
        let at_e1 = least_root + root_s * law.one_plus_e1;
        let at_e2 = at_e1 + root_s * law.e2_minus_e1;
        let rate = (law.half_g * law.e3_minus_e1 / at_e1).sqrt();
        Self {
            law: *law,
            root_s,
            least_root,
            roots: [at_e1, at_e2],
            smoothing: [law.alpha_smoothing * rate, law.beta_smoothing * rate],
        }
    }

    pub(crate) fn law(&self) -> &Law<F> {
        &self.law
    }

    /// Landen transformations of the elliptic functions, of which none is computed yet.
    #[inline(never)]
    pub(crate) fn landen(&self) -> LandenSteps<F> {
        let (Self { law, roots: [at_e1, at_e2], .. }, at_e3) =
            (self, self.roots[1] + self.root_s * self.law.e3_minus_e2);
        let per_whole = F::ONE / (law.e3_minus_e1 * *at_e2);
        LandenSteps::new(law.e2_minus_e1 * at_e3 * per_whole, law.e3_minus_e2 * *at_e1 * per_whole)
    }

    /// Derivatives dt/dv, dψ_A/dv and dψ_B/dv, each divided by its factor.
    pub(crate) fn at(&self, squares: &SquaresOfWhole<F>) -> [F; 3] {
        let Self { law, root_s, least_root, roots: [at_e1, at_e2], smoothing, .. } = self;
        let SquaresOfWhole { sn, cn, dn, whole_of_dn } = *squares;
        let ([low, high], [alpha_smoothing, beta_smoothing]) = ([*at_e1 * sn, *at_e2 * cn], *smoothing);
        let sum = low + high;
        // one division for 1/P and dn
        let per_both = F::ONE / (sum * whole_of_dn);
        let (spread, dn) = (law.e2_minus_e1 * per_both * whole_of_dn, dn * per_both * sum);
        let (above_e1, below_e2) = (spread * low, spread * high);
        let one_minus_u = law.one_minus_e2 + below_e2;
        let one_plus_u = law.one_plus_e1 + above_e1;
        let root = (*least_root + *root_s * one_minus_u).sqrt();
        let time = root * (*at_e1 + *root_s * above_e1);
        let alpha = (law.a_over_p_e3 + law.s * one_minus_u) / (root + alpha_smoothing * dn);
        let divisor = law.root_e3 * root + beta_smoothing * dn;
        let beta = (law.s_e3 * one_plus_u - law.a_over_p) / divisor;
        [time, alpha, beta]
    }

    /// Factors of the derivatives of ψ_A and ψ_B, up to a common one.
    pub(crate) fn slow_scales(&self) -> [f64; 2] {
        [self.law.alpha_scale, self.law.beta_scale].map(Float::to_f64)
    }

    /// Factors of the derivatives.
    pub(crate) fn factors(&self) -> [F; 3] {
        let [_, at_e2] = self.roots;
        let factor = F::ONE / (self.law.half_g * self.law.e3_minus_e1 * at_e2).sqrt();
        [factor, self.law.alpha_scale * factor, self.law.beta_scale * factor]
    }
}

//! Phase equations along half a period.

use crate::motion::phase_equations::{PhaseEquations, PhaseRates};
use crate::scalar::Float;

/// Phase equations of a motion, with its half period.
#[derive(Debug)]
pub(crate) struct PathEquations<F> {
    pub(crate) equations: PhaseEquations<F>,
    /// Half period, s.
    pub(crate) half_period: F,
    /// Residual rates minus ψ_α' and ψ_β', rad/s.
    pub(crate) residual_offsets: [F; 2],
}

impl<F: Float> PathEquations<F> {
    pub(crate) const ZERO: Self =
        Self { equations: PhaseEquations::ZERO, half_period: F::ZERO, residual_offsets: [F::ZERO; 2] };

    /// Rates of χ, ψ_α, ψ_β, ρ_α and ρ_β, rad per half period.
    #[inline(never)]
    pub(crate) fn rates(&self, sine: f64, cosine: f64) -> [f64; 5] {
        let PhaseRates { half_phase, psi_alpha, psi_beta } =
            self.equations.rates(F::from_f64(sine), F::from_f64(cosine));
        let [alpha, beta] = self.residual_offsets;
        [half_phase, psi_alpha, psi_beta, psi_alpha + alpha, psi_beta + beta]
            .map(|rate| (self.half_period * rate).to_f64())
    }
}

//! Nutation period, and the change of the phases over it.

mod landen;

mod elliptic_equations;

mod quadrature;

use crate::scalar::{Extended, Float, Ring};

/// Nutation period, and advance of α and β over one period in turns, whole turns included.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PeriodAdvance {
    /// Period T: time from u = e₁ to e₂ and back to e₁, in the unit of time (s).
    pub period: f64,
    /// Advance (arg α(t+T) - arg α(t))/2π. If e₁ = -1, α passes through 0, where its argument is continued without a jump.
    pub alpha_turns: f64,
    /// Advance (arg β(t+T) - arg β(t))/2π. If e₂ = 1, β passes through 0, where its argument is continued without a jump.
    pub beta_turns: f64,
    /// Advance of the tip angle φ over a period, rad. At the centre it is continued without a jump.
    pub phi_radians: f64,
}

impl PeriodAdvance {
    pub(super) fn new(period: &Period, half_tau: Extended, windings: [i32; 2]) -> Self {
        let [alpha_turns, beta_turns] = period.advances(half_tau, windings).map(Float::to_f64);
        let [about_vertical, _] = period.rotations(half_tau);
        let windings: i32 = windings.iter().sum();
        let phi = about_vertical + Extended::TWO_PI.halved() * f64::from(windings).into();
        Self { period: period.time.to_f64(), alpha_turns, beta_turns, phi_radians: phi.to_f64() }
    }
}

/// Nutation period with ψ_α and ψ_β over it, and their error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Period {
    pub(crate) time: Extended,
    /// Angles ψ_α(T) and ψ_β(T), rad.
    pub(crate) psi: [Extended; 2],
    /// Relative error of the time, and error of ψ_α and ψ_β over |ψ_α| + |ψ_β| + π.
    pub(crate) rounding_error: f64,
}

impl Period {
    pub(super) fn torque_free(time: Extended) -> Self {
        let rounding_error = Self::rounding_error::<Extended>(0);
        Self { time, psi: [Extended::ZERO; 2], rounding_error }
    }

    /// Relative error by the roundings of a rate, and of a quadrature with this number of intervals.
    pub(crate) fn rounding_error<F: Float>(intervals: u32) -> f64 {
        const OPERATIONS: f64 = 64.0;
        const OPERATIONS_PER_INTERVAL: f64 = 2.0;
        (OPERATIONS + OPERATIONS_PER_INTERVAL * f64::from(intervals)) * F::OPERATION_ERROR
    }

    /// Advances of α and β in turns, whole turns included.
    pub(crate) fn advances(&self, half_tau: Extended, windings: [i32; 2]) -> [Extended; 2] {
        let [psi_alpha, psi_beta] = self.psi;
        let half_tau_angle = half_tau * self.time;
        let [alpha, beta] = windings.map(|sense| Extended::from(0.5 * f64::from(sense)));
        [
            (psi_alpha + half_tau_angle).radians_to_turns() + alpha,
            (psi_beta - half_tau_angle).radians_to_turns() + beta,
        ]
    }

    /// Rotations about the vertical, ψ_α(T) + ψ_β(T), and about the axis, ψ_α(T) - ψ_β(T) + τT, rad.
    pub(crate) fn rotations(&self, half_tau: Extended) -> [Extended; 2] {
        let [psi_alpha, psi_beta] = self.psi;
        // the terms ±τT/2 of α and β cancel
        [psi_alpha + psi_beta, psi_alpha - psi_beta + half_tau.doubled() * self.time]
    }
}

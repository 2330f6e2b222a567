//! Mean motion: the nutation period, and the change of the slow phases over one period.

mod quadrature;

use crate::cayley_klein::Brackets;
use crate::constants::{BranchPoints, Signs};
use crate::phase::Phase;
use crate::scalar::{Extended, Float, Ring};
pub(crate) use quadrature::{Integrals, Quadrature};

/// Nutation period, and advance of α and β over one period in turns, whole turns included.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PeriodAdvance<F = f64> {
    /// Period T: time from u = e₁ to e₂ and back to e₁, in the unit of time (s).
    pub period: F,
    /// Advance (arg α(t+T) - arg α(t))/2π; for e₁ = -1, where α passes through 0, that of α with a signed modulus.
    pub alpha_turns: F,
    /// Advance (arg β(t+T) - arg β(t))/2π; for e₂ = 1, where β passes through 0, that of β with a signed modulus.
    pub beta_turns: F,
    /// Advance of the tip angle φ in a period, rad: the sum of the other two advances before they are rounded.
    phi: F,
}

impl PeriodAdvance {
    /// Advance of the tip angle φ over one period, rad; where the curve passes through the centre, the angle
    /// belonging to a signed radius. It has one rounding, also where the advances of α and β cancel.
    #[must_use]
    pub fn phi_per_period(&self) -> f64 {
        self.phi
    }
}

impl<F: Float> PeriodAdvance<F> {
    pub(crate) fn to_f64(self) -> PeriodAdvance {
        PeriodAdvance {
            period: self.period.to_f64(),
            alpha_turns: self.alpha_turns.to_f64(),
            beta_turns: self.beta_turns.to_f64(),
            phi: self.phi.to_f64(),
        }
    }
}

/// Period and advances of one motion in extended precision. One quadrature computes them when the motion is launched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MeanMotion {
    /// Period, and advances of α and β over one period.
    pub(crate) advance: PeriodAdvance<Extended>,
    /// Winding numbers of the brackets of α and β around 0 over one period: 1, -1, or 0 where a bracket passes
    /// through 0.
    pub(crate) winding: [i32; 2],
    /// Angles ψ_A(T) and ψ_B(T), rad.
    pub(crate) psi: [Extended; 2],
    /// Error of the trapezoid rule, estimated from its last change: relative to the period, and relative to |ψ_A| +
    /// |ψ_B|.
    pub(crate) relative_error: f64,
    /// Relative error of one operation of the quadrature's arithmetic.
    pub(crate) operation_error: f64,
    /// Number of nodes on half a period.
    pub(crate) nodes: u32,
}

impl MeanMotion {
    /// Rotations in a period about the vertical, ψ_A(T) + ψ_B(T), and of the body about its axis,
    /// ψ_A(T) - ψ_B(T) + τT; whole turns do not count.
    pub(crate) fn turns(&self, half_tau: Extended) -> [Phase; 2] {
        let [psi_a, psi_b] = self.psi;
        let slow = half_tau.doubled() * self.advance.period;
        [psi_a + psi_b, psi_a - psi_b + slow].map(|angle| angle.in_turns().to_phase())
    }

    /// Mean motion with these integrals over one period.
    #[inline(never)]
    pub(crate) fn of(
        integrals: &Integrals,
        e: &BranchPoints<Extended>,
        signs: Signs,
        half_tau: Extended,
    ) -> Self {
        let winding = Brackets::windings(e, signs);
        let [alpha_winding, beta_winding] = winding.map(|sense| Extended::from(0.5 * f64::from(sense)));
        let slow = half_tau * integrals.period;
        let advance = PeriodAdvance {
            period: integrals.period,
            alpha_turns: (integrals.psi_alpha + slow).in_turns() + alpha_winding,
            beta_turns: (integrals.psi_beta - slow).in_turns() + beta_winding,
            // the terms ±τT/2 of α and β cancel
            phi: integrals.psi_alpha + integrals.psi_beta + Extended::TWO_PI * (alpha_winding + beta_winding),
        };
        let Integrals { psi_alpha, psi_beta, relative_error, operation_error, nodes, .. } = *integrals;
        Self { advance, winding, psi: [psi_alpha, psi_beta], relative_error, operation_error, nodes }
    }
}

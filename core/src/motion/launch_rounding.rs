//! Effect of the rounding errors of a launch on period and phases.

use crate::body::{ScaledTop, State, Top};
use crate::constants::{BranchPoints, FirstIntegrals, ReducedPoint};
use crate::scalar::{Extended, Float};
use crate::su2::dot;

/// Rounding errors of a launch; 0 for a motion from branch points, which are exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LaunchRounding {
    /// Relative error of the period, and of ψ_α and ψ_β over a period.
    pub(crate) relative: f64,
    /// Error of the rates of the slow phases, rad/s.
    pub(crate) slow_rates: f64,
}

/// Number of roundings that count for l + n, for l - n and for each coefficient of a cubic.
const ROUNDINGS_OF_A_COEFFICIENT: f64 = 32.0;

impl LaunchRounding {
    /// Errors of a launch from a state: see `core/docs/error_bound.md`.
    #[inline(never)]
    pub(crate) fn new(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint,
        e: &BranchPoints<Extended>,
        state: &State,
    ) -> Self {
        let speed = Float::sqrt(dot(state.omega(), state.omega()));
        let rounding = ROUNDINGS_OF_A_COEFFICIENT * Extended::OPERATION_ERROR;
        let scaled = ScaledTop::<f64>::new(top);
        let ScaledTop { a, c, s, p, k, .. } = scaled;
        let slow_rates = rounding * ((1.0 + (c - a).abs() / a) * speed + k.abs() / a);
        if top.is_torque_free() {
            return Self { relative: rounding, slow_rates };
        }
        let kappa = scaled.kappa();
        let ReducedPoint { u, one_minus_u, one_plus_u, axis_energy, .. } = *point;
        let [n, l_minus_n] = [integrals.n, integrals.l_minus_n].map(Float::to_f64);
        let [u, one_minus_u, one_plus_u, axis_energy] =
            [u, one_minus_u, one_plus_u, axis_energy].map(Float::to_f64);
        let e = e.to_f64();
        // terms of n = C ⟨ω, r⟩ + K, which may cancel
        let n = n.abs() + k.abs();
        // magnitude of the terms of (1 - e₂) + (1 - e₃)
        let upper_terms =
            2.0 * (axis_energy + one_minus_u + kappa * n * (l_minus_n.abs() + k.abs() * one_minus_u));
        let upper = upper_terms / e.one_minus_e1();
        // magnitude of the terms of (e₁ - u) + (e₂ - u)
        let l_minus_nu = l_minus_n.abs() + n * one_minus_u;
        let lower_terms = 2.0 * axis_energy + one_minus_u * one_plus_u + 2.0 * kappa * n * l_minus_nu;
        let lower = lower_terms / (e.e3_minus_one + one_minus_u);
        let condition = upper / e.e3_minus_e2 + lower * (1.0 / e.e3_minus_e1() + 2.0 * u.abs() * p * s / a);
        // infinite for e₂ = e₃, which has no period
        Self { relative: if condition.is_finite() { rounding * condition } else { 0.0 }, slow_rates }
    }
}

//! Errors of period and phases by the roundings of a launch.

use crate::body::{State, Top};
use crate::constants::{BranchPoints, FirstIntegrals, ReducedPoint};
use crate::scalar::{Extended, Float, Ring};
use crate::su2::dot;

/// Rounding errors of a launch; 0 for a motion from branch points, which are exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LaunchRounding {
    /// Relative error of the period, and of ψ_α and ψ_β over a period.
    pub(crate) period_error: f64,
    /// Error of the rates of λ_α and λ_β, rad/s.
    pub(crate) slow_rate_error: f64,
}

/// Number of roundings counted for l + n, for l - n and for each coefficient of a cubic.
const ROUNDINGS_OF_A_COEFFICIENT: f64 = 32.0;

impl LaunchRounding {
    /// Errors of a launch from a state, as in [the error bound](crate::error_bound).
    #[inline(never)]
    pub(crate) fn new(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint,
        e: &BranchPoints<Extended>,
        state: &State,
    ) -> Self {
        let Top { a, c, s, p, k, .. } = *top;
        let k = k.abs();
        let one = Extended::ONE;
        let rounding = ROUNDINGS_OF_A_COEFFICIENT * Extended::OPERATION_ERROR;
        let speed = dot(state.omega(), state.omega()).sqrt();
        let slow_rate_error = rounding * (((one + (c - a).abs() / a) * speed.into() + k / a).to_f64());
        if top.is_torque_free() {
            return Self { period_error: rounding, slow_rate_error };
        }
        let ReducedPoint { u, one_minus_u, one_plus_u, scaled_axis_energy, .. } = *point;
        // terms of n = C ⟨ω, r⟩ + K, which may cancel
        let n = integrals.n.abs() + k;
        let energy_per_momentum = top.energy_factor() * n;
        let l_minus_n = integrals.l_minus_n.abs();
        // magnitude of the terms of (1 - e₂) + (1 - e₃)
        let upper_terms =
            (scaled_axis_energy + one_minus_u + energy_per_momentum * (l_minus_n + k * one_minus_u))
                .doubled();
        let upper = upper_terms / e.one_minus_e1();
        // magnitude of the terms of (e₁ - u) + (e₂ - u)
        let lower_terms = (scaled_axis_energy + energy_per_momentum * (l_minus_n + n * one_minus_u))
            .doubled()
            + one_minus_u * one_plus_u;
        let lower = lower_terms / (e.e3_minus_one + one_minus_u);
        let condition =
            upper / e.e3_minus_e2 + lower * (one / e.e3_minus_e1() + (u.abs() * p * s / a).doubled());
        let period_error = rounding * condition.to_f64();
        // infinite for e₂ = e₃, which has no period
        Self { period_error: if period_error.is_finite() { period_error } else { 0.0 }, slow_rate_error }
    }
}

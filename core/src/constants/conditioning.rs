//! Rounding errors of a launch from a state in extended precision, and their effect on the law of the motion.

use crate::constants::first_integrals::ReducedPoint;
use crate::constants::{BranchPoints, FirstIntegrals};
use crate::scalar::{Extended, Float};
use crate::top::{Quantities, Top};

/// Errors of the law. They are 0 for a motion from branch points, whose numbers and differences are exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Conditioning {
    /// Relative error of the period, and of ψ_A and ψ_B over a period.
    pub(crate) relative: f64,
    /// Error of the rates of the slow phases caused by the rounding of l + n, l - n and n, rad per unit time.
    pub(crate) turning: f64,
}

/// Number of successive roundings from a state to the momenta, or to a coefficient of the cubics.
const OPERATIONS: f64 = 32.0;

impl Conditioning {
    /// Conditioning of a launch from a state with angular velocity |ω| = `speed`.
    ///
    /// The roots e₂ and e₃ are computed from their sum and product, and so are e₁ and e₂. The terms of the sum cancel,
    /// and a rounding of the sum moves the roots by the same amount. This amount, relative to e₃ - e₂ and to e₄² - 1 =
    /// A/(ps), is the relative error of T and ψ.
    pub(crate) fn of_state(
        top: &Top,
        integrals: &FirstIntegrals<Extended>,
        point: &ReducedPoint<Extended>,
        e: &BranchPoints<Extended>,
        speed: f64,
    ) -> Self {
        let rounding = OPERATIONS * Extended::ROUNDING;
        let Quantities { a, c, s, p, g, k } = Quantities::<f64>::of(top);
        let turning = rounding * ((1.0 + Float::abs(c - a) / a) * speed + Float::abs(k) / a);
        if top.is_torque_free() {
            return Self { relative: rounding, turning };
        }
        let kappa = 1.0 / (2.0 * a * p * g);
        let FirstIntegrals { n, l_minus_n, .. } = integrals.to_f64();
        let [u, one_minus_u, one_plus_u, axis_energy] =
            [point.u, point.one_minus_u, point.one_plus_u, point.axis_energy].map(Float::to_f64);
        let e = e.to_f64();
        // magnitude of the terms of the sum n
        let n = Float::abs(n) + Float::abs(k);
        // magnitude of the terms in the sum of 1 - e₂ and 1 - e₃
        let upper_terms = 2.0
            * (axis_energy + one_minus_u + kappa * n * (Float::abs(l_minus_n) + Float::abs(k) * one_minus_u));
        let upper = upper_terms / e.one_minus_e1();
        // magnitude of the terms in the sum of e₁ - u and e₂ - u
        let l_minus_nu = Float::abs(l_minus_n) + n * one_minus_u;
        let lower_terms = 2.0 * axis_energy + one_minus_u * one_plus_u + 2.0 * kappa * n * l_minus_nu;
        let lower = lower_terms / (e.e3_minus_one + one_minus_u);
        let felt = upper / e.e3_minus_e2 + lower * (1.0 / e.e3_minus_e1() + 2.0 * Float::abs(u) * p * s / a);
        Self { relative: if felt.is_finite() { rounding * felt } else { 0.0 }, turning }
    }
}

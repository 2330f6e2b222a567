//! Errors of the printed paper: each formula as printed and as corrected, with the residuals of both.
//!
//! Formulas are compared with the full equations: [`crate::full_equations::newton_euler`] at one time,
//! [`crate::full_equations::full_solver`] along a motion. All tops and motions here are generic, with numbers near 1, so that a wrong formula
//! has a residual near 1.

mod aperiodic;
pub mod contour;
mod curve;
mod e3_equals_e4;
mod instant;
mod kinematics;
mod tip;
mod weierstrass;

use crate::full_equations::full_solver::{FullSolverError, FullState, FullTop};

/// Residuals of the printed and of the corrected formula, without unit.
pub type Residuals = Result<[f64; 2], FullSolverError>;

/// Wrong formula of the paper with its correction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Erratum {
    /// Place in the paper: a label or a section.
    pub(crate) place: &'static str,
    /// Quantity that the formula is compared with; a residual is their largest difference.
    pub(crate) against: &'static str,
    /// Formula as printed.
    pub(crate) printed: &'static str,
    /// Corrected formula.
    pub(crate) corrected: &'static str,
    /// Function that computes both residuals.
    pub(crate) residuals: fn() -> Residuals,
}

/// Least residual of a wrong formula. No residual may be between this and [`RIGHT`].
pub(crate) const WRONG: f64 = 1e-2;
/// Greatest residual of a right formula.
pub(crate) const RIGHT: f64 = 1e-11;

/// All errors with a formula that can be evaluated, in the order of the paper.
#[must_use]
pub(crate) fn errata() -> Vec<Erratum> {
    let sections: [&[Erratum]; 5] =
        [&kinematics::ERRATA, &curve::ERRATA, &tip::ERRATA, &e3_equals_e4::ERRATA, &aperiodic::ERRATA];
    sections.concat()
}

/// Largest difference between two lists of numbers.
fn greatest_difference(x: &[num_complex::Complex64], y: &[num_complex::Complex64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y).norm()).fold(0.0, f64::max)
}

/// State at a turning point u, with these l + n and l - n, α > 0 and β = i|β| (the initial conditions of section 5).
fn at_turning_point(top: &FullTop, u: f64, [plus, minus]: [f64; 2]) -> FullState {
    let (l, n) = (0.5 * (plus + minus), 0.5 * (plus - minus));
    let (alpha, beta) = ((0.5 * (1.0 + u)).sqrt(), (0.5 * (1.0 - u)).sqrt());
    let state = FullState { alpha: [alpha, 0.0], beta: [0.0, beta], omega: [0.0; 3] };
    // ω in the basis (r, k), u' = 0 (section 3.1)
    let sine_squared = (1.0 - u) * (1.0 + u);
    let precession = (l - n * u) / (top.a * sine_squared);
    let [r1, r2, r3] = state.axis();
    let axial = n / top.c - precession * u;
    FullState { omega: [axial * r1, axial * r2, axial * r3 + precession], ..state }
}

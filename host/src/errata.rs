//! The slips of the printed paper: each formula as printed and as corrected, and how far either is from the truth.
//!
//! The truth is the full equations: [`crate::full_equations::newton_euler`] at one instant, [`crate::full_equations::full_solver`] along a motion. All
//! tops and motions here are generic, with numbers near 1, so a residual near 1 is a formula that is wrong.

mod aperiodic;
pub mod contour;
mod curve;
mod e3_equals_e4;
mod instant;
mod kinematics;
mod tip;
mod weierstrass;

use crate::full_equations::full_solver::{FullSolverError, FullState, FullTop};

/// How far the printed and the corrected version are from the truth, both without unit.
pub type Residuals = Result<[f64; 2], FullSolverError>;

/// One slip.
#[derive(Clone, Copy, Debug)]
pub struct Slip {
    /// Where it is: the paper's label or section.
    pub place: &'static str,
    /// What the residuals are the largest difference between: the formula and this.
    pub against: &'static str,
    /// As printed.
    pub printed: &'static str,
    /// As it should be.
    pub corrected: &'static str,
    /// Evaluates both.
    pub residuals: fn() -> Residuals,
}

/// Above this a version fails, below the other it holds; nothing may be between.
pub const WRONG: f64 = 1e-2;
/// What rounding may leave of a right formula.
pub const RIGHT: f64 = 1e-11;

/// All slips that can be evaluated, in the paper's order.
#[must_use]
pub fn slips() -> Vec<Slip> {
    let sections: [&[Slip]; 5] =
        [&kinematics::SLIPS, &curve::SLIPS, &tip::SLIPS, &e3_equals_e4::SLIPS, &aperiodic::SLIPS];
    sections.concat()
}

/// The largest difference of two lists of numbers.
fn farthest(x: &[num_complex::Complex64], y: &[num_complex::Complex64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y).norm()).fold(0.0, f64::max)
}

/// A state at a turning point u, with these l + n and l - n, α > 0 and β = i|β| (section 5's initial conditions).
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

//! What the cross-crate tests share: reference vectors, tolerances, and how errors are measured.

pub mod complex;
pub mod hostile;
pub mod tolerance;
pub mod vectors;

use toytop::{Complex, Phi};

/// The error of an orientation everywhere in this project: 2 √(|Δα|² + |Δβ|²) in rad, sensitive to the sign of Φ.
pub fn orientation_error(phi: Phi<f64>, truth: Phi<f64>) -> f64 {
    let (alpha, beta) = (phi.alpha - truth.alpha, phi.beta - truth.beta);
    2.0 * (alpha.norm_squared() + beta.norm_squared()).sqrt()
}

/// Φ of any scalar as `f64`.
pub fn widened<R: Into<f64>>(phi: Phi<R>) -> Phi<f64> {
    let widen = |z: Complex<R>| Complex::new(z.re.into(), z.im.into());
    Phi { alpha: widen(phi.alpha), beta: widen(phi.beta) }
}

/// The example of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

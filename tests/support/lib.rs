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

/// The greater of two errors. NaN, which `f64::max` would drop, is greater than any number: it must not pass a bound.
pub fn greater(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// The worst of many errors: NaN if one is, 0 if there are none.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, greater)
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

#[test]
fn an_error_that_is_no_number_is_the_worst() {
    assert_eq!(worst([0.5, 2.0, 1.0]), 2.0);
    for errors in [[f64::NAN, 1.0, 2.0], [1.0, f64::NAN, 2.0], [1.0, 2.0, f64::NAN]] {
        assert!(worst(errors).is_nan(), "{errors:?}");
    }
}

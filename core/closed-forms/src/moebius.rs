//! Möbius transformations: rotations in the plane of the stereographic projection (section 2.2 of the paper).
//!
//! `None` is the point at infinity.

use toytop::su2::Vector;
use toytop::{Complex, Orientation};

/// Image (αz + β)/(γz + δ) of z: the rotation Φ in the plane of [`stereographic`] (equation (2.5)).
pub fn moebius(phi: &Orientation<f64>, z: Option<Complex<f64>>) -> Option<Complex<f64>> {
    match z {
        Some(z) => quotient(phi.alpha * z + phi.beta, phi.gamma() * z + phi.delta()),
        None => quotient(phi.alpha, phi.gamma()),
    }
}

/// Stereographic projection from the north pole, z = (ξ + iη)/(1 - ζ).
pub fn stereographic([xi, eta, zeta]: Vector<f64>) -> Option<Complex<f64>> {
    quotient(Complex::new(xi, eta), Complex::new(1.0 - zeta, 0.0))
}

/// Point of the unit sphere over z (equation (2.4)): (2 Re z, 2 Im z, |z|² - 1)/(|z|² + 1).
pub fn sphere_point(z: Option<Complex<f64>>) -> Vector<f64> {
    let Some(z) = z else { return [0.0, 0.0, 1.0] };
    let scale = 1.0 / (z.norm_squared() + 1.0);
    [2.0 * z.re * scale, 2.0 * z.im * scale, (z.norm_squared() - 1.0) * scale]
}

/// Quotient a/b; `None` for b = 0.
fn quotient(a: Complex<f64>, b: Complex<f64>) -> Option<Complex<f64>> {
    let norm = b.norm_squared();
    (norm > 0.0).then(|| (a * b.conj()).scaled(1.0 / norm))
}

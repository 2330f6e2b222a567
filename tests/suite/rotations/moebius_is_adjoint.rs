//! Möbius transformations (section 2.2 of the paper) are compared with rotations of the sphere in stereographic projection.
//!
//! `None` is the point at infinity.

use super::exponential::{rotations, vector};
use toytop::su2::Vector;
use toytop::{Complex, Orientation};
use toytop_tests::{apart, check, greater, length, tolerance};

/// Image (αz + β)/(γz + δ) of z: the rotation Φ in the plane of [`stereographic`] (equation (2.5)).
fn moebius(phi: &Orientation<f64>, z: Option<Complex<f64>>) -> Option<Complex<f64>> {
    match z {
        Some(z) => quotient(phi.alpha * z + phi.beta, phi.gamma() * z + phi.delta()),
        None => quotient(phi.alpha, phi.gamma()),
    }
}

/// Stereographic projection from the north pole, z = (ξ + iη)/(1 - ζ).
fn stereographic([xi, eta, zeta]: Vector<f64>) -> Option<Complex<f64>> {
    quotient(Complex::new(xi, eta), Complex::new(1.0 - zeta, 0.0))
}

/// Point of the unit sphere over z (equation (2.4)): (2 Re z, 2 Im z, |z|² - 1)/(|z|² + 1).
fn sphere_point(z: Option<Complex<f64>>) -> Vector<f64> {
    let Some(z) = z else { return [0.0, 0.0, 1.0] };
    let scale = 1.0 / (z.norm_squared() + 1.0);
    [2.0 * z.re * scale, 2.0 * z.im * scale, (z.norm_squared() - 1.0) * scale]
}

/// Quotient a/b; `None` for b = 0.
fn quotient(a: Complex<f64>, b: Complex<f64>) -> Option<Complex<f64>> {
    let norm = b.norm_squared();
    (norm > 0.0).then(|| (a * b.conj()).scaled(1.0 / norm))
}

/// Equations (2.4) and (2.5): the Möbius transformation is Ad in the stereographic plane.
#[test]
fn moebius_is_the_adjoint_action() {
    let mut worst = 0.0_f64;
    for (i, phi) in rotations().into_iter().enumerate() {
        let x = vector(i as u32 + 3);
        let point = x.map(|component| component / length(x));
        let turned = sphere_point(moebius(&phi, stereographic(point)));
        worst = greater(worst, apart(turned, phi.adjoint(point)) * (1.0 - point[2]).min(1.0));
    }
    check("Moebius", worst, tolerance::MOEBIUS);
    // 0 is the south pole, the unit circle the equator, and infinity the north pole
    assert_eq!(sphere_point(Some(Complex::ZERO)), [0.0, 0.0, -1.0]);
    assert_eq!(sphere_point(Some(Complex::new(0.6, 0.8))), [0.6, 0.8, 0.0]);
    let upset = Orientation::<f64>::exp([std::f64::consts::PI, 0.0, 0.0]);
    assert_eq!(stereographic([0.0, 0.0, 1.0]), None);
    assert_eq!(sphere_point(None), [0.0, 0.0, 1.0]);
    assert!(moebius(&upset, None).unwrap().norm_squared() < 1e-30);
}

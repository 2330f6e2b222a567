//! Vectors and orientations.

use toytop::scalar::{Float, Real, Ring};
use toytop::su2::Orientation;
pub(crate) use toytop::su2::{Vector, add_scaled, cross, dot, scaled};
use toytop::{Complex, Phase};

/// Vertical unit vector k.
pub(crate) const UP: Vector<f64> = [0.0, 0.0, 1.0];
/// Unit vectors along the coordinates.
pub(crate) const UNITS: [Vector<f64>; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], UP];

/// Length of a vector.
pub(crate) fn norm<F: Float>(x: Vector<F>) -> F {
    dot(x, x).sqrt()
}

/// Unit vector along a vector; `None` where the length is 0.
pub(crate) fn unit(x: Vector<f64>) -> Option<Vector<f64>> {
    (norm(x) > 0.0).then(|| scaled(x, 1.0 / norm(x)))
}

/// Numbers in the scalar of a computation.
pub(crate) fn cast<F: Float, const N: usize>(x: [f64; N]) -> [F; N] {
    x.map(F::from_f64)
}

/// Rotation about the third axis.
pub(crate) fn about_third_axis<F: Real>(angle: Phase) -> Orientation<F> {
    Orientation { alpha: Complex::cis(Phase::from_bits(angle.to_bits() / 2)), beta: Complex::ZERO }
}

/// Map from fixed coordinates to those along the body axes of an orientation.
pub(crate) fn coordinates<F: Float>(phi: Orientation<F>) -> impl Fn(Vector<F>) -> Vector<F> {
    let axes = phi.inverse().matrix();
    move |fixed| axes.map(|axis| dot(axis, fixed))
}

/// Sum of a vector and of others, each times a factor.
pub(crate) fn add_all<F: Ring>(
    start: Vector<F>,
    terms: impl IntoIterator<Item = (Vector<F>, F)>,
) -> Vector<F> {
    terms.into_iter().fold(start, |sum, (x, f)| add_scaled(sum, x, f))
}

/// Rotation vector of an orientation of either sign, of magnitude up to π.
pub(crate) fn rotation_vector<F: Real>(phi: &Orientation<F>) -> Vector<F> {
    let [w, x, y, z] = phi.quaternion();
    let sign = if w < F::ZERO { -F::ONE } else { F::ONE };
    let sine = norm([x, y, z]);
    let angle = F::atan2(sine, sign * w).doubled();
    let scale = if sine > F::from_f64(1e-12) { sign * angle / sine } else { sign.doubled() };
    scaled([x, y, z], scale)
}

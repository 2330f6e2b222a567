//! Vectors and orientations.

use toytop::scalar::{Float, Real, Ring};
use toytop::su2::Orientation;
pub(crate) use toytop::su2::{Vector, cross, dot};

/// Vertical unit vector k.
pub(crate) const UP: Vector<f64> = [0.0, 0.0, 1.0];
/// Unit vectors along the coordinates.
pub(crate) const UNITS: [Vector<f64>; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], UP];

/// Sum x + f y.
pub(crate) fn add_scaled<F: Ring>([x1, x2, x3]: Vector<F>, [y1, y2, y3]: Vector<F>, f: F) -> Vector<F> {
    [x1 + f * y1, x2 + f * y2, x3 + f * y3]
}

/// Product f x.
pub(crate) fn scaled<F: Ring>(x: Vector<F>, f: F) -> Vector<F> {
    x.map(|component| f * component)
}

/// Length of a vector.
pub(crate) fn norm<F: Float>(x: Vector<F>) -> F {
    dot(x, x).sqrt()
}

/// Unit vector along a vector; `None` where the length is 0.
pub(crate) fn unit(x: Vector<f64>) -> Option<Vector<f64>> {
    (norm(x) > 0.0).then(|| scaled(x, 1.0 / norm(x)))
}

/// Vector in another scalar.
pub(crate) fn cast<F: Float>(x: Vector<f64>) -> Vector<F> {
    x.map(F::from_f64)
}

/// Coordinates of a vector along three axes.
pub(crate) fn along<F: Ring>(axes: &[Vector<F>; 3], x: Vector<F>) -> Vector<F> {
    axes.map(|axis| dot(axis, x))
}

/// Vector with these coordinates along three axes.
pub(crate) fn combined<F: Ring>([first, second, third]: &[Vector<F>; 3], [x, y, z]: Vector<F>) -> Vector<F> {
    add_scaled(add_scaled(scaled(*first, x), *second, y), *third, z)
}

/// Orientation whose third and first body axes are these unit vectors, of either sign.
pub(crate) fn from_axes<F: Float>(third: Vector<F>, first: Vector<F>) -> Orientation<F> {
    let ([x1, y1, z1], [x2, y2, z2], [x3, y3, z3]) = (first, cross(third, first), third);
    // four times a component of the quaternion times the others: the row with the largest component is used
    let one = F::ONE;
    let rows = [
        [one + x1 + y2 + z3, z2 - y3, x3 - z1, y1 - x2],
        [z2 - y3, one + x1 - y2 - z3, y1 + x2, x3 + z1],
        [x3 - z1, y1 + x2, one - x1 + y2 - z3, z2 + y3],
        [y1 - x2, x3 + z1, z2 + y3, one - x1 - y2 + z3],
    ];
    let size = |row: &[F; 4]| row.iter().fold(F::ZERO, |sum, x| sum + *x * *x);
    let start = [one, F::ZERO, F::ZERO, F::ZERO];
    let largest = rows.into_iter().fold(start, |best, row| if size(&row) > size(&best) { row } else { best });
    Orientation::from_quaternion(largest).normalised()
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

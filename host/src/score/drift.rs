//! Drift of l, n and h along a trajectory.
//!
//! They need the angular velocity. If a file has it, it is used without a check. From orientations alone it follows by differences of
//! the error, not of the motion: with Φ = exp(ε) Φ₀, where Φ₀ is the exact motion,
//!
//! ```text
//! ω = exp(ε) ω₀ + ε' + (1 - cos |ε|)/|ε|² ε × ε' + (|ε| - sin |ε|)/|ε|³ ε × (ε × ε')
//! ```
//!
//! and only ε' is taken from differences, over seven rows. The rows have to resolve the change of the error, which is slower than the spin.

use super::rotation_between;
use super::trajectory::Row;
use crate::motion::ephemeris::AnyEphemeris;
use crate::motion::{first_integrals, natural_scales};
use nalgebra::Vector3;
use toytop::{Motion, Orientation};

/// Greatest relative change of l, n and h from the motion's values, and how it was found.
#[derive(Default)]
pub struct Drift {
    /// Drift of l and n in units of the greatest of |l|, |n| and √(2 A p g), and of h in units of the greater of |h| and p g.
    pub integrals: Option<[f64; 3]>,
    /// Source of the angular velocity: `columns` of the file, or `differences` of the orientation's error.
    pub from: Option<&'static str>,
    /// Greatest change of the drifts if five rows are used for differences instead of seven.
    pub uncertainty: Option<f64>,
}

/// Drift along the rows. It stays unknown where the file has no angular velocity and fewer than seven rows, or errors of more than two
/// radians, which cannot be followed from row to row.
pub(crate) fn along(rows: &[Row], motion: &Motion, table: &dyn AnyEphemeris) -> Drift {
    const TOO_FAR: f64 = 2.0;
    let given: Option<Vec<_>> = rows.iter().map(|row| Some((row.orientation, row.omega?))).collect();
    if let Some(given) = given {
        let integrals = Some(greatest(motion, given.into_iter()));
        return Drift { integrals, from: Some("columns"), uncertainty: None };
    }
    let errors: Vec<_> = rows.iter().map(|row| ErrorAt::new(row, table)).collect();
    if rows.len() < 7 || errors.iter().any(|error| error.epsilon.norm() > TOO_FAR) {
        return Drift::default();
    }
    // both over the same rows
    let [seven, five] = [7, 5].map(|width: usize| {
        let windows = errors.windows(width).skip((7 - width) / 2).take(rows.len() - 6);
        let state = |window: &[ErrorAt]| {
            let middle = &window[width / 2];
            (middle.orientation, middle.omega(slope(window)).into())
        };
        greatest(motion, windows.map(state))
    });
    let uncertainty = seven.iter().zip(five).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    Drift { integrals: Some(seven), from: Some("differences"), uncertainty: Some(uncertainty) }
}

/// Greatest relative differences of l, n and h from the motion's constants.
fn greatest(motion: &Motion, states: impl Iterator<Item = (Orientation<f64>, [f64; 3])>) -> [f64; 3] {
    let constants = motion.first_integrals();
    let (exact, scales) = ([constants.l, constants.n, constants.h], natural_scales(motion));
    states.fold([0.0; 3], |most: [f64; 3], (phi, omega)| {
        let found = first_integrals(motion.top(), &phi, omega);
        std::array::from_fn(|i| most[i].max((found[i] - exact[i]).abs() / scales[i]))
    })
}

/// Error ε of the orientation of a row.
struct ErrorAt {
    t: f64,
    orientation: Orientation<f64>,
    epsilon: Vector3<f64>,
    /// Rotated angular velocity exp(ε) ω₀.
    carried: Vector3<f64>,
}

impl ErrorAt {
    fn new(row: &Row, table: &dyn AnyEphemeris) -> Self {
        let exact = table.at(row.t).sample;
        let epsilon = rotation_between(&exact.orientation(), &row.orientation);
        let carried = Orientation::exp(epsilon).adjoint(exact.omega).into();
        Self { t: row.t, orientation: row.orientation, epsilon: epsilon.into(), carried }
    }

    /// Angular velocity ω in the fixed frame for this ε'.
    fn omega(&self, slope: Vector3<f64>) -> Vector3<f64> {
        let (angle, once) = (self.epsilon.norm(), self.epsilon.cross(&slope));
        let [first, second] = if angle < 1e-2 {
            // the series' next terms are below 1e-9 of these
            [0.5 - angle * angle / 24.0, 1.0 / 6.0 - angle * angle / 120.0]
        } else {
            [(1.0 - angle.cos()) / (angle * angle), (angle - angle.sin()) / angle.powi(3)]
        };
        self.carried + slope + once * first + self.epsilon.cross(&once) * second
    }
}

/// Derivative ε' in the middle of an odd number of rows, by the polynomial through them.
fn slope(window: &[ErrorAt]) -> Vector3<f64> {
    let m = window.len() / 2;
    let t = |i: usize| window[i].t - window[m].t;
    let mut slope = Vector3::zeros();
    for j in (0..window.len()).filter(|&j| j != m) {
        // derivative at 0 of Lagrange's polynomial that is 1 at row j; that of the middle row follows, because all derivatives add up to 0
        let others = (0..window.len()).filter(|&k| k != j && k != m);
        let weight = others.map(|k| t(k) / (t(k) - t(j))).product::<f64>() / t(j);
        slope += (window[j].epsilon - window[m].epsilon) * weight;
    }
    slope
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For ε(t) = a t + b t³ on uneven rows and Φ₀ = 1, ω agrees with a difference quotient of Φ.
    #[test]
    fn the_angular_velocity_of_a_known_error() {
        let (a, b) = (Vector3::new(0.4, -0.7, 0.2), Vector3::new(-0.3, 0.1, 0.9));
        let epsilon = |t: f64| a * t + b * (t * t * t);
        let phi = |t: f64| Orientation::exp(epsilon(t).into());
        let at = |t: f64| ErrorAt { t, orientation: phi(t), epsilon: epsilon(t), carried: Vector3::zeros() };
        for middle in [1e-3, 0.8] {
            let offsets = [-0.3, -0.17, -0.1, 0.0, 0.05, 0.2, 0.31];
            let window = offsets.map(|offset| at(middle + offset));
            let found = window[3].omega(slope(&window));
            let h = 1e-4;
            let turn = rotation_between(&phi(middle - h), &phi(middle + h));
            let difference = Vector3::from(turn) / (2.0 * h);
            assert!((found - difference).norm() < 1e-7 && found.norm() > 0.5, "{found} {difference}");
        }
    }
}

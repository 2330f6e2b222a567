//! Gradients of the first integrals l, n and h, and the growth of the derivatives in a period.
//!
//! A change of the launch that keeps l, n and h does not grow. The error of the integration makes it grow a million times in a
//! million periods; the projection of the growth onto the gradients removes it.

use crate::sensitivity::coefficients::Coefficients;
use crate::sensitivity::equations::{Equations, cross_vertical};
use crate::sensitivity::state::{BodyState, COLUMNS, LAUNCH_COLUMNS, Tangent};
use crate::vector::{UP, add_all, add_scaled, cross, scaled};

impl Equations<f64> {
    /// Gradients of l/A, S and h/A with respect to θ and η.
    ///
    /// The spin S stands in for n, which does not depend on it where C = 0.
    pub(crate) fn gradients(&self, state: &BodyState<f64>) -> [Tangent<f64>; 3] {
        let Coefficients { c_over_a, p_over_a, s, g, k_over_a, .. } = self.coefficients;
        let axis = state.orientation.axis();
        let omega = state.omega();
        let q = cross_vertical(axis);
        let rate = cross(omega, axis);
        let [.., u] = axis;
        let [.., u_rate] = rate;
        let axial_excess = (c_over_a - 1.0) * state.spin;
        let lift = p_over_a * s * u_rate;
        let momentum = add_scaled(omega, axis, axial_excess + k_over_a);
        let vertical = add_scaled(UP, axis, (c_over_a - 1.0) * u);
        let energy = add_scaled(scaled(cross_vertical(rate), lift), q, p_over_a * g);
        let kinetic = add_all(omega, [(axis, axial_excess), (q, lift)]);
        [
            Tangent { theta: cross_vertical(momentum), eta: vertical },
            Tangent { theta: [0.0; 3], eta: axis },
            Tangent { theta: energy, eta: kinetic },
        ]
    }
}

/// Largest length of a rounding error in the component of a gradient orthogonal to the others, relative to the gradient.
const ROUNDING: f64 = 1e-14;

/// Growth of the columns in a period. Changes of the launch that keep l, n and h do not grow.
///
/// * `rate`: unit of η
pub(crate) fn projected(
    gradients: &[Tangent<f64>; 3],
    rate: f64,
    growth: &[Tangent<f64>; COLUMNS],
) -> [Tangent<f64>; COLUMNS] {
    let mut projected = *growth;
    projected.iter_mut().take(LAUNCH_COLUMNS).for_each(|slot| *slot = Tangent::ZERO);
    for direction in orthonormal(gradients.map(|gradient| gradient.with_eta_times(rate))) {
        // growth along the direction, in the units of the columns
        let weights = direction.with_eta_times(rate).components();
        let along = growth.iter().zip(weights).fold(Tangent::ZERO, |sum, (by, weight)| sum.plus(by, weight));
        let weights = direction.with_eta_times(1.0 / rate).components();
        projected.iter_mut().zip(weights).for_each(|(slot, weight)| *slot = slot.plus(&along, weight));
    }
    projected
}

/// Orthonormal directions by the method of Gram and Schmidt; 0 for a vector that depends on those before it.
fn orthonormal(vectors: [Tangent<f64>; 3]) -> [Tangent<f64>; 3] {
    let mut directions = [Tangent::ZERO; 3];
    for (index, vector) in vectors.iter().enumerate() {
        let mut remainder = *vector;
        // twice, because the first subtraction leaves rounding errors of what it subtracts
        for _ in 0..2 {
            for direction in &directions {
                remainder = remainder.plus(direction, -remainder.inner(direction));
            }
        }
        let length = libm::sqrt(remainder.inner(&remainder));
        if length > ROUNDING * libm::sqrt(vector.inner(vector))
            && let Some(direction) = directions.get_mut(index)
        {
            *direction = Tangent::ZERO.plus(&remainder, 1.0 / length);
        }
    }
    directions
}

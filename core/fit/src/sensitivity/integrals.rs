//! First integrals l, n and h, their gradients, and the growth of the derivatives in a period.
//!
//! A change of the launch that keeps l, n and h does not grow. The error of the integration makes it grow a million times in a
//! million periods; the projection of the growth onto the gradients removes it.

use crate::sensitivity::equations::{Equations, cross_vertical};
use crate::sensitivity::state::{AugmentedState, COLUMNS, LAUNCH_COLUMNS, Tangent};
use crate::vector::{UP, Vector, add_scaled, cross, dot, scaled};

impl Equations<f64> {
    /// Gradients of l/A, S and h/A with respect to θ and η.
    ///
    /// The spin S stands in for n, which does not depend on it where C = 0.
    pub(crate) fn gradients<const N: usize>(&self, state: &AugmentedState<f64, N>) -> [Tangent<f64>; 3] {
        let [c_over_a, p_over_a, s, g, k_over_a, ..] = self.coefficients;
        let (axis, omega, spin) = (state.axis, state.omega(), state.spin);
        let (up, q, rate) = (UP, cross_vertical(axis), cross(omega, axis));
        let ([.., u], [.., u_rate]) = (axis, rate);
        let momentum = add_scaled(omega, axis, (c_over_a - 1.0) * spin + k_over_a);
        let lift = p_over_a * s * u_rate;
        let energy = add_scaled(scaled(cross_vertical(rate), lift), q, p_over_a * g);
        [
            Tangent { theta: cross_vertical(momentum), eta: add_scaled(up, axis, (c_over_a - 1.0) * u) },
            Tangent { theta: [0.0; 3], eta: axis },
            Tangent {
                theta: energy,
                eta: add_scaled(add_scaled(omega, axis, (c_over_a - 1.0) * spin), q, lift),
            },
        ]
    }

    /// First integrals l/A, n/A and h/A.
    pub(crate) fn integrals<const N: usize>(&self, state: &AugmentedState<f64, N>) -> Vector<f64> {
        let [c_over_a, p_over_a, s, g, ..] = self.coefficients;
        let ([.., u], [.., vertical], spin) = (state.axis, state.across, state.spin);
        let [.., u_rate] = cross(state.across, state.axis);
        let n = self.n_over_a(spin);
        let square =
            dot(state.across, state.across) + c_over_a * spin * spin + p_over_a * s * u_rate * u_rate;
        [vertical + n * u, n, 0.5 * square + p_over_a * g * u]
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
    // orthonormal directions, whose η is in units of the rate; 0 for a gradient that depends on those before
    let mut directions = [Tangent::ZERO; 3];
    for (index, gradient) in gradients.iter().enumerate() {
        let gradient = Tangent { theta: gradient.theta, eta: scaled(gradient.eta, rate) };
        let mut remainder = gradient;
        // twice, because the first subtraction leaves rounding errors of what it subtracts
        for direction in [directions, directions].as_flattened() {
            remainder = remainder.plus(direction, -remainder.inner(direction));
        }
        let length = libm::sqrt(remainder.inner(&remainder));
        if length <= ROUNDING * libm::sqrt(gradient.inner(&gradient)) {
            continue;
        }
        let direction = Tangent::ZERO.plus(&remainder, 1.0 / length);
        let (up, down) = (scaled(direction.eta, rate), scaled(direction.eta, 1.0 / rate));
        let mut along = Tangent::ZERO;
        for (column, weight) in growth.iter().zip([direction.theta, up].as_flattened()) {
            along = along.plus(column, *weight);
        }
        for (slot, weight) in projected.iter_mut().zip([direction.theta, down].as_flattened()) {
            *slot = slot.plus(&along, *weight);
        }
        directions.iter_mut().skip(index).take(1).for_each(|slot| *slot = direction);
    }
    projected
}

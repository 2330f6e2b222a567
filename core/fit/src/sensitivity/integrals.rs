//! First integrals l, n and h, their gradients, and the growth of the derivatives in a period.
//!
//! A change of the launch that keeps l, n and h does not grow. The error of the integration makes it grow a million times in a
//! million periods; the projection of the growth onto the gradients removes it.

use crate::sensitivity::coefficients::n_over_a;
use crate::sensitivity::equations::{Equations, cross_vertical};
use crate::sensitivity::state::{BodyState, COLUMNS, LAUNCH_COLUMNS, Tangent};
use crate::vector::{UP, Vector, add_all, add_scaled, cross, dot, scaled};

impl Equations<f64> {
    /// Gradients of l/A, S and h/A with respect to θ and η.
    ///
    /// The spin S stands in for n, which does not depend on it where C = 0.
    pub(crate) fn gradients(&self, state: &BodyState<f64>) -> [Tangent<f64>; 3] {
        let [c_over_a, p_over_a, s, g, k_over_a, ..] = self.coefficients;
        let (axis, omega) = (state.orientation.axis(), state.omega());
        let (q, rate) = (cross_vertical(axis), cross(omega, axis));
        let ([.., u], [.., u_rate]) = (axis, rate);
        let beyond_sphere = (c_over_a - 1.0) * state.spin;
        let lift = p_over_a * s * u_rate;
        let momentum = add_scaled(omega, axis, beyond_sphere + k_over_a);
        let vertical = add_scaled(UP, axis, (c_over_a - 1.0) * u);
        let energy = add_scaled(scaled(cross_vertical(rate), lift), q, p_over_a * g);
        let kinetic = add_all(omega, [(axis, beyond_sphere), (q, lift)]);
        [
            Tangent { theta: cross_vertical(momentum), eta: vertical },
            Tangent { theta: [0.0; 3], eta: axis },
            Tangent { theta: energy, eta: kinetic },
        ]
    }

    /// First integrals l/A, n/A and h/A.
    pub(crate) fn integrals(&self, &BodyState { orientation, across, spin }: &BodyState<f64>) -> Vector<f64> {
        let [c_over_a, p_over_a, s, g, ..] = self.coefficients;
        let axis = orientation.axis();
        let ([.., u], [.., vertical], [.., u_rate]) = (axis, across, cross(across, axis));
        let n = n_over_a(&self.coefficients, spin);
        let square = dot(across, across) + c_over_a * spin * spin + p_over_a * s * u_rate * u_rate;
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

//! First integrals l, n and h, and their gradients.

use crate::sensitivity::equations::{Equations, cross_vertical};
use crate::sensitivity::flow::{Flow, Tangent};
use crate::vector::{UP, Vector, add_scaled, cross, dot, scaled};

impl Equations<f64> {
    /// Gradients of l/A, S and h/A with respect to θ and η.
    ///
    /// The spin S stands in for n, which does not depend on it where C = 0.
    pub(crate) fn gradients<const N: usize>(&self, flow: &Flow<f64, N>) -> [Tangent<f64>; 3] {
        let [inertia, moment, height, gravity, rotor, ..] = self.coefficients;
        let (axis, omega, spin) = (flow.axis, flow.omega(), flow.spin);
        let (up, lever, rate) = (UP, cross_vertical(axis), cross(omega, axis));
        let ([.., u], [.., rise]) = (axis, rate);
        let momentum = add_scaled(omega, axis, (inertia - 1.0) * spin + rotor);
        let lift = moment * height * rise;
        let energy = add_scaled(scaled(cross_vertical(rate), lift), lever, moment * gravity);
        [
            Tangent { theta: cross_vertical(momentum), eta: add_scaled(up, axis, (inertia - 1.0) * u) },
            Tangent { theta: [0.0; 3], eta: axis },
            Tangent {
                theta: energy,
                eta: add_scaled(add_scaled(omega, axis, (inertia - 1.0) * spin), lever, lift),
            },
        ]
    }

    /// First integrals l/A, n/A and h/A.
    pub(crate) fn integrals<const N: usize>(&self, flow: &Flow<f64, N>) -> Vector<f64> {
        let [inertia, moment, height, gravity, ..] = self.coefficients;
        let ([.., u], [.., vertical], spin) = (flow.axis, flow.across, flow.spin);
        let [.., rise] = cross(flow.across, flow.axis);
        let n = self.gyroscopic(spin);
        let square = dot(flow.across, flow.across) + inertia * spin * spin + moment * height * rise * rise;
        [vertical + n * u, n, 0.5 * square + moment * gravity * u]
    }
}

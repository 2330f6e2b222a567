//! Growth of the derivatives in a period, projected onto the changes of the first integrals.
//!
//! A change of the launch that keeps l, n and h does not grow. The error of the integration over a period makes it
//! grow, and a million periods would multiply this error. Therefore the growth is projected onto the changes of l, n
//! and h.

use crate::sensitivity::{COLUMNS, Equations, Flow, LAUNCH, Tangent};
use crate::su2::{bracket, dot};

/// Length, relative to a gradient, below which its component orthogonal to the other gradients is a rounding error.
const ROUNDING: f64 = 1e-14;

/// Gradients of l, n and h with respect to the six numbers of a launch, of which those of ω are in units of a frequency.
type Gradients = [[f64; LAUNCH]; 3];

/// Growth of the columns in a period, without that of changes of the launch which keep l, n and h.
pub(super) fn projected(
    equations: &Equations<f64>,
    start: &Flow<f64, COLUMNS>,
    growth: &[Tangent<f64>; COLUMNS],
) -> [Tangent<f64>; COLUMNS] {
    let rate = equations.frequency(start);
    let units = [1.0, 1.0, 1.0, rate, rate, rate];
    let mut projected = *growth;
    for slot in projected.iter_mut().take(LAUNCH) {
        *slot = Tangent::NONE;
    }
    for direction in orthonormal(gradients(equations, start, &units)) {
        let mut along = Tangent::NONE;
        for ((column, unit), share) in growth.iter().zip(units).zip(direction) {
            along = along.plus(column, share * unit);
        }
        for ((slot, unit), share) in projected.iter_mut().zip(units).zip(direction) {
            *slot = slot.plus(&along, share / unit);
        }
    }
    projected
}

/// Gradients of l/A, n/A and h/A.
fn gradients(equations: &Equations<f64>, start: &Flow<f64, COLUMNS>, units: &[f64; LAUNCH]) -> Gradients {
    let of = &equations.coefficients;
    let inertia_difference = of.inertia - 1.0;
    let (axis, spin) = (start.axis, start.spin);
    let omega = start.omega();
    let up = [0.0, 0.0, 1.0];
    let axis_rate = bracket(omega, axis);
    let momentum = super::total(omega, axis, inertia_difference * spin + of.rotor);
    let [.., rise] = axis_rate;
    let mut gradients = [[0.0; LAUNCH]; 3];
    for (column, (tangent, unit)) in start.tangents.iter().zip(units).enumerate() {
        // the change of the vertical as seen in the frame that the rotation turns
        let vertical = bracket(up, tangent.theta);
        let spin_change = dot(tangent.eta, axis);
        let momentum_change = super::total(tangent.eta, axis, inertia_difference * spin_change);
        let [.., risen] = bracket(tangent.eta, axis);
        let rise_change = risen + dot(axis_rate, vertical);
        let [.., raised] = momentum_change;
        let changes = [
            raised + dot(momentum, vertical),
            of.inertia * spin_change,
            dot(omega, tangent.eta)
                + inertia_difference * spin * spin_change
                + of.moment * of.height * rise * rise_change
                + of.moment * of.gravity * dot(axis, vertical),
        ];
        for (gradient, change) in gradients.iter_mut().zip(changes) {
            if let Some(slot) = gradient.get_mut(column) {
                *slot = change * unit;
            }
        }
    }
    gradients
}

/// Orthonormal directions that span the gradients; 0 in place of one that is linearly dependent on the others.
fn orthonormal(gradients: Gradients) -> Gradients {
    let inner = |x: &[f64; LAUNCH], y: &[f64; LAUNCH]| x.iter().zip(y).map(|(a, b)| a * b).sum::<f64>();
    let mut found = [[0.0; LAUNCH]; 3];
    for (index, gradient) in gradients.into_iter().enumerate() {
        let mut rest = gradient;
        // twice, because the first subtraction leaves rounding errors of what it subtracts
        for _ in 0..2 {
            for direction in &found {
                let along = inner(&rest, direction);
                rest.iter_mut().zip(direction).for_each(|(x, y)| *x -= along * y);
            }
        }
        let length = libm::sqrt(inner(&rest, &rest));
        if length > ROUNDING * libm::sqrt(inner(&gradient, &gradient))
            && let Some(slot) = found.get_mut(index)
        {
            *slot = rest.map(|x| x / length);
        }
    }
    found
}

//! Growth of the derivatives in a period, projected onto the changes of the first integrals.
//!
//! A change of the launch that keeps l, n and h does not grow. The error of the integration makes it grow a million times in a
//! million periods; the projection onto the gradients removes it.

use crate::sensitivity::flow::{COLUMNS, LAUNCH, Tangent};
use crate::vector::{dot, scaled};

/// Length, relative to a gradient, below which its component orthogonal to the other gradients is a rounding error.
const ROUNDING: f64 = 1e-14;

/// Growth of the columns in a period, without that of changes of the launch which keep l, n and h.
///
/// * `rate`: unit of η
pub(super) fn projected(
    gradients: &[Tangent<f64>; 3],
    rate: f64,
    growth: &[Tangent<f64>; COLUMNS],
) -> [Tangent<f64>; COLUMNS] {
    let inner = |x: &Tangent<f64>, y: &Tangent<f64>| dot(x.theta, y.theta) + dot(x.eta, y.eta);
    let mut projected = *growth;
    projected.iter_mut().take(LAUNCH).for_each(|slot| *slot = Tangent::ZERO);
    // orthonormal directions, whose η is in units of the rate; 0 for a gradient that depends on those before
    let mut directions = [Tangent::ZERO; 3];
    for (index, gradient) in gradients.iter().enumerate() {
        let gradient = Tangent { theta: gradient.theta, eta: scaled(gradient.eta, rate) };
        let mut rest = gradient;
        // twice, because the first subtraction leaves rounding errors of what it subtracts
        for direction in [directions, directions].as_flattened() {
            rest = rest.plus(direction, -inner(&rest, direction));
        }
        let length = libm::sqrt(inner(&rest, &rest));
        if length <= ROUNDING * libm::sqrt(inner(&gradient, &gradient)) {
            continue;
        }
        let direction = Tangent::ZERO.plus(&rest, 1.0 / length);
        let (up, down) = (scaled(direction.eta, rate), scaled(direction.eta, 1.0 / rate));
        let mut along = Tangent::ZERO;
        for (column, share) in growth.iter().zip([direction.theta, up].as_flattened()) {
            along = along.plus(column, *share);
        }
        for (slot, share) in projected.iter_mut().zip([direction.theta, down].as_flattened()) {
            *slot = slot.plus(&along, *share);
        }
        directions.iter_mut().skip(index).take(1).for_each(|slot| *slot = direction);
    }
    projected
}

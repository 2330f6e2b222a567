//! Errors of values that others printed, against the reference.

use super::conventions::Quantity;
use super::{Printed, Problem};
use toytop::Stepper;

/// Greatest difference of the components of a printed value from the reference. A quaternion has the sign that is nearer to the
/// reference. `None` if the catalogue has no reference for the value.
#[must_use]
pub(crate) fn off(problem: &Problem, printed: &Printed) -> Option<f64> {
    let motion = &problem.scenario.motion;
    let reference = match printed.quantity {
        Quantity::Energy => vec![motion.first_integrals().h],
        Quantity::U => vec![Stepper::<f64>::new(motion).u()],
        quantity => {
            let reference = problem.reference(&printed.t)?;
            let digits = match quantity {
                Quantity::Position => &reference.position,
                Quantity::Quaternion => &reference.quaternion,
                _ => &reference.omega_body,
            };
            digits.iter().filter_map(|text| text.parse().ok()).collect()
        }
    };
    let distance = |sign: f64| {
        let pairs = reference.iter().zip(&printed.values);
        pairs.map(|(reference, value)| (sign * value - reference).abs()).fold(0.0, f64::max)
    };
    let off = distance(1.0);
    Some(if printed.quantity == Quantity::Quaternion { off.min(distance(-1.0)) } else { off })
}

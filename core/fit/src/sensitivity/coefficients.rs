//! Coefficients of the equations of motion, and their derivatives with respect to the ratios and the losses.

use toytop::scalar::Float;
use toytop::{ParameterError, Support, Top, TopParameters};

/// Number of ratios: A/C, A/(ps), s and g.
pub(crate) const RATIOS: usize = 4;
/// Number of losses.
pub(crate) const LOSS_COUNT: usize = 3;

/// Coefficients C/A, p/A (1/m), s (m, 0 for a fixed tip), g (m/s²), K/A (rad per unit time), and the losses about the axis,
/// across it and about the vertical (per unit time); or a change of them.
pub(crate) type Coefficients<F = f64> = [F; 5 + LOSS_COUNT];

/// Coefficients of a top without losses.
pub(crate) fn coefficients(top: &Top) -> Coefficients {
    let a = top.transverse_inertia();
    let p_over_a = if top.support() == Support::Free { 0.0 } else { top.mass_moment() / a };
    let k_over_a = top.rotor_momentum() / a;
    [top.axial_inertia() / a, p_over_a, top.com_height(), top.gravity(), k_over_a, 0.0, 0.0, 0.0]
}

/// Top with these coefficients, and with the A, the rotor and the support of a given one.
pub(crate) fn with_coefficients(
    given: &Top,
    &[c_over_a, p_over_a, s, g, ..]: &Coefficients,
) -> Result<Top, ParameterError> {
    let a = given.transverse_inertia();
    let make = match given.support() {
        Support::Sliding => Top::sliding,
        Support::Fixed => Top::fixed,
        Support::Free => Top::free,
    };
    make(&TopParameters {
        transverse_inertia: a,
        axial_inertia: a * c_over_a,
        mass_moment: a * p_over_a,
        com_height: s,
        gravity: g,
        rotor_momentum: given.rotor_momentum(),
        ..TopParameters::default()
    })
}

/// Rate n/A = (C/A) S + K/A of the gyroscopic torque.
pub(crate) fn n_over_a<F: Float>(&[c_over_a, _, _, _, k_over_a, ..]: &Coefficients<F>, spin: F) -> F {
    c_over_a * spin + k_over_a
}

/// Whether there are losses, or changes of them.
pub(crate) fn are_lossy<F: Float>(&[.., x1, x2, x3]: &Coefficients<F>) -> bool {
    [x1, x2, x3] != [F::ZERO; 3]
}

/// Derivatives of the logarithms of the coefficients along a direction of those of the ratios.
pub(crate) fn log_derivatives(support: Support, [a_over_c, a_over_ps, s, g]: [f64; RATIOS]) -> Coefficients {
    let a_over_p = if support == Support::Sliding { a_over_ps + s } else { a_over_ps };
    [-a_over_c, -a_over_p, s, g, 0.0, 0.0, 0.0, 0.0]
}

/// Products of the coefficients with factors.
pub(crate) fn product(mut coefficients: Coefficients, factors: Coefficients) -> Coefficients {
    coefficients.iter_mut().zip(factors).for_each(|(x, factor)| *x *= factor);
    coefficients
}

/// Ratios A/C, A/(ps), s and g; A/p in the second place for a fixed tip.
pub(crate) fn ratios(&[c_over_a, p_over_a, s, g, ..]: &Coefficients, support: Support) -> [f64; RATIOS] {
    let ps_over_a = if support == Support::Sliding { p_over_a * s } else { p_over_a };
    [1.0 / c_over_a, 1.0 / ps_over_a, s, g]
}

/// Derivatives with respect to A/C, A/(ps), s and g; for a fixed tip, to A/C, A/p, s and g. A free body depends on A/C only.
pub(crate) fn by_ratios(
    &[c_over_a, p_over_a, s, ..]: &Coefficients,
    support: Support,
) -> [Coefficients; RATIOS] {
    let mut by = [[0.0; 5 + LOSS_COUNT]; RATIOS];
    let [[d_c_over_a, ..], [_, by_length, ..], [_, by_s, d_s, ..], [_, _, _, d_g, ..]] = &mut by;
    (*d_c_over_a, *d_g) = (-c_over_a * c_over_a, 1.0);
    match support {
        Support::Sliding => (*by_length, *by_s, *d_s) = (-p_over_a * p_over_a * s, -p_over_a / s, 1.0),
        Support::Fixed => *by_length = -p_over_a * p_over_a,
        Support::Free => {}
    }
    by
}

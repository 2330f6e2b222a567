//! Coefficients of the equations of motion, and their derivatives with respect to the ratios and the losses.

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
    let moment = if top.support() == Support::Free { 0.0 } else { top.mass_moment() / a };
    let rotor = top.rotor_momentum() / a;
    [top.axial_inertia() / a, moment, top.com_height(), top.gravity(), rotor, 0.0, 0.0, 0.0]
}

/// Top with these coefficients, and with the A, the rotor and the support of a given one; without coefficients, the given one.
pub(crate) fn with_coefficients(
    given: &Top,
    coefficients: &Option<Coefficients>,
) -> Result<Top, ParameterError> {
    let Some([inertia, moment, com_height, gravity, ..]) = *coefficients else { return Ok(*given) };
    let a = given.transverse_inertia();
    let make = match given.support() {
        Support::Sliding => Top::sliding,
        Support::Fixed => Top::fixed,
        Support::Free => Top::free,
    };
    make(&TopParameters {
        transverse_inertia: a,
        axial_inertia: a * inertia,
        mass_moment: a * moment,
        com_height,
        gravity,
        rotor_momentum: given.rotor_momentum(),
        ..TopParameters::default()
    })
}

/// Derivatives of the logarithms of the first four coefficients along a direction of those of the ratios.
pub(crate) fn exponents(support: Support, [inertia, length, height, gravity]: [f64; RATIOS]) -> [f64; 4] {
    let moment = if support == Support::Sliding { length + height } else { length };
    [-inertia, -moment, height, gravity]
}

/// Ratios A/C, A/(ps), s and g; A/p in the second place for a fixed tip.
pub(crate) fn ratios(
    &[inertia, moment, height, gravity, ..]: &Coefficients,
    support: Support,
) -> [f64; RATIOS] {
    let length = if support == Support::Sliding { moment * height } else { moment };
    [1.0 / inertia, 1.0 / length, height, gravity]
}

/// Derivatives with respect to A/C, A/(ps), s and g; for a fixed tip, to A/C, A/p, s and g. A free body depends on A/C only.
pub(crate) fn by_ratios(&[c, b, s, ..]: &Coefficients, support: Support) -> [Coefficients; RATIOS] {
    let mut by = [[0.0; 5 + LOSS_COUNT]; RATIOS];
    let [[by_inertia, ..], [_, by_length, ..], [_, by_height, height, ..], [_, _, _, by_gravity, ..]] =
        &mut by;
    (*by_inertia, *by_gravity) = (-c * c, 1.0);
    match support {
        Support::Sliding => (*by_length, *by_height, *height) = (-b * b * s, -b / s, 1.0),
        Support::Fixed => *by_length = -b * b,
        Support::Free => {}
    }
    by
}

//! Top from the numbers of a scenario.

use toytop::{ParameterError, Support, Top, TopParameters};

/// Supports of the tip by their names, in the order of their numbers on a page.
pub const SUPPORTS: [(&str, Support); 3] =
    [("sliding", Support::Sliding), ("fixed", Support::Fixed), ("free", Support::Free)];

/// Name of a support.
pub fn support_name(support: Support) -> &'static str {
    SUPPORTS[support as usize].0
}

/// Support of this name.
pub fn support_named(name: &str) -> Option<Support> {
    SUPPORTS.iter().find(|(known, _)| *known == name).map(|(_, support)| *support)
}

/// Parameters of a top: A, C, s, M, p, g and K, with 0 for a number that is not given.
pub fn top_parameters(numbers: [f64; 7]) -> TopParameters {
    let [transverse_inertia, axial_inertia, com_height, mass, mass_moment, gravity, rotor_momentum] = numbers;
    TopParameters {
        transverse_inertia,
        axial_inertia,
        com_height,
        mass,
        mass_moment,
        gravity,
        rotor_momentum,
    }
}

/// Top with this support.
///
/// # Errors
/// The errors of [`Top::sliding`], [`Top::fixed`] and [`Top::free`].
pub fn top(support: Support, parameters: &TopParameters) -> Result<Top, ParameterError> {
    match support {
        Support::Sliding => Top::sliding(parameters),
        Support::Fixed => Top::fixed(parameters),
        Support::Free => Top::free(parameters),
    }
}

//! Supports of the tip, by name.

use toytop::{ParameterError, Support, Top, TopParameters};

/// Supports by their names in a scenario, in the order of their numbers on a page.
pub const SUPPORTS: [(&str, Support); 3] =
    [("sliding", Support::Sliding), ("fixed", Support::Fixed), ("free", Support::Free)];

/// Name of a support.
pub fn name(support: Support) -> &'static str {
    SUPPORTS[support as usize].0
}

/// Support of this name.
pub fn named(name: &str) -> Option<Support> {
    SUPPORTS.iter().find(|(known, _)| *known == name).map(|(_, support)| *support)
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

//! Partial derivatives of a motion with respect to its launch, to the ratios of its top, and to losses of rotation.

// In the order of dependence.
mod coefficients;

mod flow;

mod equations;

mod integrals;

mod integration;

mod growth;

mod partials;

mod transition;

pub(crate) use coefficients::{
    Coefficients, LOSSES, RATIOS, coefficients, exponents, ratios, with_coefficients,
};
pub(crate) use equations::Equations;
pub(crate) use flow::{COLUMNS, Flow, LAUNCH, Tangent};
pub(crate) use integration::advance;
pub use partials::Partials;
pub(crate) use transition::rolled;
pub use transition::{Sensitivity, SensitivityCursor};

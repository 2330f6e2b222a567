//! Unknowns of a fit, and the motion that they determine.

// In the order of dependence.
mod estimate;

mod unknowns;

pub use estimate::{Estimate, FreeRatio};
pub(crate) use unknowns::Model;
pub use unknowns::{MOST_RATIOS, MOST_SENSORS};

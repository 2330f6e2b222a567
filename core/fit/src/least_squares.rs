//! Least squares: the triangle to which observations are reduced, and the covariance of its unknowns.

// In the order of dependence.
mod triangle;

mod covariance;

pub(crate) use covariance::Columns;
pub use covariance::Covariance;
pub use triangle::MOST_UNKNOWNS;
pub(crate) use triangle::{MOST_COMMON, Triangle, Unknowns, single};

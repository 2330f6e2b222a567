//! Many motions at once, one row each: a grid or a random sample of (e₁, e₂, e₃, A/(ps), C/A), or of the numbers of a scenario.
//!
//! A row depends on the sweep and its own number only, not on who computes it: so parts computed anywhere fit together, and
//! a part that was cut off can go on.

pub(crate) mod axis;
#[cfg(feature = "parquet")]
pub mod columnar;
mod columns;
mod heat_map;
mod launches;
mod motions;
mod part;
pub mod parts;
mod sealed;
mod space;

pub use axis::Axis;
pub use columns::{Column, DEFAULT_COLUMNS, Rows};
pub use heat_map::HeatMap;
pub use launches::Launches;
pub use motions::Motions;
pub use part::Part;
pub use space::{Place, SignChoice, Space};

//! Many motions at once, one row each: a grid or a random sample of (e₁, e₂, e₃, A/(ps), C/A), or of the numbers of a scenario.
//!
//! A row depends only on the options of the sweep and on its own number, not on the machine or the thread that computes it. Therefore
//! parts that were computed on different machines fit together, and an interrupted part can be continued.

pub mod axis;
#[cfg(feature = "parquet")]
pub mod columnar;
mod columns;
mod launches;
mod motions;
mod part;
pub mod parts;
mod sealed;
mod space;

pub use axis::Axis;
pub use columns::{Column, DEFAULT_COLUMNS, Rows};
pub use launches::Launches;
pub use motions::Motions;
pub use part::Part;
pub use space::{Place, SignChoice, Space};

//! Many motions at once, one row each: a grid or a random sample of (e₁, e₂, e₃, A/(ps), C/A), or of the numbers of a scenario.
//!
//! A row depends only on the options of the sweep and on its own number, not on the machine or the thread that computes it. Therefore
//! parts that were computed on different machines fit together, and an interrupted part can be continued.

pub(crate) mod axis;
#[cfg(feature = "parquet")]
pub(crate) mod columnar;
mod columns;
mod heat_map;
mod launches;
mod motions;
mod part;
pub(crate) mod parts;
mod sealed;
mod space;

pub(crate) use axis::Axis;
pub(crate) use columns::{Column, DEFAULT_COLUMNS, Rows};
pub(crate) use heat_map::HeatMap;
pub(crate) use launches::Launches;
pub(crate) use motions::Motions;
pub(crate) use part::Part;
pub(crate) use space::{Place, SignChoice, Space};

//! Many motions at once: a grid or a random sample of (e₁, e₂, e₃, A/(ps), C/A), one row each.
//!
//! A row depends on the sweep and its own number only, not on who computes it: so parts computed anywhere fit together, and
//! a part that was cut off can go on.

pub(crate) mod axis;
#[cfg(feature = "parquet")]
pub mod columnar;
mod columns;
mod part;
mod space;

pub use axis::Axis;
pub use columns::{Column, DEFAULT_COLUMNS, Rows};
pub use part::Part;
pub use space::{Place, SignChoice, Space};

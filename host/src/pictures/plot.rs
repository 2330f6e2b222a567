//! Picture of the curve that the tip draws.

mod curve;
#[cfg(feature = "program")]
mod picture;

pub use super::bounds::{Bound, Place};
pub use curve::{Circle, Curve};
#[cfg(feature = "program")]
pub use picture::{Form, draw};
#[cfg(feature = "program")]
pub(crate) use picture::{encode, encode_at, extent, lines, square};

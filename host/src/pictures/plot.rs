//! The curve that the tip draws, as a picture.

mod curve;
mod picture;

pub use curve::{Circle, Curve};
pub use picture::{Form, draw};
pub(crate) use picture::{encode, encode_at, extent, lines, square};

//! Table of a motion: short polynomials and three integer phases.
//!
//! Set-up (`build`) writes the table (`data`), which any tick reads (`read`). In a tick the nutation phase gives a cell, a segment and the
//! local coordinate on it; four polynomials are evaluated by Horner's rule (`evaluation`); α and β are rotated by the slow phases. Every tick has
//! the same cost, and the error grows only by the rounding of the rates.

mod evaluation;

mod data;

mod read;

mod build;

pub use build::*;
pub use data::*;
pub use evaluation::EphemerisScalar;
pub use read::*;

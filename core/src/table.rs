//! Table of a motion: short polynomials and three integer phases.
//!
//! Set-up (`build`) writes the table (`data`). A tick finds its segment (`read`) and evaluates it (`evaluation`). Every tick has the same cost but for the tip angle, and
//! the error grows only by the rounding of the rates.

mod evaluation;

mod data;

mod read;

mod build;

pub use build::*;
pub use data::*;
pub use evaluation::TableScalar;
pub use read::*;

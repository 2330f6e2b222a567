//! Table of a motion: short polynomials and three integer phases.
//!
//! Set-up (`build`) writes the table (`data`). A tick finds its segment (`read`) and evaluates it (`evaluation`). The cost does not depend
//! on the tick, except that of a tip angle. The error grows only with the rounding of the rates.

mod time;

mod evaluation;

mod data;

mod read;

mod build;

pub use build::*;
pub use data::*;
pub use evaluation::TableScalar;
pub use read::*;
pub use time::Tick;
pub(crate) use time::{Instant, Phases};

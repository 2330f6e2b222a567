//! Functions of each scalar, by one macro for tables and one for samples: their names are `toytop_f32_...`, `toytop_f64_...` and `toytop_q31_...`.

mod tables;

mod quantities;

pub use quantities::*;
pub use tables::*;

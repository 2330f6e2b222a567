//! Types and traits of other crates, each behind a feature of the crate's name.

#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "nalgebra")]
mod nalgebra;

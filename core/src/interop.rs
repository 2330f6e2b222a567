//! Other crates' types and traits, each behind a feature of its name.

#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "nalgebra")]
mod nalgebra;

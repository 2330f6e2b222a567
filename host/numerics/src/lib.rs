//! Numerical part of the program `toytop`. It is a crate of its own because it is optimised, and the rest of the program is not.
//!
//! | module | contents |
//! |---|---|
//! | [`input`] | scenario files, built-in motions, random numbers |
//! | [`motion`] | the core's stepper and ephemeris at given times |
//! | `full_equations` | integration of the full 3-D equations |
//! | [`truth`] | the paper's integrals to more than thirty digits |
//! | `measure` | errors and times of the core against the truth |
//! | [`samples`] | samples of a motion as tables of chosen columns |
//! | [`fit`] | sensors, samples and a launch fitted to them |
//! | [`score`] | output of an integrator against the exact motion |
//! | `sweep` | many motions, one row for each |
//! | [`bake`] | ephemeris as Rust, C or JSON |
//! | [`output`] | tables, CSV, JSON, files, progress |
//! | [`thread_pool`] | threads on all processor cores |
//!
//! A loop that takes time belongs here, as a function without type parameters: a generic function is compiled by the crate that calls
//! it, and the program's crate is not optimised.

pub mod bake;
mod failure;
pub mod fit;
#[cfg(feature = "program")]
pub mod full_equations;
pub mod input;
#[cfg(feature = "program")]
pub mod measure;
pub mod motion;
pub mod output;
pub mod samples;
pub mod score;
#[cfg(feature = "program")]
pub mod sweep;
pub mod thread_pool;
pub mod truth;

pub use failure::Failure;

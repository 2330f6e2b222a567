//! Library of the program `toytop`: it reads scenario files, writes tables and pictures, and compares the core with the full 3-D equations.
//!
//! | module | contents |
//! |---|---|
//! | [`input`] | scenario files, built-in motions, random numbers |
//! | [`motion`] | the core's stepper and ephemeris at given times, their samples and constants |
//! | [`truth`] | the paper's integrals to more than thirty digits; integration of the full 3-D equations |
//! | [`fit`] | sensors, samples and a launch fitted to them |
//! | [`score`] | output of an integrator against the exact motion; problems that integrators are tested with |
//! | [`pictures`] | curve of the tip, figures, page for a browser |
//! | [`output`] | tables, CSV, JSON, files, progress |
//! | [`parallel`] | threads on all processor cores |
//! | `budget` | costs of calls on emulated chips |
//! | [`cli`], `commands` | command line, one file for each command |
//!
//! All input is checked before the first byte; `state` and `sweep` then stream rows.
//! The program `toytop-lab` (the folder `lab`) uses this library for studies that check the core itself.

// Visibility is that of the modules: what a private one declares `pub` is its interface within the crate.
#![allow(unreachable_pub)]

/// Costs of calls on emulated chips: QEMU runs the firmware `cost` and logs the blocks of code that it executes. No clock is used: the same
/// ELF gives the same figures.
///
/// | module | contents |
/// |---|---|
/// | `chips` | chips with their compilers and emulators |
/// | `trace` | blocks of code that QEMU executes |
/// | `model` | cycles of an instruction, from published timings |
/// | `meter` | cost of each call: the blocks between its entry and its return |
/// | `budgets` | allowed costs, `firmware-examples/budgets.toml` |
/// | `corpus` | set-up of many launches |
#[cfg(feature = "program")]
mod budget {
    pub mod budgets;
    pub mod chips;
    pub mod corpus;
    pub mod meter;
    mod model;
    mod trace;
}
#[cfg(feature = "program")]
pub mod cli;
#[cfg(feature = "program")]
mod commands;
mod failure;
/// Measurements of a top: sensors from a file, samples as columns, simulated samples, and the launch that is fitted to them.
pub mod fit {
    pub mod columns;
    pub mod launch;
    pub mod sensors;
    pub mod simulated;
}
pub mod input;
pub mod motion;
pub mod output;
pub mod parallel;
pub mod pictures;
pub mod score;
pub mod truth;

#[cfg(feature = "program")]
pub use commands::studies::errata;
pub use failure::Failure;

#[cfg(feature = "program")]
pub use output::stdout::Report;

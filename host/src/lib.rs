//! The host side of `toytop`: scenario files in, tables and pictures out, and the core measured against the full 3-D equations.
//!
//! | module | contents |
//! |---|---|
//! | [`input`] | scenario files, built-in motions, times, random numbers |
//! | [`motion`] | the core's stepper and ephemeris at given times |
//! | [`full_equations`] | the full 3-D equations, integrated |
//! | [`truth`] | the paper's integrals to more than thirty digits |
//! | [`measure`] | errors and times of the core against the truth |
//! | [`benchmarks`] | catalogue of problems that integrators are tested with |
//! | [`budget`] | cost of a call on an emulated chip |
//! | [`errata`] | slips of the printed paper: both versions against the full equations |
//! | [`samples`] | samples of a motion as tables of chosen columns |
//! | [`fit`] | sensors, samples and a launch fitted to them |
//! | [`score`] | output of an integrator, judged by the exact motion |
//! | [`sweep`] | many motions, a row each |
//! | [`bake`] | ephemeris as Rust, C or JSON |
//! | [`pictures`] | curve of the tip, figures, page for a browser |
//! | [`output`] | tables, CSV, JSON, files, progress |
//! | [`cli`], [`commands`], [`program`] | command line, one file a command, exit codes |
//!
//! A command computes everything that can fail before the first byte is printed, so a failure leaves nothing half-written.
//! `toytop-lab` (the folder `lab`) is built on this library: the studies that check the core itself.

pub mod bake;
#[cfg(feature = "program")]
pub mod benchmarks;
#[cfg(feature = "program")]
pub mod budget;
#[cfg(feature = "program")]
pub mod cli;
#[cfg(feature = "program")]
pub mod commands;
#[cfg(feature = "program")]
pub mod errata;
mod failure;
#[cfg(feature = "program")]
pub mod fit;
#[cfg(feature = "program")]
pub mod full_equations;
pub mod input;
#[cfg(feature = "program")]
pub mod measure;
pub mod motion;
pub mod output;
pub mod pictures;
#[cfg(feature = "program")]
pub mod program;
pub mod samples;
pub mod score;
#[cfg(feature = "program")]
pub mod sweep;
pub mod thread_pool;
pub mod truth;

#[cfg(feature = "program")]
pub use commands::Report;
pub use failure::Failure;

#[cfg(feature = "program")]
use std::ffi::OsString;

/// Runs one command line (with the program's name in front).
///
/// # Errors
/// See [`Failure`].
#[cfg(feature = "program")]
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<Report, Failure> {
    match program::parse::<cli::Cli>(arguments)? {
        program::Request::Show(text) => Ok(Report { text, ..Report::default() }),
        program::Request::Run(cli) => commands::run(&cli.command),
    }
}

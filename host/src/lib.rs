//! The host side of `toytop`: scenario files in, tables out, and the core measured against the full 3-D equations.
//!
//! | module | what it does |
//! |---|---|
//! | [`cli`] | the command line, parsed |
//! | [`scenario`], [`builtin`] | a motion from a TOML file; the motions that need no file |
//! | [`times`] | the times asked for |
//! | [`propagate`] | the core's stepper taken to given times |
//! | [`truth`] | the full solver taken to the same times |
//! | [`invariants`] | l, n, h from orientation and angular velocity, without the core's formulas |
//! | [`commands`] | one file a command |
//! | [`output`], [`progress`] | table, CSV, JSON; the bar |
//!
//! A command computes everything before the first byte is printed, so a failure leaves nothing half-written.

pub mod builtin;
pub mod cli;
pub mod commands;
mod failure;
pub mod full_solver;
pub mod invariants;
pub mod output;
pub mod progress;
pub mod propagate;
pub mod scenario;
pub mod times;
pub mod truth;

pub use commands::Report;
pub use failure::Failure;

use std::ffi::OsString;

/// Runs one command line (with the program's name in front).
///
/// # Errors
/// See [`Failure`].
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<Report, Failure> {
    match cli::parse(arguments)? {
        cli::Request::Show(text) => Ok(Report { text, ..Report::default() }),
        cli::Request::Run(command) => commands::run(&command),
    }
}

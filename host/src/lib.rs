//! The host side of `toytop`: scenario files in, tables out, and the core measured against the full 3-D equations.
//!
//! | module | what it does |
//! |---|---|
//! | [`cli`] | the command line, parsed |
//! | [`scenario`], [`builtin`] | a motion from a TOML file; the motions that need no file |
//! | [`times`] | the times asked for |
//! | [`propagate`] | the core's stepper taken to given times |
//! | [`fixed_steps`] | the core's fixed-point stepper, likewise |
//! | [`ephemeris`] | the core's ephemeris, in the smallest table that fits |
//! | [`micromath`] | the rival scalar: `f32` with that crate's functions |
//! | [`bake`] | an ephemeris as Rust, C or JSON |
//! | [`tip_angle`] | the tip angle of an ephemeris, continued from t = 0 |
//! | [`newton_euler`] | the full equations with the plane's force in them, instant by instant |
//! | [`full_solver`] | the full equations, integrated with a tolerance |
//! | [`truth`] | the full solver taken to the same times |
//! | [`baseline`] | the full equations in equal steps: what one would do without the core |
//! | [`race`] | the core and its rivals over the same course |
//! | [`reality`] | what the equations allow and a top on a table does not do |
//! | [`invariants`] | l, n, h from orientation and angular velocity, without the core's formulas |
//! | [`budget`] | what a call costs on an emulated chip |
//! | [`accuracy`] | the scalars side by side, error and cost |
//! | [`sines`] | the sines of an integer phase, at every phase |
//! | [`overflow`] | fixed point on random motions in checked arithmetic |
//! | [`plot`] | the curve of the tip as a picture |
//! | [`view`] | a motion as a page for a browser |
//! | [`figures`] | the paper's figures, and charts |
//! | [`study`] | random motions, and the truth of them to thirty digits |
//! | [`longrun`] | steppers and cursors over very many ticks |
//! | [`sweep`] | many motions, a row each |
//! | [`errata`] | the slips of the printed paper: both versions, evaluated against the full equations |
//! | [`contour`] | residues on the paper's curves |
//! | [`commands`] | one file a command |
//! | [`output`], [`names`], [`progress`] | table, CSV, JSON; the words in them; the bar |
//!
//! A command computes everything before the first byte is printed, so a failure leaves nothing half-written.

pub mod accuracy;
pub mod bake;
pub mod baseline;
pub mod budget;
pub mod builtin;
pub mod cli;
pub mod commands;
pub mod contour;
mod cores;
pub mod ephemeris;
pub mod errata;
mod failure;
pub mod figures;
pub mod fixed_steps;
pub mod full_solver;
pub mod invariants;
pub mod longrun;
mod marked;
pub mod micromath;
pub mod names;
pub mod newton_euler;
pub mod output;
pub mod overflow;
pub mod plot;
pub mod progress;
pub mod propagate;
pub mod race;
pub mod reality;
pub mod scenario;
pub mod sines;
pub mod study;
pub mod sweep;
pub mod times;
pub mod tip_angle;
pub mod truth;
pub mod view;
mod whole_file;

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

//! Scenario files, motions at given times, two truths, fitted launches, scored integrators, and the forms of output: the library of the
//! Python package, and with its feature `program` of the programs `toytop` (`host/program`) and `toytop-lab`.
//!
//! A module uses only those above it.
//!
//! | module | contents |
//! |---|---|
//! | [`output`] | CSV and JSON; tables of the programs |
//! | [`input`] | scenario files, built-in motions, random numbers |
//! | [`parallel`] | threads on all processor cores |
//! | `files` | programs only: files written completely or not at all |
//! | `terminal` | programs only: command line, standard output, progress |
//! | [`truth`] | the paper's integrals to more than thirty digits; integration of the full 3-D equations |
//! | [`motion`] | motion at given times by the core or the full equations, its samples and constants |
//! | [`fit`] | sensors, samples and a launch fitted to them |
//! | [`score`] | output of an integrator against the exact motion |
//! | [`pictures`] | curve of the tip, page for a browser; drawings of the programs |

// Visibility is that of the modules: what a private one declares `pub` is its interface within the crate.
#![allow(unreachable_pub)]

mod failure;
pub mod output;

pub mod input;

pub mod parallel;

#[cfg(feature = "program")]
pub mod files;
#[cfg(feature = "program")]
pub mod terminal;

pub mod truth;

pub mod motion;

pub mod fit;

pub mod score;

pub mod pictures;

pub use failure::{Failure, Refusal, excerpt};
#[cfg(feature = "program")]
pub use terminal::stdout::Report;

//! Scenario files, motions at given times, two truths, fitted launches, scored integrators, and the forms of output: the library of the
//! programs `toytop` (`main.rs` and `commands`) and `toytop-lab`, and of the Python package.
//!
//! | module | contents |
//! |---|---|
//! | [`input`] | scenario files, built-in motions, random numbers |
//! | [`motion`] | the core's stepper and ephemeris at given times, their samples and constants |
//! | [`truth`] | the paper's integrals to more than thirty digits; integration of the full 3-D equations |
//! | [`fit`] | sensors, samples and a launch fitted to them |
//! | [`score`] | output of an integrator against the exact motion |
//! | [`pictures`] | curve of the tip, page for a browser |
//! | [`output`] | tables, CSV and JSON |
//! | [`files`] | files written completely or not at all |
//! | [`terminal`] | command line, standard output, progress |
//! | [`parallel`] | threads on all processor cores |

// Visibility is that of the modules: what a private one declares `pub` is its interface within the crate.
#![allow(unreachable_pub)]

mod failure;
pub mod files;
/// Measurements of a top: sensors from a file, samples as columns, simulated samples, and the launch that is fitted to them.
pub mod fit {
    pub mod columns;
    pub mod input;
    pub mod result;
    pub mod sensors;
    pub mod simulated;
    pub mod solve;
    pub mod summary;
}
pub mod input;
pub mod motion;
pub mod output;
pub mod parallel;
pub mod pictures;
pub mod score;
pub mod terminal;
pub mod truth;

pub use failure::Failure;
pub use terminal::stdout::Report;

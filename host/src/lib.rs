//! Library behind the program `toytop` (`host/program`) and the Python package: it reads scenarios, evaluates motions, and formats results.
//!
//! A module uses only those above it.
//!
//! | module | contents |
//! |---|---|
//! | [`output`] | CSV and JSON |
//! | [`random`] | random numbers fixed by a seed |
//! | [`input`] | scenario files, built-in motions |
//! | [`threads`] | work on all processor cores |
//! | [`mod@reference`] | the paper's integrals to more than thirty digits |
//! | [`motion`] | motion at given times by the core or the full equations, and its samples |
//! | [`sensors`] | sensors, samples and a launch fitted to them |
//! | [`integrators`] | output of an integrator against the exact motion |
//! | [`pictures`] | curve of the tip, page for a browser |

// A private module limits the visibility: what it declares `pub` is its interface within the crate.
#![allow(unreachable_pub)]

mod failure;
pub mod output;

pub mod random;

pub mod input;

pub mod threads;

pub mod reference;

pub mod motion;

pub mod sensors;

pub mod integrators;

pub mod pictures;

pub use failure::{Failure, FailureKind, excerpt};

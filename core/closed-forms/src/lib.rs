#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), no_std)]

// Modules in the order of dependence: each one uses only those above it.
pub mod elliptic;

// Parts of the solutions.
mod theta_quotient;

mod inverse;

mod orientation;

// Solutions, one for each kind of motion that has one.
mod free_body;

mod regular_precession;

mod aperiodic;

mod elliptic_nutation;

mod closed_form;

// Rates at which a given tilt is constant.
mod steady_precession;

#[cfg(doc)]
#[doc = include_str!("../docs/paper.md")]
pub mod paper {}
#[cfg(doc)]
#[doc = include_str!("../docs/errata.md")]
pub mod errata {}

pub use aperiodic::Aperiodic;
pub use closed_form::{ClosedForm, NoClosedForm};
pub use elliptic_nutation::EllipticNutation;
pub use free_body::FreeBody;
pub use regular_precession::{RegularPrecession, Stability};
pub use steady_precession::SteadyPrecession;

//! Commands on the output of integrators.

pub mod benchmark;
pub mod problems;
pub mod score;

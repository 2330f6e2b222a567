//! Commands on many motions: errors of the core and of the paper, costs on chips, computing times, sweeps.

pub mod accuracy;
pub mod bench;
pub mod budget;
pub mod compare;
pub mod errata;
pub mod sweep;

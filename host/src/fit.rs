//! Measurements of a top: sensors from a file, samples as columns, simulated samples, and the launch that is fitted to them.

pub mod columns;
pub mod launch;
pub mod sensors;
pub mod simulated;

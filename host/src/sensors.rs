//! Measurements of a top: sensors from a file, samples as columns, simulated samples, and the launch that is fitted to them.

pub mod models;

pub mod columns;
pub mod simulated;

pub mod fit;
pub mod summary;

//! Measurements of a top: sensors from a file, samples as CSV, simulated samples.

pub mod pictures;
pub mod report;
pub mod sensors;
pub mod simulated;
pub mod table;

//! Commands on samples of sensors.

pub mod fit;
pub mod simulate;

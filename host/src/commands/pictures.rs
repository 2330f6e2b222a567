//! Commands that draw a motion.

pub mod animate;
pub mod figures;
pub mod plot;
pub mod view;

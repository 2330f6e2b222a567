//! The tick: runs for ever, cannot fail.

mod pose;
mod stepper;
mod tip;

pub use pose::Pose;
pub use stepper::Stepper;
pub use tip::{Tip, TipAngle};

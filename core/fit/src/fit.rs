//! Fit of a launch to measurements.
//!
//! A pass reads the measurements and stores none of them; then the launch is corrected, and the next pass begins (`docs/partials.md`).

// In the order of dependence.
mod statistics;

mod fitted;

mod pass;

mod correction;

mod first_guess;

mod search;

mod result;

mod tracking;

mod run;

pub use fitted::{Drift, FitError, Fitted, Reason, Unobservable};
pub use pass::Fit;
pub use statistics::Statistics;
pub use tracking::Tracked;

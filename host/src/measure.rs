//! Errors and times of the core against the truth.
//!
//! | module | contents |
//! |---|---|
//! | [`accuracy`] | error and cost of each scalar |

pub mod accuracy;

//! Errors and times of the core against the truth.
//!
//! | module | contents |
//! |---|---|
//! | [`accuracy`] | error and cost of each scalar |
//! | [`benchmark`] | one motion by the core and by other methods |

pub mod accuracy;
pub mod benchmark;

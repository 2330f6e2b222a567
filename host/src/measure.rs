//! Errors and times of the core against the truth.
//!
//! | module | contents |
//! |---|---|
//! | [`accuracy`] | scalars side by side, error and cost |
//! | [`benchmark`] | one motion by the core and by other methods |

pub mod accuracy;
pub mod benchmark;

//! Errors and times of the core against the truth.
//!
//! | module | contents |
//! |---|---|
//! | [`accuracy`] | error and cost of each scalar |
//! | [`benchmark`] | one motion by the core and by other methods |
//! | [`run`] | samples of a motion by a stepper or an ephemeris |
//! | [`speed`] | computing times of states |

pub mod accuracy;
pub mod benchmark;
pub mod run;
pub mod speed;

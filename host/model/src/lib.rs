//! The motion of a top in `f64`, as the program, the page and the Python package share it.
//!
//! | module | content |
//! |---|---|
//! | [`parameters`] | supports by name, top from the numbers of a scenario |
//! | [`launch`] | launch of a motion from the numbers of a scenario |
//! | [`equations`] | full 3-D equations of motion |
//! | `start` | axis and angular momentum at t = 0 |
//! | [`motion_with_period`] | motion whose period is integrated once, and the ticks of its table |
//! | [`constants`] | constants of a motion by name, with their units and meanings |
//! | [`aperiodic`] | closed form of an aperiodic motion, which has no table |
//! | [`display_duration`] | duration that a picture of a motion shows |
//!
//! The crate has no `std` and no allocator, because the page has none.

#![no_std]

pub mod aperiodic;
pub mod constants;
pub mod display_duration;
pub mod equations;
pub mod launch;
pub mod motion_with_period;
pub mod parameters;
mod start;

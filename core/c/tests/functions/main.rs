//! Tests of the functions as a program in C calls them.

#![allow(clippy::expect_used, clippy::indexing_slicing, reason = "a test may fail so")]
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "every pointer is of a local value, or null on purpose"
)]

mod fixture;
mod launch;
mod reading;
mod set_up;

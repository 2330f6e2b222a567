//! Tests of the functions as a program in C calls them.

#![allow(clippy::expect_used, clippy::indexing_slicing, reason = "a test may fail so")]
#![allow(
    clippy::undocumented_unsafe_blocks,
    reason = "every pointer is of a local value, or null on purpose"
)]

mod interface;
mod slices;
mod top;

//! All cores, for what is done motion by motion.

use crate::Failure;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io;

/// The largest table is a megabyte and a half, and is set up on the stack.
pub(crate) const STACK: usize = 1 << 25;

/// Threads with such a stack.
///
/// # Errors
/// [`Failure::Output`]: the system has none.
pub(crate) fn all() -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build()
        .map_err(|error| Failure::Output(io::Error::other(error)))
}

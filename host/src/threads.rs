//! Threads on all processor cores.

use crate::Failure;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Stack of a thread, bytes. The set-up of the largest table needs 1.5 MB of it.
pub const STACK: usize = 1 << 25;

/// Thread pool with a thread for each processor core.
///
/// # Errors
/// [`Failure::Tool`]: the system cannot start the threads.
pub fn thread_pool() -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build()
        .map_err(|error| Failure::Tool(format!("threads: {error}")))
}

//! Threads on all processor cores, for computations that are independent for each motion.

use crate::Failure;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Stack of a thread, bytes. The set-up of the largest table needs 1.5 MB.
pub(crate) const STACK: usize = 1 << 25;

/// Thread pool with a thread for each processor core.
///
/// # Errors
/// [`Failure::Tool`]: the system cannot start the threads.
pub fn of_all_cores() -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build()
        .map_err(|error| Failure::Tool(format!("threads: {error}")))
}

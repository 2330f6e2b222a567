//! Work on all processor cores.

use crate::Failure;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Stack of a thread, bytes: far more than the 1.5 MB of the largest table's set-up, because memory that is not touched costs nothing.
pub const STACK: usize = 1 << 25;

/// Thread pool of one call, with a thread for each processor core. A pool shared by the process would not exist after a fork, and two calling
/// threads would block each other.
///
/// # Errors
/// [`Failure::tool`]: the system cannot start the threads.
pub fn pool() -> Result<ThreadPool, Failure> {
    let threads = ThreadPoolBuilder::new().stack_size(STACK).build();
    threads.map_err(|error| Failure::tool(format!("threads: {error}")))
}

/// Results of `compute` for the numbers below `count`, in their order, computed on all cores. A single one is computed in the calling thread.
///
/// # Errors
/// The failures of [`pool`].
pub fn map<T: Send>(count: usize, compute: impl Fn(usize) -> T + Send + Sync) -> Result<Vec<T>, Failure> {
    if count < 2 {
        return Ok((0..count).map(compute).collect());
    }
    Ok(pool()?.install(|| (0..count).into_par_iter().map(compute).collect()))
}

//! Threads on all processor cores, for computations that are independent for each motion.

use crate::Failure;
use crate::output::progress::Progress;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io;

/// Stack of a thread, bytes. The largest table has one and a half megabytes, and its set-up is on the stack.
pub(crate) const STACK: usize = 1 << 25;

/// Thread pool with a thread for each processor core.
///
/// # Errors
/// [`Failure::Output`]: the system cannot start the threads.
pub fn of_all_cores() -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build()
        .map_err(|error| Failure::Output(io::Error::other(error)))
}

/// Results of independent trials on all processor cores, in the order of their numbers, with a progress bar that names them `what`.
///
/// # Errors
/// As [`of_all_cores`].
pub fn map<T: Send>(
    (trials, what): (u64, &'static str),
    trial: impl Fn(u64) -> T + Sync,
) -> Result<Vec<T>, Failure> {
    let progress = Progress::new(trials, what);
    let each = |number| {
        let result = trial(number);
        progress.add(1);
        result
    };
    Ok(of_all_cores()?.install(|| (0..trials).into_par_iter().map(each).collect()))
}

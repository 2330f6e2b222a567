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

/// Sum of the results of independent trials, with a progress bar that names them `what`. `add` performs the trial of a number.
pub fn tally<T: Default + Send>(
    cores: &ThreadPool,
    (trials, what): (u64, &'static str),
    add: impl Fn(&mut T, u64) + Sync,
    merged: impl Fn(T, T) -> T + Sync,
) -> T {
    let progress = Progress::new(trials, what);
    let each = |mut tally: T, trial| {
        add(&mut tally, trial);
        progress.add(1);
        tally
    };
    cores.install(|| (0..trials).into_par_iter().fold(T::default, each).reduce(T::default, &merged))
}

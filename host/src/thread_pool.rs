//! Threads of all cores, for what is done motion by motion.

use crate::Failure;
use crate::output::progress::Progress;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io;
use std::sync::Mutex;

/// The largest table is a megabyte and a half, and is set up on the stack.
pub const STACK: usize = 1 << 25;

/// Threads with such a stack.
///
/// # Errors
/// [`Failure::Output`]: the system has none.
pub fn of_all_cores() -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build()
        .map_err(|error| Failure::Output(io::Error::other(error)))
}

/// What so many independent trials add up to, with a bar that counts them as `what`: `add` does one, by its number.
pub fn tally<T: Default + Send>(
    cores: &ThreadPool,
    (trials, what): (u64, &'static str),
    add: impl Fn(&mut T, u64) + Sync,
    merged: impl Fn(T, T) -> T + Sync,
) -> T {
    let progress = Mutex::new(Progress::new(trials, what));
    let each = |mut tally: T, trial| {
        add(&mut tally, trial);
        if let Ok(mut progress) = progress.lock() {
            progress.add(1);
        }
        tally
    };
    cores.install(|| (0..trials).into_par_iter().fold(T::default, each).reduce(T::default, &merged))
}

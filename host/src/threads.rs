//! Work on all processor cores.

use crate::Failure;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

/// Stack of a thread, bytes. The set-up of the largest table needs 1.5 MB of it.
pub const STACK: usize = 1 << 25;
/// Time between two questions whether the work goes on.
pub const INTERVAL: Duration = Duration::from_millis(50);

/// Thread pool of one call, with a thread for each processor core. A pool of the process would be lost in a forked process, and the calls of
/// two threads would wait for each other.
fn pool() -> Result<ThreadPool, Failure> {
    let threads = ThreadPoolBuilder::new().stack_size(STACK).build();
    threads.map_err(|error| Failure::tool(format!("threads: {error}")))
}

/// Calls `work` with each of the jobs on all cores.
///
/// * `keep_going`: asked every [`INTERVAL`] in the calling thread; after `false` the remaining jobs are not done
///
/// # Errors
/// [`Failure::tool`]: the system cannot start the threads.
pub fn for_each<J: Send>(
    jobs: impl ParallelIterator<Item = J>,
    work: impl Fn(J) + Send + Sync,
    mut keep_going: impl FnMut() -> bool,
) -> Result<(), Failure> {
    let stopped = AtomicBool::new(false);
    let unless_stopped = |job| {
        if !stopped.load(Relaxed) {
            work(job);
        }
    };
    pool()?.in_place_scope(|scope| {
        let (running, ended) = mpsc::channel::<()>();
        scope.spawn(|_| {
            let _running = running;
            jobs.for_each(unless_stopped);
        });
        while ended.recv_timeout(INTERVAL) == Err(RecvTimeoutError::Timeout) {
            if !keep_going() {
                stopped.store(true, Relaxed);
                break;
            }
        }
    });
    Ok(())
}

/// Results of `compute` for the numbers below `count`, in their order, computed on all cores. Results are missing after `keep_going` was
/// `false`, as in [`for_each`].
///
/// # Errors
/// The failures of [`for_each`].
pub fn map<T: Send>(
    count: usize,
    compute: impl Fn(usize) -> T + Send + Sync,
    keep_going: impl FnMut() -> bool,
) -> Result<Vec<T>, Failure> {
    let mut results: Vec<Option<T>> = (0..count).map(|_| None).collect();
    match &mut results[..] {
        [] => {}
        [only] => *only = Some(compute(0)),
        results => {
            let jobs = results.par_iter_mut().enumerate();
            for_each(jobs, |(index, result)| *result = Some(compute(index)), keep_going)?;
        }
    }
    Ok(results.into_iter().flatten().collect())
}

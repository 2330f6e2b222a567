//! Computations without the interpreter's lock, which end at Ctrl-C.

use crate::arguments::failed;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread::Builder;
use std::time::Duration;
use toytop_host::threads::{STACK, pool};

/// Time between two questions whether Ctrl-C was pressed.
const INTERVAL: Duration = Duration::from_millis(50);

/// Calls `work` with each of the jobs on all cores. A job should take less than 0.1 s.
///
/// # Errors
/// `KeyboardInterrupt`: the remaining jobs are not done.
pub(crate) fn for_each<J: Send>(
    py: Python<'_>,
    jobs: impl ParallelIterator<Item = J>,
    work: impl Fn(J) + Send + Sync,
) -> PyResult<()> {
    let pool = pool().map_err(failed)?;
    let stopped = AtomicBool::new(false);
    let unless_stopped = |job: J| {
        if !stopped.load(Relaxed) {
            work(job);
        }
    };
    let until_signal = || {
        pool.in_place_scope(|scope| {
            let (running, ended) = mpsc::channel::<()>();
            scope.spawn(|_| {
                let _running = running;
                jobs.for_each(unless_stopped);
            });
            while ended.recv_timeout(INTERVAL) == Err(RecvTimeoutError::Timeout) {
                Python::attach(|py| py.check_signals()).inspect_err(|_| stopped.store(true, Relaxed))?;
            }
            Ok(())
        })
    };
    py.detach(until_signal)
}

/// Results of `compute` for the indices below `count`, on all cores. One result should take less than 0.1 s. A single one is computed in the
/// calling thread, and Ctrl-C waits for it.
///
/// # Errors
/// `KeyboardInterrupt`.
pub(crate) fn map<T: Send>(
    py: Python<'_>,
    count: usize,
    compute: impl Fn(usize) -> T + Send + Sync,
) -> PyResult<Vec<T>> {
    if count < 2 {
        return Ok(py.detach(|| (0..count).map(compute).collect()));
    }
    let mut results: Vec<Option<T>> = (0..count).map(|_| None).collect();
    let jobs = results.par_iter_mut().enumerate();
    for_each(py, jobs, |(index, result)| *result = Some(compute(index)))?;
    Ok(results.into_iter().flatten().collect())
}

/// Result of `work`, which runs in a thread of its own. Ctrl-C returns at once, and the thread runs to its end.
///
/// # Errors
/// `KeyboardInterrupt`.
pub(crate) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = mpsc::channel();
    // if nobody waits any more, the result is dropped
    Builder::new().stack_size(STACK).spawn(move || drop(sender.send(work())))?;
    py.detach(move || {
        loop {
            match receiver.recv_timeout(INTERVAL) {
                Ok(result) => return Ok(result),
                Err(RecvTimeoutError::Timeout) => Python::attach(|py| py.check_signals())?,
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the computation has failed"));
                }
            }
        }
    })
}

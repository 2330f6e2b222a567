//! Computations run without the interpreter's lock, and end at Ctrl-C.

use crate::arguments::failed;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::Builder;
use std::time::Duration;
use toytop_host::threads::{STACK, thread_pool};

/// Time between two checks for signals.
const INTERVAL: Duration = Duration::from_millis(50);
/// Greatest number of results for which one thread is faster than several.
const MAX_SERIAL: usize = 16;

/// Calls `work` with each of the jobs on all cores. A job should take less than 0.1 s.
///
/// # Errors
/// `KeyboardInterrupt`: the remaining jobs are not done.
pub(crate) fn on_all_cores<J: Send>(
    py: Python<'_>,
    jobs: impl ParallelIterator<Item = J>,
    work: impl Fn(J) + Send + Sync,
) -> PyResult<()> {
    let cores = thread_pool().map_err(failed)?;
    let stopped = AtomicBool::new(false);
    let unless_stopped = |job| {
        if !stopped.load(Relaxed) {
            work(job);
        }
    };
    py.detach(|| {
        cores.in_place_scope(|scope| {
            let (running, ended) = mpsc::channel::<()>();
            scope.spawn(|_| {
                let _running = running;
                jobs.for_each(unless_stopped);
            });
            let waited = wait(&ended);
            stopped.store(true, Relaxed);
            waited.map(drop)
        })
    })
}

/// Results of `compute` for the indices below `count`, on all cores. One result should take less than 0.1 s.
///
/// # Errors
/// `KeyboardInterrupt`.
pub(crate) fn map<T: Send>(
    py: Python<'_>,
    count: usize,
    compute: impl Fn(usize) -> T + Send + Sync,
) -> PyResult<Vec<T>> {
    if count <= MAX_SERIAL {
        return Ok(py.detach(|| (0..count).map(compute).collect()));
    }
    let mut results: Vec<Option<T>> = (0..count).map(|_| None).collect();
    on_all_cores(py, results.par_iter_mut().enumerate(), |(index, result)| *result = Some(compute(index)))?;
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
    let result = py.detach(move || wait(&receiver))?;
    result.ok_or_else(|| PyRuntimeError::new_err("the computation has failed"))
}

/// Message of another thread; `None` once all senders are gone.
fn wait<T>(receiver: &Receiver<T>) -> PyResult<Option<T>> {
    loop {
        match receiver.recv_timeout(INTERVAL) {
            Ok(message) => return Ok(Some(message)),
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
            Err(RecvTimeoutError::Timeout) => Python::attach(|py| py.check_signals())?,
        }
    }
}

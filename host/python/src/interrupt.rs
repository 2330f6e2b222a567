//! Computations run without the interpreter's lock. Those of several jobs end at Ctrl-C.

use crate::arguments::failed;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::iter::ParallelIterator;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread::Builder;
use toytop_host::Failure;
use toytop_host::threads::{self, INTERVAL, STACK};

/// Result of `work`, which asks the function that it is called with whether to go on.
fn until_signal<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&mut (dyn FnMut() -> bool + Send)) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    let mut signals = Ok(());
    let result = py.detach(|| {
        work(&mut || {
            signals = Python::attach(|py| py.check_signals());
            signals.is_ok()
        })
    });
    signals.and_then(|()| result.map_err(failed))
}

/// Calls `work` with each of the jobs on all cores. A job should take less than 0.1 s.
///
/// # Errors
/// `KeyboardInterrupt`: the remaining jobs are not done.
pub(crate) fn for_each<J: Send>(
    py: Python<'_>,
    jobs: impl ParallelIterator<Item = J>,
    work: impl Fn(J) + Send + Sync,
) -> PyResult<()> {
    until_signal(py, |keep_going| threads::for_each(jobs, work, keep_going))
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
    until_signal(py, |keep_going| threads::map(count, compute, keep_going))
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

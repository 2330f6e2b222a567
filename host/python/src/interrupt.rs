//! Computations without the interpreter's lock, which Ctrl-C ends.

use pyo3::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, Builder};
use std::time::Duration;

/// Time between two checks for signals.
const INTERVAL: Duration = Duration::from_millis(50);
/// Stack of a thread, bytes. The set-up of the largest table needs some megabytes.
const STACK: usize = 1 << 25;
/// Results that a thread computes before it takes the next ones.
const BLOCK: usize = 16;

/// Calls `work` with each of the jobs on all cores. A job should take less than 0.1 s.
///
/// # Errors
/// `KeyboardInterrupt`: the remaining jobs are not done.
pub(crate) fn on_all_cores<J: Send>(
    py: Python<'_>,
    jobs: impl Iterator<Item = J> + Send,
    work: impl Fn(J) + Send + Sync,
) -> PyResult<()> {
    let (jobs, stopped) = (Mutex::new(jobs), AtomicBool::new(false));
    let next = || jobs.lock().ok()?.next();
    let work = || {
        while !stopped.load(Relaxed)
            && let Some(job) = next()
        {
            work(job);
        }
    };
    py.detach(|| {
        thread::scope(|scope| {
            let (running, ended) = mpsc::channel::<()>();
            for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
                let running = running.clone();
                Builder::new().stack_size(STACK).spawn_scoped(scope, || {
                    let _running = running;
                    work();
                })?;
            }
            drop(running);
            let waited = wait(&ended);
            stopped.store(true, Relaxed);
            waited.map(drop)
        })
    })
}

/// Results of `of` for the numbers below `count`, on all cores. One result should take less than 10 ms.
///
/// # Errors
/// `KeyboardInterrupt`.
pub(crate) fn map<T: Send>(
    py: Python<'_>,
    count: usize,
    of: impl Fn(usize) -> T + Send + Sync,
) -> PyResult<Vec<T>> {
    if count <= BLOCK {
        return Ok(py.detach(|| (0..count).map(of).collect()));
    }
    let mut results: Vec<Option<T>> = (0..count).map(|_| None).collect();
    on_all_cores(py, results.chunks_mut(BLOCK).enumerate(), |(block, results)| {
        for (place, result) in results.iter_mut().enumerate() {
            *result = Some(of(BLOCK * block + place));
        }
    })?;
    Ok(results.into_iter().flatten().collect())
}

/// Result of a computation that cannot be divided, in a thread of its own. Ctrl-C abandons it: the thread continues to its end.
///
/// # Errors
/// `KeyboardInterrupt`.
pub(crate) fn alone<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = mpsc::channel();
    // if nobody waits any more, the result is dropped
    Builder::new().stack_size(STACK).spawn(move || drop(sender.send(work())))?;
    let found = py.detach(move || wait(&receiver))?;
    found.ok_or_else(|| pyo3::exceptions::PyRuntimeError::new_err("the computation has failed"))
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

//! Threads on all processor cores.

use crate::Failure;
use crate::terminal::progress::Progress;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io::{self, Write};

/// Stack of a thread, bytes. The set-up of the largest table needs 1.5 MB of it.
pub const STACK: usize = 1 << 25;

/// Thread pool with a thread for each processor core.
///
/// # Errors
/// [`Failure::Tool`]: the system cannot start the threads.
pub fn thread_pool() -> Result<ThreadPool, Failure> {
    ThreadPoolBuilder::new()
        .stack_size(STACK)
        .build()
        .map_err(|error| Failure::Tool(format!("threads: {error}")))
}

/// Up to this number of rows one thread suffices.
const FEW_ROWS: u64 = 1024;
/// Rows between two writes.
const BATCH_ROWS: u64 = 1 << 15;

/// Function that appends row `n` to the bytes.
pub type Encode<'a> = dyn Fn(u64, &mut Vec<u8>) + Sync + 'a;

/// Writes this many rows in order, while all cores compute them. Memory does not grow with their number.
///
/// # Errors
/// The errors of the writer.
pub fn write_rows(count: u64, encode: &Encode<'_>, out: &mut dyn Write) -> io::Result<()> {
    let append = |mut bytes: Vec<u8>, row| {
        encode(row, &mut bytes);
        bytes
    };
    if count <= FEW_ROWS {
        out.write_all(&(0..count).fold(Vec::new(), append))?;
        return out.flush();
    }
    let cores = thread_pool().map_err(io::Error::other)?;
    let progress = Progress::new(count, "rows");
    for first in (0..count).step_by(BATCH_ROWS as usize) {
        let rows = first..count.min(first + BATCH_ROWS);
        let batch = rows.end - first;
        // in the order of the rows, whichever thread encodes them
        let parts: Vec<_> = cores.install(|| rows.into_par_iter().fold(Vec::new, append).collect());
        parts.iter().try_for_each(|bytes| out.write_all(bytes))?;
        progress.add(batch);
    }
    out.flush()
}

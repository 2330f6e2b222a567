//! Work on all processor cores, with a progress bar: rows that are written in their order, and results in theirs.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish, ProgressStyle};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::io::{self, Write};
use toytop_host::Failure;
use toytop_host::threads::thread_pool;

/// Greatest number of rows for which one thread suffices.
const FEW_ROWS: u64 = 1024;
/// Number of rows between two writes.
const BATCH_ROWS: u64 = 1 << 15;

/// Writes `count` rows. Memory does not grow with their number.
///
/// * `append`: appends the row of this number to the bytes
///
/// # Errors
/// The errors of the writer.
pub fn write_rows(
    count: u64,
    append: &(dyn Fn(u64, &mut Vec<u8>) + Sync),
    out: &mut dyn Write,
) -> io::Result<()> {
    let append = |mut bytes: Vec<u8>, row| {
        append(row, &mut bytes);
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

/// Results of `compute` for the numbers from 0 on, computed on all processor cores, in their order.
///
/// * `unit`: name of the computations in the progress bar
///
/// # Errors
/// The failures of [`thread_pool`].
pub fn compute_all<T: Send>(
    count: u64,
    unit: &'static str,
    compute: impl Fn(u64) -> T + Sync,
) -> Result<Vec<T>, Failure> {
    let progress = Progress::new(count, unit);
    let counted = |number| {
        let result = compute(number);
        progress.add(1);
        result
    };
    Ok(thread_pool()?.install(|| (0..count).into_par_iter().map(counted).collect()))
}

/// Progress of work with a known total, as a bar on stderr for work that takes more than a second; there is none where stderr is no terminal.
/// The bar disappears with it.
pub struct Progress(ProgressBar);

impl Progress {
    /// Progress of `total` units of work, named `unit`.
    pub fn new(total: u64, unit: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {human_pos}/{human_len} {msg}, {eta} left")
        {
            bar.set_style(style);
        }
        Self(bar.with_message(unit).with_finish(ProgressFinish::AndClear))
    }

    /// Adds units of finished work.
    pub fn add(&self, units: u64) {
        self.0.inc(units);
        if self.0.is_hidden() && self.0.elapsed().as_secs() >= 1 {
            self.0.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

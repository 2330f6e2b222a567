//! Parallel work with a progress bar. Rows and results keep their order.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish, ProgressStyle};
use std::io::{self, Write};
use toytop_host::Failure;
use toytop_host::threads::map;

/// Number of rows of one job.
const ROWS: u64 = 64;
/// Number of jobs between two writes.
const JOBS: u64 = 512;

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
    let progress = Progress::new(count, "rows");
    for first in (0..count).step_by((JOBS * ROWS) as usize) {
        let end = count.min(first + JOBS * ROWS);
        let job = |number: usize| {
            let first = first + ROWS * number as u64;
            let mut bytes = Vec::new();
            (first..end.min(first + ROWS)).for_each(|row| append(row, &mut bytes));
            bytes
        };
        let jobs = (end - first).div_ceil(ROWS) as usize;
        let parts = map(jobs, job).map_err(io::Error::other)?;
        parts.iter().try_for_each(|bytes| out.write_all(bytes))?;
        progress.add(end - first);
    }
    out.flush()
}

/// Results of `compute` for the numbers below `count`, in their order, computed on all processor cores.
///
/// * `unit`: name of the computations in the progress bar
///
/// # Errors
/// The failures of [`map`].
pub fn map_with_progress<T: Send>(
    count: u64,
    unit: &'static str,
    compute: impl Fn(u64) -> T + Send + Sync,
) -> Result<Vec<T>, Failure> {
    let progress = Progress::new(count, unit);
    let counted = |number| {
        let result = compute(number as u64);
        progress.add(1);
        result
    };
    map(count as usize, counted)
}

/// Progress of work with a known total. Work that takes more than a second has a bar on stderr, if that is a terminal. The bar disappears
/// when the progress is dropped.
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

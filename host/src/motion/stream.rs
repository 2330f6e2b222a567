//! Rows that are written while they are computed on all cores, so that memory does not grow with their number.

use super::thread_pool;
use crate::Failure;
use crate::output::progress::Progress;
use crate::output::stdout;
use crate::output::whole_file;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::io::{self, Write};
use std::path::Path;

/// Rows that need no other thread.
const FEW: u64 = 1024;
/// Rows between two writes.
const BATCH: u64 = 1 << 15;

/// Encoder of a row, from the row's number and the bytes to append to.
pub type Encode<'a> = dyn Fn(u64, &mut Vec<u8>) + Sync + 'a;

/// Writes this many rows in order.
///
/// # Errors
/// The errors of the writer.
pub fn rows(count: u64, encode: &Encode<'_>, out: &mut dyn Write) -> io::Result<()> {
    let append = |mut bytes: Vec<u8>, row| {
        encode(row, &mut bytes);
        bytes
    };
    if count <= FEW {
        out.write_all(&(0..count).fold(Vec::new(), append))?;
        return out.flush();
    }
    let cores = thread_pool::of_all_cores().map_err(io::Error::other)?;
    let progress = Progress::new(count, "rows");
    for first in (0..count).step_by(BATCH as usize) {
        let rows = first..count.min(first + BATCH);
        progress.add(rows.end - first);
        // in the order of the rows, whichever thread encodes them
        let parts: Vec<_> = cores.install(|| rows.into_par_iter().fold(Vec::new, append).collect());
        parts.iter().try_for_each(|bytes| out.write_all(bytes))?;
    }
    out.flush()
}

/// Output that `fill` writes: a complete file, or stdout.
///
/// # Errors
/// The failures of [`whole_file::write_by`], or of [`stdout::write`].
pub fn to(
    path: Option<&Path>,
    fill: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        Some(path) => whole_file::write_by("--output", path, |file| fill(file)),
        None => stdout::write(|out| fill(out)),
    }
}

//! Rows that are written while they are computed, block after block on all cores, so that memory does not grow with their number.

use super::thread_pool;
use crate::Failure;
use crate::output::progress::Progress;
use crate::output::stdout;
use crate::output::whole_file;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::io::{self, ErrorKind, Write};
use std::ops::Range;
use std::path::Path;

/// Rows of a block, which one thread encodes.
const BLOCK: u64 = 1024;
/// Blocks between two writes.
const BLOCKS: u64 = 32;

/// Encoder of a row, from the row's number and the bytes to append to.
pub type Encode<'a> = dyn Fn(u64, &mut Vec<u8>) + Sync + 'a;

/// Writes this many rows in order. Few rows need no thread.
///
/// # Errors
/// The errors of the writer.
pub fn rows(count: u64, encode: &Encode<'_>, out: &mut dyn Write) -> io::Result<()> {
    let block = |rows: Range<u64>| {
        let mut bytes = Vec::new();
        rows.for_each(|row| encode(row, &mut bytes));
        bytes
    };
    if count <= BLOCK {
        out.write_all(&block(0..count))?;
        return out.flush();
    }
    let cores = thread_pool::of_all_cores().map_err(io::Error::other)?;
    let progress = Progress::new(count, "rows");
    for first in (0..count).step_by((BLOCK * BLOCKS) as usize) {
        let last = count.min(first + BLOCK * BLOCKS);
        let part = |part: u64| block(first + BLOCK * part..last.min(first + BLOCK * (part + 1)));
        let parts = (last - first).div_ceil(BLOCK);
        let done: Vec<Vec<u8>> = cores.install(|| (0..parts).into_par_iter().map(part).collect());
        done.iter().try_for_each(|bytes| out.write_all(bytes))?;
        progress.add(last - first);
    }
    out.flush()
}

/// Output that `fill` writes: a complete file, or stdout. A reader that closes stdout early (`| head`) is no failure.
///
/// # Errors
/// The failures of [`whole_file::write_by`], or [`Failure::Output`] for stdout.
pub fn to(
    path: Option<&Path>,
    fill: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        Some(path) => whole_file::write_by("--output", path, |file| fill(file)),
        None => match stdout::require_open().and_then(|()| fill(&mut io::stdout())) {
            Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::Output(error)),
            _ => Ok(()),
        },
    }
}

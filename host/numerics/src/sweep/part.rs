//! File of a sweep, or of a shard of it. Rows are only appended, so that the existing rows remain valid if the program
//! is killed.

use super::Rows;
use super::sealed::unsealed;
use crate::Failure;
use crate::output::whole_file::refused;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, ErrorKind, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// File with the rows of shard `shard` of `of` (from 1): every `of`-th row of the sweep, so that shards take equal
/// times.
#[derive(Debug)]
pub struct Part {
    path: PathBuf,
    file: File,
    shard: u64,
    of: u64,
    /// Number of rows in the file.
    done: u64,
    /// Number of rows of the complete file.
    len: u64,
}

impl Part {
    /// Creates a file, or with `resume` continues one: an incomplete last line is removed, every row must match its
    /// checksum, and the last one must equal the row that the sweep computes. The file is locked until the part is
    /// dropped.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file exists and is not to be resumed, is no regular file, is locked by another process, belongs to
    /// another sweep, or cannot be written.
    pub fn open(path: &Path, rows: &Rows, [shard, of]: [u64; 2], resume: bool) -> Result<Self, Failure> {
        let wrong = |reason: &str| Failure::Input(format!("--output: {}: {reason}", path.display()));
        let of_system = |error: std::io::Error| refused("--output", path, error);
        must_be_regular(path)?;
        let len = Self::rows_of(rows, [shard, of]);
        let mut options = OpenOptions::new();
        options.read(true).write(true);
        if resume {
            options.create(true).truncate(false);
        } else {
            options.create_new(true);
        }
        let file = options.open(path).map_err(|error| match error.kind() {
            std::io::ErrorKind::AlreadyExists => wrong("exists; --resume continues it"),
            _ => of_system(error),
        })?;
        lock(&file).map_err(|error| match error {
            TryLockError::WouldBlock => wrong("another toytop is writing it; nothing was changed"),
            TryLockError::Error(error) => of_system(error),
        })?;
        if !path.exists() {
            return Err(wrong("another toytop has just finished it; nothing was changed"));
        }
        let Whole { lines, bytes, first, last, rest, broken } = whole_lines(&file).map_err(of_system)?;
        let header = rows.header();
        let done = lines.saturating_sub(1);
        let mut part =
            Self { path: path.to_owned(), file: file.try_clone().map_err(of_system)?, shard, of, done, len };
        let same_header =
            if lines > 0 { first == header.as_bytes() } else { header.as_bytes().starts_with(&rest) };
        if let Some(line) = broken.filter(|_| same_header) {
            return Err(wrong(&format!(
                "line {line}: does not match its checksum, because it was changed; the file is left as it is"
            )));
        }
        let same_row = done == 0 || (done <= len && last == rows.row(part.index(done - 1)).as_bytes());
        if !same_header || !same_row {
            return Err(wrong("is of another sweep, shard or version; nothing was changed"));
        }
        file.set_len(bytes).map_err(of_system)?;
        part.file.seek(SeekFrom::Start(bytes)).map_err(of_system)?;
        if lines == 0 {
            part.file.write_all(header.as_bytes()).map_err(of_system)?;
        }
        Ok(part)
    }

    /// Number of rows of a shard.
    #[must_use]
    pub fn rows_of(rows: &Rows, [shard, of]: [u64; 2]) -> u64 {
        (rows.motions.count() + of - shard) / of
    }

    /// Number, in the whole sweep, of a row of a shard.
    #[must_use]
    pub fn index_in(row: u64, [shard, of]: [u64; 2]) -> u64 {
        row * of + shard - 1
    }

    /// Number, in the whole sweep, of a row of this part.
    #[must_use]
    pub fn index(&self, row: u64) -> u64 {
        Self::index_in(row, [self.shard, self.of])
    }

    /// Number of rows in the file.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done
    }

    /// Number of rows of the complete file.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.len
    }

    /// Appends a block of rows. The operating system has them when the function returns.
    ///
    /// # Errors
    /// The block cannot be written; the existing rows remain valid.
    pub fn append(&mut self, block: &str, rows: u64) -> Result<(), Failure> {
        let written = self.file.write_all(block.as_bytes());
        written.map_err(|error| refused("--output", &self.path, error))?;
        self.done += rows;
        Ok(())
    }
}

/// Refuses the path of a pipe, a device or a folder, from which a read could wait without end.
///
/// # Errors
/// [`Failure::Input`].
pub(super) fn must_be_regular(path: &Path) -> Result<(), Failure> {
    if std::fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        let path = path.display();
        return Err(Failure::Input(format!("--output: {path}: must be a regular file, or - for stdout")));
    }
    Ok(())
}

/// Locks a file for this process. A file system without locks leaves it unlocked.
fn lock(file: &File) -> Result<(), TryLockError> {
    match file.try_lock() {
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => Ok(()),
        other => other,
    }
}

/// Complete lines of a file.
#[derive(Default)]
struct Whole {
    lines: u64,
    bytes: u64,
    first: Vec<u8>,
    last: Vec<u8>,
    /// Bytes after the last line break.
    rest: Vec<u8>,
    /// Number of the first row that does not match its checksum.
    broken: Option<u64>,
}

fn whole_lines(file: &File) -> std::io::Result<Whole> {
    let mut whole = Whole::default();
    let mut reader = BufReader::new(file);
    let mut line = Vec::new();
    while reader.read_until(b'\n', &mut line)? > 0 && line.ends_with(b"\n") {
        whole.lines += 1;
        whole.bytes += line.len() as u64;
        if whole.lines == 1 {
            whole.first.clone_from(&line);
        } else if whole.broken.is_none() && unsealed(&line[..line.len() - 1]).is_none() {
            whole.broken = Some(whole.lines);
        }
        std::mem::swap(&mut whole.last, &mut line);
        line.clear();
    }
    whole.rest = line;
    Ok(whole)
}

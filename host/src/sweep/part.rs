//! The file of a sweep, or of a shard of it: only ever appended to, so that what is there stays good whatever happens.

use super::Rows;
use crate::Failure;
use crate::whole_file::refused;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The rows of shard `shard` of `of` (from 1): every `of`-th row of the sweep, so that shards take equally long.
#[derive(Debug)]
pub struct Part {
    path: PathBuf,
    file: File,
    shard: u64,
    of: u64,
    /// Rows there already.
    done: u64,
    /// Rows there will be.
    len: u64,
}

impl Part {
    /// Begins a file, or goes on with one (`resume`): a line that was cut off goes, and the last whole row has to be what the
    /// sweep gives for it.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file exists and is not to be resumed, belongs to another sweep, or cannot be written.
    pub fn open(path: &Path, rows: &Rows, [shard, of]: [u64; 2], resume: bool) -> Result<Self, Failure> {
        let wrong = |reason: &str| Failure::Input(format!("--output: {}: {reason}", path.display()));
        let of_system = |error: std::io::Error| refused("--output", path, error);
        let total = rows.space.len();
        let len = (total + of - shard) / of;
        let mut options = OpenOptions::new();
        options.read(true).write(true);
        if resume {
            options.create(true).truncate(false);
        } else {
            options.create_new(true);
        }
        let file = options.open(path).map_err(|error| match error.kind() {
            std::io::ErrorKind::AlreadyExists => wrong("exists; --resume goes on with it"),
            _ => of_system(error),
        })?;
        let Whole { lines, bytes, first, last, rest } = whole_lines(&file).map_err(of_system)?;
        let header = rows.header();
        let done = lines.saturating_sub(1);
        let mut part =
            Self { path: path.to_owned(), file: file.try_clone().map_err(of_system)?, shard, of, done, len };
        let same_header = if lines > 0 { first == header } else { header.starts_with(&rest) };
        let same_row = done == 0 || (done <= len && last == rows.row(part.index(done - 1)));
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

    /// The number, in the whole sweep, of a row of this part.
    #[must_use]
    pub fn index(&self, row: u64) -> u64 {
        row * self.of + self.shard - 1
    }

    /// Rows there already.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done
    }

    /// Rows there will be.
    #[must_use]
    pub fn len(&self) -> u64 {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Appends a block of rows: with the system when this returns.
    ///
    /// # Errors
    /// It cannot be written; what was there before stays good.
    pub fn append(&mut self, block: &str, rows: u64) -> Result<(), Failure> {
        let written = self.file.write_all(block.as_bytes());
        written.map_err(|error| refused("--output", &self.path, error))?;
        self.done += rows;
        Ok(())
    }
}

/// What of a file ends with a line break.
#[derive(Default)]
struct Whole {
    lines: u64,
    bytes: u64,
    first: String,
    last: String,
    /// What follows.
    rest: String,
}

fn whole_lines(file: &File) -> std::io::Result<Whole> {
    let mut whole = Whole::default();
    let mut reader = BufReader::new(file);
    let mut line = String::new();
    while reader.read_line(&mut line)? > 0 && line.ends_with('\n') {
        whole.lines += 1;
        whole.bytes += line.len() as u64;
        if whole.lines == 1 {
            whole.first.clone_from(&line);
        }
        std::mem::swap(&mut whole.last, &mut line);
        line.clear();
    }
    whole.rest = line;
    Ok(whole)
}

//! Existing files of sweeps: a check that their rows are unchanged and complete, and the join of shards in one file.

use super::columns::KEYS;
use super::sealed::{CHECKSUM, unsealed};
use crate::Failure;
use crate::output::whole_file::write_by;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Split, Write};
use std::path::{Path, PathBuf};

/// File whose rows are read one after another, each compared with its checksum.
struct Part {
    name: String,
    lines: Split<BufReader<File>>,
    header: String,
    /// Number of lines that were read.
    number: u64,
}

/// Row of a file.
struct Row {
    /// Index in the whole sweep, from 0.
    index: u64,
    /// Number of rows of the whole sweep.
    motions: u64,
    /// Version and seed.
    made_by: String,
    /// Line without its line break.
    line: Vec<u8>,
}

impl Part {
    fn open(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let open = File::open(path).and_then(|file| Ok((file.metadata()?.is_file(), file)));
        let (regular, file) = open.map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        if !regular {
            return Err(Failure::Input(format!("{name}: must be a regular file")));
        }
        let mut part =
            Self { name, lines: BufReader::new(file).split(b'\n'), header: String::new(), number: 0 };
        let header = part.line()?.and_then(|header| String::from_utf8(header).ok()).unwrap_or_default();
        if !header.starts_with(&format!("{KEYS},")) || !header.ends_with(&format!(",{CHECKSUM}")) {
            return Err(part.refusal("is not the header of a sweep of this version"));
        }
        part.header = header;
        Ok(part)
    }

    fn refusal(&self, reason: &str) -> Failure {
        Failure::Input(format!("{}: line {}: {reason}", self.name, self.number))
    }

    fn line(&mut self) -> Result<Option<Vec<u8>>, Failure> {
        self.number += 1;
        let line = self.lines.next().transpose();
        line.map_err(|error| Failure::Input(format!("{}: {error}", self.name)))
    }

    fn row(&mut self) -> Result<Option<Row>, Failure> {
        let Some(line) = self.line()? else { return Ok(None) };
        let row = unsealed(&line).and_then(|row| {
            let mut fields = row.splitn(5, ',');
            let [index, motions, version, seed] =
                [fields.next()?, fields.next()?, fields.next()?, fields.next()?];
            let made_by = format!("{version}, seed {seed}");
            Some((index.parse().ok()?, motions.parse().ok()?, made_by))
        });
        match row {
            Some((index, motions, made_by)) if index < motions => {
                Ok(Some(Row { index, motions, made_by, line }))
            }
            _ => Err(self.refusal("does not match its checksum: cut off, or changed after it was written")),
        }
    }
}

/// Numbers of rows of a file and of its sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Found {
    /// Rows of the file.
    pub rows: u64,
    /// Rows of the whole sweep.
    pub motions: u64,
}

/// Compares every row of a file with its checksum, and checks that no row is missing: the file must have all rows of a
/// sweep, or every N-th one up to its end.
///
/// # Errors
/// [`Failure::Input`]: the reason, with the line.
pub fn verify(path: &Path) -> Result<Found, Failure> {
    let mut part = Part::open(path)?;
    let (mut first, mut step, mut rows) = (None, None, 0);
    while let Some(Row { index, motions, made_by, .. }) = part.row()? {
        rows += 1;
        let (begin, of, maker) = first.get_or_insert_with(|| (index, motions, made_by.clone()));
        if rows == 2 {
            step = index.checked_sub(*begin).filter(|step| *step > 0);
        }
        let expected = *begin + (rows - 1) * step.unwrap_or(0);
        if (motions, index, &made_by) != (*of, expected, maker) {
            return Err(part.refusal(
                "does not follow the row before it: rows are missing, repeated or of another sweep",
            ));
        }
    }
    let (begin, motions, _) = first.ok_or_else(|| part.refusal("missing: there is no row"))?;
    // a single row determines no step: it may be the only row of its shard
    let complete = step.is_none_or(|step| begin + rows * step >= motions);
    if complete {
        Ok(Found { rows, motions })
    } else {
        Err(part.refusal("missing: the sweep has more rows; --resume continues it"))
    }
}

/// Joins files, given in any order, that together have every row of a sweep once. The rows are written in the order of
/// the sweep, each compared with its checksum.
///
/// # Errors
/// [`Failure::Input`]: the reason; then nothing is written.
pub fn join(paths: &[PathBuf], output: &Path) -> Result<Found, Failure> {
    let mut parts = paths.iter().map(|path| Part::open(path)).collect::<Result<Vec<_>, _>>()?;
    let header = parts.first().map(|part| part.header.clone()).unwrap_or_default();
    let mut failure = None;
    let mut found = Found { rows: 0, motions: 0 };
    let written = write_by("--output", output, |file| {
        let mut file = BufWriter::new(file);
        let merged = merge(&mut parts, &header, |line| {
            file.write_all(line).and_then(|()| file.write_all(b"\n")).map_err(Failure::Output)
        });
        match merged {
            Ok(merged) => found = merged,
            Err(Failure::Output(error)) => return Err(error),
            Err(other) => {
                failure = Some(other);
                return Err(io::ErrorKind::InvalidData.into());
            }
        }
        file.flush()
    });
    match failure {
        Some(failure) => Err(failure),
        None => written.map(|()| found),
    }
}

fn merge(
    parts: &mut [Part],
    header: &str,
    mut put: impl FnMut(&[u8]) -> Result<(), Failure>,
) -> Result<Found, Failure> {
    put(header.as_bytes())?;
    // the next row of each file, by its index
    let mut next: BTreeMap<u64, (usize, Row)> = BTreeMap::new();
    let advance = |next: &mut BTreeMap<u64, (usize, Row)>, parts: &mut [Part], i: usize| {
        let Some(row) = parts[i].row()? else { return Ok(()) };
        match next.insert(row.index, (i, row)) {
            Some((_, row)) => Err(parts[i].refusal(&format!("row {} is in another file, too", row.index))),
            None => Ok(()),
        }
    };
    for i in 0..parts.len() {
        if parts[i].header != header {
            return Err(parts[i].refusal("differs from the header of the first file"));
        }
        advance(&mut next, parts, i)?;
    }
    let mut sweep: Option<(u64, String)> = None;
    let mut rows = 0;
    while let Some((index, (i, row))) = next.pop_first() {
        let (motions, made_by) = sweep.get_or_insert_with(|| (row.motions, row.made_by.clone()));
        if (*motions, &*made_by) != (row.motions, &row.made_by) {
            return Err(parts[i].refusal("is of another sweep than the first row"));
        }
        if index != rows {
            return Err(missing(rows.min(index)));
        }
        put(&row.line)?;
        rows += 1;
        advance(&mut next, parts, i)?;
    }
    match sweep {
        Some((motions, _)) if rows == motions => Ok(Found { rows, motions }),
        _ => Err(missing(rows)),
    }
}

fn missing(row: u64) -> Failure {
    Failure::Input(format!("row {row} is in no file, or twice in one: is a shard absent or incomplete?"))
}

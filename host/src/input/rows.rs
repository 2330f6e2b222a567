//! CSV files: bounded lines, names of columns without their units, errors with the line.

use std::io::{self, ErrorKind, Read};

/// Greatest length of a line, bytes.
const LONGEST_LINE: usize = 1 << 20;

/// Reader that refuses a line of more than a mebibyte, for which a reader of CSV would need unbounded memory.
pub struct BoundedLines<R> {
    inner: R,
    length: usize,
}

impl<R> BoundedLines<R> {
    pub fn new(inner: R) -> Self {
        Self { inner, length: 0 }
    }
}

impl<R: Read> Read for BoundedLines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        for byte in &buffer[..count] {
            self.length = if *byte == b'\n' { 0 } else { self.length + 1 };
            if self.length > LONGEST_LINE {
                return Err(io::Error::new(ErrorKind::InvalidData, "must have lines of at most 1 MiB"));
            }
        }
        Ok(count)
    }
}

/// Names of columns without the units that follow in brackets.
///
/// # Errors
/// Column whose unit is another one than the program's.
pub fn names(header: &csv::StringRecord) -> Result<Vec<String>, String> {
    let name = |field: &str| {
        let (name, unit) = field.split_once(['[', '(']).unwrap_or((field, ""));
        let (name, unit) = (name.trim(), unit.trim_end_matches([']', ')', ' ']).trim());
        let allowed = units(name);
        if !unit.is_empty() && !allowed.is_empty() && !allowed.contains(&unit) {
            return Err(format!("{name}: must be in {}, not {unit}", allowed[0]));
        }
        Ok(name.to_owned())
    };
    header.iter().map(name).collect()
}

/// Spellings of the unit of a column; none where it is a pure number or unknown.
fn units(name: &str) -> &'static [&'static str] {
    match name.split('_').next().unwrap_or_default() {
        "t" => &["s"],
        "gyro" | "omega" | "wx" | "wy" | "wz" => &["rad/s"],
        "accel" => &["m/s^2", "m/s²", "m/s2"],
        "tip" => &["m"],
        "mark" => &["rad"],
        _ => &[],
    }
}

/// Text of an error of the reader of CSV, with the line if a row has another number of fields than the header.
pub fn unread(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            format!("line {line}: must have {expected_len} fields, as the header; has {len}")
        }
        _ => error.to_string(),
    }
}

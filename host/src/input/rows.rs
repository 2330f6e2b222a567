//! CSV files: names of columns without their units, errors with the line.

use crate::Failure;
use crate::output::whole_file;
use std::path::Path;

/// Text of a file; `name` is its name in messages.
///
/// # Errors
/// [`Failure::Input`]: it cannot be read, is larger than 1 GiB, or is not UTF-8.
pub fn read(name: &str, path: &Path) -> Result<String, Failure> {
    whole_file::read(name, path, 1024)
}

/// Reader of a text with a header, in which # begins a comment.
pub fn reader(text: &str) -> csv::Reader<&[u8]> {
    csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes())
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
pub fn csv_error(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            format!("line {line}: must have {expected_len} fields, as the header; has {len}")
        }
        _ => error.to_string(),
    }
}

//! CSV files: columns by name, and rows with their lines.

use csv::{ErrorKind, Position, StringRecord};

/// Size of the largest CSV file that is read, MiB.
pub const MAX_FILE_MIB: u64 = 1024;

/// Row with the number of its line, or the reason why it cannot be read.
type NumberedRow = Result<(u64, StringRecord), String>;

/// Spellings of the unit of a column; none for a column that is not read.
pub type UnitOf = fn(&str) -> &'static [&'static str];

/// Columns and rows of a CSV text.
pub struct CsvRows<I> {
    /// Line of the header.
    pub line: u64,
    /// Names of the columns, without their units.
    pub header: Vec<String>,
    /// Rows.
    pub rows: I,
}

/// Columns and rows of a CSV text. A # begins a comment.
///
/// # Errors
/// Column that is in another unit than `unit_of` allows. Line of a row with another number of fields than the header.
pub fn parse(text: &str, unit_of: UnitOf) -> Result<CsvRows<impl Iterator<Item = NumberedRow>>, String> {
    let text = text.trim_start_matches('\u{feff}');
    let mut builder = csv::ReaderBuilder::new();
    let mut reader = builder.comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| reason(text, &error))?;
    let line = line_of(text, header.position());
    let header = header.iter().map(|field| without_unit(field, unit_of)).collect::<Result<_, _>>();
    let header = header.map_err(|reason| format!("line {line}: {reason}"))?;
    let row = move |row: StringRecord| (line_of(text, row.position()), row);
    let rows = reader.into_records().map(move |found| found.map(row).map_err(|error| reason(text, &error)));
    Ok(CsvRows { line, header, rows })
}

/// Line of a row. The reader's position is before its comments and empty lines.
fn line_of(text: &str, position: Option<&Position>) -> u64 {
    let (byte, line) = position.map_or((0, 1), |position| (position.byte(), position.line()));
    let before = text.get(byte as usize..).unwrap_or_default().lines();
    line + before.take_while(|line| line.is_empty() || line.starts_with('#')).count() as u64
}

/// Name of a column without the unit that follows in brackets.
fn without_unit(field: &str, unit_of: UnitOf) -> Result<String, String> {
    let (name, unit) = field.split_once(['[', '(']).unwrap_or((field, ""));
    let (name, unit) = (name.trim(), unit.trim_end_matches([']', ')', ' ']).trim());
    let allowed = unit_of(name);
    if unit.is_empty() || allowed.is_empty() || allowed.contains(&unit) {
        Ok(name.to_owned())
    } else {
        Err(format!("{name}: must be in {}, not {unit}", allowed[0]))
    }
}

/// Text of an error of the reader, with the line.
fn reason(text: &str, error: &csv::Error) -> String {
    match error.kind() {
        ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = line_of(text, pos.as_ref());
            format!("line {line}: must have {expected_len} fields, as the header; has {len}")
        }
        _ => error.to_string(),
    }
}

/// Finite number of a field.
pub fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_units_of_known_columns_matter() {
        let unit_of: UnitOf = |name| if name == "t" { &["s", "sec"] } else { &[] };
        let names = parse("t (sec),tip_z [mm],t_wall [ms],w [1]\n", unit_of).unwrap().header;
        assert_eq!(names, ["t", "tip_z", "t_wall", "w"]);
        assert_eq!(parse("w,t [ms]", unit_of).err().unwrap(), "line 1: t: must be in s, not ms");
    }

    #[test]
    fn lines_count_comments_and_empty_lines() {
        for end in ["\n", "\r\n"] {
            let text = ["# one", "", "t,x", "# four", "1,2", "", "# seven", "3,4", "5"].join(end);
            let CsvRows { line: header, rows, .. } = parse(&text, |_| &[]).unwrap();
            let lines: Vec<_> = rows.map(|row| row.map(|(line, _)| line)).collect();
            let refused = Err("line 9: must have 2 fields, as the header; has 1".to_owned());
            assert_eq!((header, lines), (3, vec![Ok(5), Ok(8), refused]));
        }
    }
}

//! CSV files: columns by name, and rows with their lines.

use csv::{ErrorKind, Position, StringRecord};

/// Size of the largest CSV file that is read, MiB.
pub const MAX_FILE_MIB: u64 = 1024;

/// Row with its line, or the reason why it cannot be read.
type Row = Result<(u64, StringRecord), String>;

/// Names of the columns of a CSV text without their units, and its rows, each with its line. A # begins a comment.
///
/// # Errors
/// Column that the program can read, with another unit than the program's. Line of a row with another number of fields than the header.
pub fn parse(text: &str) -> Result<(Vec<String>, impl Iterator<Item = Row>), String> {
    let mut builder = csv::ReaderBuilder::new();
    let mut reader = builder.comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(reason)?;
    let names = header.iter().map(without_unit).collect::<Result<_, _>>()?;
    let line = |row: StringRecord| (row.position().map_or(0, Position::line), row);
    Ok((names, reader.into_records().map(move |row| row.map(line).map_err(reason))))
}

/// Name of a column without the unit that follows in brackets.
fn without_unit(field: &str) -> Result<String, String> {
    let (name, unit) = field.split_once(['[', '(']).unwrap_or((field, ""));
    let (name, unit) = (name.trim(), unit.trim_end_matches([']', ')', ' ']).trim());
    let allowed: &[&str] = match name {
        "t" => &["s"],
        "gyro_x" | "gyro_y" | "gyro_z" | "omega_x" | "omega_y" | "omega_z" | "omega_body_x"
        | "omega_body_y" | "omega_body_z" | "wx" | "wy" | "wz" => &["rad/s"],
        "accel_x" | "accel_y" | "accel_z" => &["m/s^2", "m/s²", "m/s2"],
        "tip_x" | "tip_y" => &["m"],
        "mark" => &["rad"],
        "mag_x" | "mag_y" | "mag_z" => &["uT", "µT"],
        _ => &[unit],
    };
    if unit.is_empty() || allowed.contains(&unit) {
        Ok(name.to_owned())
    } else {
        Err(format!("{name}: must be in {}, not {unit}", allowed[0]))
    }
}

/// Text of an error of the reader, with the line.
fn reason(error: csv::Error) -> String {
    match error.kind() {
        ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, Position::line);
            format!("line {line}: must have {expected_len} fields, as the header; has {len}")
        }
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_units_of_known_columns_matter() {
        let names = parse("t [s],tip_z [mm],accel_raw (LSB),t_wall [ms],w [1],wx [rad/s]\n").unwrap().0;
        assert_eq!(names, ["t", "tip_z", "accel_raw", "t_wall", "w", "wx"]);
        for column in
            ["t [ms]", "tip_x [mm]", "wy [deg/s]", "omega_z [deg/s]", "omega_body_x [deg/s]", "mag_x [nT]"]
        {
            assert!(parse(column).is_err(), "{column}");
        }
    }
}

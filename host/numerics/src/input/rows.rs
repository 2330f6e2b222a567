//! Errors of the reader of CSV files.

/// Text of an error of the reader of CSV, with the line if a row has another number of fields than the header.
pub(crate) fn unread(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            format!("line {line}: must have {expected_len} fields, as the header; has {len}")
        }
        _ => error.to_string(),
    }
}

//! Rows as Parquet: a column of doubles for each number, with null where the number does not exist.

use super::sheet::Sheet;
use crate::motion::propagate::Sample;
use crate::output::progress::Progress;
use parquet::column::writer::ColumnWriter;
use parquet::errors::{ParquetError, Result as Written};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use std::io::{self, Write};
use std::sync::Arc;

/// Numbers in a group of rows, which is in memory at once: some 32 MB.
const NUMBERS: u64 = 1 << 22;

/// Writes this many rows.
///
/// # Errors
/// The errors of the writer.
pub fn write(
    sheet: &Sheet,
    count: u64,
    at: &dyn Fn(u64) -> Sample,
    out: &mut (dyn Write + Send),
) -> io::Result<()> {
    groups(sheet, count, at, out).map_err(io::Error::other)
}

fn groups(
    sheet: &Sheet,
    count: u64,
    at: &dyn Fn(u64) -> Sample,
    out: &mut (dyn Write + Send),
) -> Written<()> {
    let names = sheet.names();
    let fields: String = names.iter().map(|name| format!("optional double {name};")).collect();
    let schema = parse_message_type(&format!("message samples {{ {fields} }}"))?;
    let properties = WriterProperties::builder().build();
    let mut writer = SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties))?;
    let mut progress = Progress::new(count, "rows");
    let most = NUMBERS / names.len() as u64;
    let mut numbers = Vec::new();
    for first in (0..count).step_by(most as usize) {
        let last = count.min(first + most);
        let mut columns = vec![Vec::new(); names.len()];
        for row in first..last {
            sheet.numbers(&at(row), &mut numbers);
            columns.iter_mut().zip(&numbers).for_each(|(column, x)| column.push(x + 0.0));
        }
        let mut group = writer.next_row_group()?;
        for column in columns {
            let present: Vec<i16> = column.iter().map(|x| i16::from(!x.is_nan())).collect();
            let values: Vec<f64> = column.into_iter().filter(|x| !x.is_nan()).collect();
            let mut place = group.next_column()?.ok_or_else(|| ParquetError::General("no column".into()))?;
            if let ColumnWriter::DoubleColumnWriter(writer) = place.untyped() {
                writer.write_batch(&values, Some(&present), None)?;
            }
            place.close()?;
        }
        group.close()?;
        progress.add(last - first);
    }
    writer.close().map(drop)
}

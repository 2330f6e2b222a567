//! Rows of chosen columns as CSV, JSON, a NumPy file or an aligned table.

use crate::input::scenario::Units;
use crate::motion::column::Column;
use crate::motion::propagate::Sample;
use crate::output::{self, Record, number, short};
use toytop::Support;

/// Form of the output of samples.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
pub enum SampleFormat {
    /// Aligned table
    Table,
    /// Comma-separated values, one line for each record
    Csv,
    /// One JSON object
    Json,
    /// NumPy file: a structured array with the names of the CSV columns
    Npy,
}

/// Columns of the rows, the units of their numbers, and the form in which they are written.
pub struct Sheet {
    /// Form of the output.
    pub format: SampleFormat,
    /// Columns in their order.
    pub columns: Vec<Column>,
    /// Units of the scenario.
    pub units: Units,
    /// Support of the tip, which decides the unit of its position.
    pub support: Support,
    /// Whether the names of CSV columns end in units.
    pub named_units: bool,
}

impl Sheet {
    /// Bytes before this many rows.
    pub fn head(&self, rows: u64) -> Vec<u8> {
        match self.format {
            SampleFormat::Csv => (self.names().join(",") + "\n").into_bytes(),
            SampleFormat::Json => b"{\"samples\":[".to_vec(),
            SampleFormat::Npy => npy_header(&self.names(), rows),
            SampleFormat::Table => Vec::new(),
        }
    }

    /// Appends the row of this index.
    pub fn row(&self, index: u64, sample: &Sample, bytes: &mut Vec<u8>) {
        let parts: Vec<_> = self.columns.iter().map(|column| (column, column.numbers(sample))).collect();
        let separator = |text: &'static str| if index == 0 { "" } else { text };
        let text = match self.format {
            SampleFormat::Csv => {
                let fields: Vec<_> = parts.iter().flat_map(|(_, numbers)| numbers).map(field).collect();
                fields.join(",") + "\n"
            }
            SampleFormat::Json => separator(",").to_owned() + &object(&parts),
            SampleFormat::Npy => {
                let numbers = parts.iter().flat_map(|(_, numbers)| numbers);
                return numbers.for_each(|x| bytes.extend_from_slice(&(x + 0.0).to_le_bytes()));
            }
            SampleFormat::Table => separator("\n").to_owned() + &self.block(&parts),
        };
        bytes.extend_from_slice(text.as_bytes());
    }

    /// Text after the rows.
    pub fn end(&self) -> String {
        let reason = match (self.format, self.support) {
            (SampleFormat::Json, _) => return "]}\n".to_owned(),
            (SampleFormat::Table, Support::Fixed) => "the tip is held",
            (SampleFormat::Table, Support::Free) => "the body is free",
            _ => return String::new(),
        };
        if !self.columns.contains(&Column::Tip) {
            return String::new();
        }
        format!("\ntip: 2 alpha beta, minus the horizontal part of the axis ({reason})\n")
    }

    /// Names of all numbers of a row.
    fn names(&self) -> Vec<String> {
        let name = |column: &Column, name: &str| match column.unit(self.units, self.support) {
            unit if self.named_units && !unit.is_empty() => format!("{name} [{unit}]"),
            _ => name.to_owned(),
        };
        let names =
            |column: &Column| column.names().1.iter().map(|part| name(column, part)).collect::<Vec<_>>();
        self.columns.iter().flat_map(names).collect()
    }

    /// Block of lines, because one line would be too long for a screen.
    fn block(&self, parts: &[Part<'_>]) -> String {
        let most = parts.iter().map(|(_, numbers)| numbers.len()).max().unwrap_or(0);
        let line = |(column, numbers): &Part<'_>| {
            let digits = match column {
                Column::T => 17,
                Column::ErrorBound => 2,
                _ => 8,
            };
            let unit = column.unit(self.units, self.support).to_owned();
            let mut line = vec![column.names().0.to_owned(), unit];
            line.extend(numbers.iter().filter(|x| !x.is_nan()).map(|x| short(*x, digits)));
            line.resize(2 + most, String::new());
            line
        };
        output::columns(parts.iter().map(line).collect(), 2)
    }
}

/// Column with its numbers of a row.
type Part<'a> = (&'a Column, Vec<f64>);

/// Field of CSV.
fn field(x: &f64) -> String {
    if x.is_nan() { String::new() } else { number(*x) }
}

/// Object of JSON.
fn object(parts: &[Part<'_>]) -> String {
    let entry = |(column, numbers): &Part<'_>| {
        let value = if let [x] = numbers[..] { x.into() } else { numbers.clone().into() };
        (column.names().0, value)
    };
    // a write to memory does not fail
    output::json(&Record(parts.iter().map(entry).collect())).unwrap_or_default().trim_end().to_owned()
}

/// Header of a file with columns of these names and this many rows (format 1.0: magic, length, and a Python literal that ends at a multiple of 64 bytes).
fn npy_header(names: &[String], rows: u64) -> Vec<u8> {
    const BEFORE: usize = 10;
    let fields: String = names.iter().map(|name| format!("('{name}', '<f8'), ")).collect();
    let mut text = format!("{{'descr': [{fields}], 'fortran_order': False, 'shape': ({rows},), }}");
    while !(BEFORE + text.len() + 1).is_multiple_of(64) {
        text.push(' ');
    }
    text.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    // the header has some hundred bytes, so its length fits 16 bits
    bytes.extend_from_slice(&(text.len() as u16).to_le_bytes());
    bytes.extend_from_slice(text.as_bytes());
    bytes
}

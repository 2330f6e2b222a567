//! Rows of chosen columns as CSV, JSON, a NumPy file or an aligned table.

use crate::input::scenario::Units;
use crate::motion::propagate::Sample;
use crate::motion::quantity::Quantity;
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
    pub columns: Vec<Quantity>,
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
        let numbers = self.columns.iter().flat_map(|column| column.numbers(sample));
        let text = match self.format {
            SampleFormat::Npy => return numbers.for_each(|x| bytes.extend((x + 0.0).to_le_bytes())),
            SampleFormat::Csv => {
                let field = |x: f64| if x.is_nan() { String::new() } else { number(x) };
                numbers.map(field).collect::<Vec<_>>().join(",") + "\n"
            }
            SampleFormat::Json if index == 0 => self.object(sample),
            SampleFormat::Json => format!(",{}", self.object(sample)),
            SampleFormat::Table if index == 0 => self.block(sample),
            SampleFormat::Table => format!("\n{}", self.block(sample)),
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
        if !self.columns.contains(&Quantity::Tip) {
            return String::new();
        }
        format!("\ntip: 2 alpha beta, minus the horizontal part of the axis ({reason})\n")
    }

    /// Names of all numbers of a row.
    fn names(&self) -> Vec<String> {
        let names = |column: &Quantity| {
            let unit = if self.named_units { column.unit(self.units, self.support) } else { "" };
            let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
            column.names().1.iter().map(move |name| format!("{name}{unit}"))
        };
        self.columns.iter().flat_map(names).collect()
    }

    /// Lines of a sample, because one line would be too long for a screen.
    fn block(&self, sample: &Sample) -> String {
        let line = |column: &Quantity| {
            let digits = match column {
                Quantity::T => 17,
                Quantity::ErrorBound => 2,
                _ => 8,
            };
            let (name, unit) = (column.names().0, column.unit(self.units, self.support));
            let numbers = column.numbers(sample).into_iter().filter(|x| !x.is_nan());
            let texts = [name.to_owned(), unit.to_owned()];
            texts.into_iter().chain(numbers.map(|x| short(x, digits))).collect()
        };
        output::columns(self.columns.iter().map(line).collect(), 2)
    }

    /// JSON object of a sample.
    fn object(&self, sample: &Sample) -> String {
        let entry = |column: &Quantity| {
            let numbers = column.numbers(sample);
            let value = if let [x] = numbers[..] { x.into() } else { numbers.into() };
            (column.names().0, value)
        };
        // a write to memory does not fail
        let object = output::json(&Record(self.columns.iter().map(entry).collect())).unwrap_or_default();
        object.trim_end().to_owned()
    }
}

/// Header of a file with columns of these names and this many rows (format 1.0: magic, length, and a Python literal that ends at a multiple of 64 bytes).
fn npy_header(names: &[String], rows: u64) -> Vec<u8> {
    let fields: String = names.iter().map(|name| format!("('{name}', '<f8'), ")).collect();
    let text = format!("{{'descr': [{fields}], 'fortran_order': False, 'shape': ({rows},), }}");
    let before = b"\x93NUMPY\x01\x00".len() + 2;
    let length = (before + text.len() + 1).next_multiple_of(64) - before;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    // the header has some hundred bytes, so its length fits 16 bits
    bytes.extend_from_slice(&(length as u16).to_le_bytes());
    bytes.extend_from_slice(format!("{text:<0$}\n", length - 1).as_bytes());
    bytes
}

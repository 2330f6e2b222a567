//! Records as an aligned table, CSV or JSON. In CSV and JSON a number has 17 significant digits, from which a reader obtains the same `f64`.

pub mod command_line;
pub mod doc_markers;
pub mod progress;
pub mod stdout;
pub mod whole_file;

use comfy_table::{CellAlignment, Row, Table, presets::NOTHING};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::Value;
use serde_json::ser::Formatter;
use std::io::{self, Write};
use std::iter::once;

/// Named values, in order: words, numbers, arrays of numbers, and null for an absent value.
#[derive(Clone, Default)]
pub struct Record(pub Vec<(&'static str, Value)>);

impl Record {
    /// Record with one more value.
    pub fn with(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.0.push((name, value.into()));
        self
    }

    /// Names of the columns of CSV. Those of an array end in x, y and z.
    fn columns(&self) -> Vec<String> {
        let names = |(name, value): &(&str, Value)| match value {
            Value::Array(parts) => {
                "xyz".chars().take(parts.len()).map(|end| format!("{name}_{end}")).collect()
            }
            _ => vec![(*name).to_owned()],
        };
        self.0.iter().flat_map(names).collect()
    }

    /// Line of CSV. The parts of an array are fields of their own, and an absent value is an empty field.
    pub fn csv(&self) -> String {
        let parts = |value| if let Value::Array(parts) = value { parts } else { vec![value] };
        csv_line(self.0.iter().flat_map(|(_, value)| parts(value.clone())))
    }
}

impl Serialize for Record {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

/// Form of the output.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
pub enum Format {
    /// Aligned table
    Table,
    /// Comma-separated values, one line for each record
    Csv,
    /// One JSON object
    Json,
}

/// Lists of records by their keys, and further values.
pub struct Document<'a> {
    /// Lists, in order.
    pub lists: Vec<(&'static str, &'a [Record])>,
    /// Further values.
    pub values: Record,
}

impl Serialize for Document<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_map(None)?;
        self.lists.iter().try_for_each(|(key, records)| object.serialize_entry(key, records))?;
        self.values.0.iter().try_for_each(|(key, value)| object.serialize_entry(key, value))?;
        object.end()
    }
}

/// One list without further values.
pub fn list<'a>(key: &'static str, records: &'a [Record]) -> Document<'a> {
    Document { lists: vec![(key, records)], values: Record::default() }
}

/// Document in a form; `table` makes the table. CSV has the first list, or else one line with the other values. JSON is the object
/// `{"key":[record, ...], ..., "other":value, ...}`.
pub fn render(format: Format, document: &Document<'_>, table: impl FnOnce() -> String) -> String {
    match format {
        Format::Table => table(),
        Format::Csv => {
            csv(document.lists.first().map_or(std::slice::from_ref(&document.values), |(_, records)| records))
        }
        Format::Json => json(document) + "\n",
    }
}

/// JSON in which a number has 17 digits.
pub fn json(value: &impl Serialize) -> String {
    let mut json = Vec::new();
    value
        .serialize(&mut serde_json::Serializer::with_formatter(&mut json, Digits))
        .expect("no key is a number");
    String::from_utf8(json).expect("JSON is UTF-8")
}

/// Format of JSON that differs in its numbers from the default.
struct Digits;

impl Formatter for Digits {
    fn write_f64<W: Write + ?Sized>(&mut self, writer: &mut W, x: f64) -> io::Result<()> {
        writer.write_all(number(x).as_bytes())
    }
}

/// Records as CSV, with a header line.
pub fn csv(records: &[Record]) -> String {
    let header = |record: &Record| csv_line(record.columns().into_iter().map(Value::from));
    records.first().map(header).into_iter().chain(records.iter().map(Record::csv)).collect()
}

/// Line of CSV. An absent value is an empty field.
pub fn csv_line(values: impl IntoIterator<Item = Value>) -> String {
    let field = |value| {
        let text = text(&value, number).unwrap_or_default();
        if text.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", text.replace('"', "\"\""))
        } else {
            text
        }
    };
    values.into_iter().map(field).collect::<Vec<_>>().join(",") + "\n"
}

/// Column of a table: name of a value, heading, and text of a number.
pub type Column<'a> = (&'static str, &'a str, fn(f64) -> String);

/// Columns of all values of records, with their names as headings.
pub fn all_columns(records: &[Record], of_number: fn(f64) -> String) -> Vec<Column<'static>> {
    records.first().iter().flat_map(|record| &record.0).map(|(name, _)| (*name, *name, of_number)).collect()
}

/// Header and rows of a table. A value that is absent is a dash.
pub fn rows(records: &[Record], shown: &[Column<'_>]) -> Vec<Vec<String>> {
    let row = |record: &Record| {
        let cell = |(name, _, of_number): &Column<'_>| {
            let value = record.0.iter().find(|(other, _)| other == name).map(|(_, value)| value);
            value.and_then(|value| text(value, *of_number)).unwrap_or_else(|| "-".to_owned())
        };
        shown.iter().map(cell).collect()
    };
    let header = shown.iter().map(|(_, heading, _)| (*heading).to_owned()).collect();
    once(header).chain(records.iter().map(row)).collect()
}

/// Text of a word or number; `None` for any other value.
pub fn text(value: &Value, of_number: impl Fn(f64) -> String) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Number(whole) if !whole.is_f64() => Some(whole.to_string()),
        value => value.as_f64().map(of_number),
    }
}

/// Records as aligned columns below their headings; the first columns are aligned to the left as long as they contain words.
pub fn aligned(records: &[Record], shown: &[Column<'_>]) -> String {
    let is_word = |column: &&Column<'_>| {
        records
            .iter()
            .all(|record| record.0.iter().any(|(name, value)| name == &column.0 && value.is_string()))
    };
    columns(rows(records, shown), shown.iter().take_while(is_word).count())
}

/// Rows as aligned columns without rules, the first `left` columns aligned to the left and the others to the right.
pub fn columns(rows: Vec<Vec<String>>, left: usize) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING).add_rows(rows.into_iter().map(Row::from));
    for (index, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 2));
        column.set_cell_alignment(if index < left { CellAlignment::Left } else { CellAlignment::Right });
    }
    table.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// Number with eight significant digits.
pub fn eight_digits(x: f64) -> String {
    short(x, 8)
}

/// Error with two significant digits.
pub fn two_digits(x: f64) -> String {
    format!("{x:.1e}")
}

/// Number with 17 significant digits; -0 is written as 0.
pub fn number(x: f64) -> String {
    format!("{:.16e}", x + 0.0)
}

/// Number with this many significant digits, without trailing zeros.
pub fn short(x: f64, digits: usize) -> String {
    let rounded: f64 = format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x);
    if (1e-4..1e5).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

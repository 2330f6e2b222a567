//! Records as an aligned table, CSV or JSON. In CSV and JSON a number has 17 significant digits, from which a reader obtains the same `f64`.
//!
//! A record is an object of JSON: words, numbers, lists of them, and null for an absent value.

pub mod command_line;
pub mod doc_markers;
pub mod progress;
pub mod stdout;
pub mod table;
pub mod whole_file;

use serde::ser::Serialize;
use serde_json::Value;
use serde_json::ser::Formatter;
use std::io::{self, Write};
use std::iter::once;

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

/// Document in a form; `table` makes the table. CSV has the records of its first value, or else the document as one record.
pub fn render(format: Format, document: &Value, table: impl FnOnce() -> String) -> String {
    let first = document.as_object().and_then(|values| values.values().next());
    match format {
        Format::Table => table(),
        Format::Csv => {
            csv(first.and_then(Value::as_array).map_or(std::slice::from_ref(document), Vec::as_slice))
        }
        Format::Json => json(document) + "\n",
    }
}

/// JSON in which a number has 17 digits.
pub fn json(value: &Value) -> String {
    let mut json = Vec::new();
    value
        .serialize(&mut serde_json::Serializer::with_formatter(&mut json, Digits))
        .expect("memory takes the text");
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
fn csv(records: &[Value]) -> String {
    let fields: Vec<_> = records.iter().map(|record| fields("", record)).collect();
    let header = fields.first().map(|fields| csv_line(fields.iter().map(|(name, _)| name.as_str().into())));
    let line = |fields: Vec<(String, Value)>| csv_line(fields.into_iter().map(|(_, value)| value));
    header.into_iter().chain(fields.into_iter().map(line)).collect()
}

/// Fields of CSV with their names. Those of a vector end in x, y and z, those of a longer list in numbers from 1, and those of an object
/// in its keys. A quaternion is w,x,y,z, and words are one field.
fn fields(name: &str, value: &Value) -> Vec<(String, Value)> {
    let parts: Vec<(String, &Value)> = match value {
        Value::Object(parts) => parts.iter().map(|(key, part)| (key.clone(), part)).collect(),
        Value::Array(parts) if !parts.iter().all(Value::is_string) => {
            let ends = ["x", "y", "z"].map(str::to_owned).into_iter();
            let ends: Vec<_> = match parts.len() {
                0..=3 => ends.collect(),
                4 => once("w".to_owned()).chain(ends).collect(),
                count => (1..=count).map(|place| place.to_string()).collect(),
            };
            ends.into_iter().zip(parts).collect()
        }
        Value::Array(words) => {
            let words: Vec<_> = words.iter().filter_map(Value::as_str).collect();
            return vec![(name.to_owned(), words.join("; ").into())];
        }
        value => return vec![(name.to_owned(), value.clone())],
    };
    let path = |end: String| if ["", "quaternion"].contains(&name) { end } else { format!("{name}_{end}") };
    parts.into_iter().flat_map(|(end, part)| fields(&path(end), part)).collect()
}

/// Line of CSV. An absent value is an empty field.
pub fn csv_line(values: impl IntoIterator<Item = Value>) -> String {
    let fields = values.into_iter().map(|value| text(&value, number).unwrap_or_default());
    let mut line = csv::Writer::from_writer(Vec::new());
    line.write_record(fields).expect("memory takes the line");
    String::from_utf8(line.into_inner().expect("memory takes the line")).expect("fields are UTF-8")
}

/// Text of a word, a number, or true or false; `None` for any other value.
pub fn text(value: &Value, of_number: impl Fn(f64) -> String) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Bool(holds) => Some(holds.to_string()),
        Value::Number(whole) if !whole.is_f64() => Some(whole.to_string()),
        value => value.as_f64().map(of_number),
    }
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

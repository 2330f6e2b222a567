//! Records as an aligned table, CSV or JSON. In CSV and JSON a number has 17 significant digits, from which a reader obtains the same `f64`.
//!
//! A record is an object of JSON: words, numbers, lists of them, and null for an absent value.

pub mod table;

use serde::ser::Serialize;
use serde_json::Value;
use serde_json::ser::Formatter;
use std::io::{self, Write};
use std::slice;

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

/// Ends of the names of CSV columns for the parts of a list, by the key of the list.
pub type ListEnds<'a> = [(&'a str, &'a [&'a str])];

/// Document in a form; `table` makes the table. CSV has the records of its first value, or else the document as one record.
pub fn render(format: Format, document: &Value, table: impl FnOnce() -> String) -> String {
    render_lists(format, document, &[], table)
}

/// As [`render`], of records that have lists.
pub fn render_lists(
    format: Format,
    document: &Value,
    ends: &ListEnds<'_>,
    table: impl FnOnce() -> String,
) -> String {
    let first = document.as_object().and_then(|values| values.values().next());
    let records = first.and_then(Value::as_array).map_or(slice::from_ref(document), Vec::as_slice);
    match format {
        Format::Table => table(),
        Format::Csv => csv(records, ends),
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
fn csv(records: &[Value], ends: &ListEnds<'_>) -> String {
    let rows = records.iter().map(|record| fields("", "", record, ends)).collect::<Vec<_>>();
    let header = rows.first().map(|row| csv_line(row.iter().map(|(name, _)| name.as_str().into())));
    let line = |row: Vec<(String, Value)>| csv_line(row.into_iter().map(|(_, value)| value));
    header.into_iter().chain(rows.into_iter().map(line)).collect()
}

/// Fields of CSV with their names, which end in the keys of objects and in the ends of lists, or else in numbers from 1. Words are one
/// field.
fn fields(name: &str, key: &str, value: &Value, ends: &ListEnds<'_>) -> Vec<(String, Value)> {
    let part = |(end, part): (String, &Value)| {
        let name = if name.is_empty() { end.clone() } else { format!("{name}_{end}") };
        fields(&name, &end, part, ends)
    };
    match value {
        Value::Object(parts) => {
            parts.iter().map(|(key, value)| (key.clone(), value)).flat_map(part).collect()
        }
        Value::Array(words) if words.iter().all(Value::is_string) => {
            let words: Vec<_> = words.iter().filter_map(Value::as_str).collect();
            vec![(name.to_owned(), words.join("; ").into())]
        }
        Value::Array(parts) => match ends.iter().find(|(list, _)| *list == key) {
            Some((_, ends)) => ends.iter().map(|end| (*end).to_owned()).zip(parts).flat_map(part).collect(),
            None => (1..).map(|number: usize| number.to_string()).zip(parts).flat_map(part).collect(),
        },
        value => vec![(name.to_owned(), value.clone())],
    }
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

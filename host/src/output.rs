//! Records as an aligned table, CSV or JSON. In CSV and JSON a number has 17 significant digits, from which a reader obtains the same `f64`.

pub mod command_line;
pub mod doc_markers;
pub mod progress;
pub mod stdout;
pub mod whole_file;

use comfy_table::{CellAlignment, Row, Table, presets::NOTHING};
use serde_json::Value;
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

    /// Names and values of the columns of CSV. Those of an array end in x, y and z.
    pub fn flat(&self) -> Vec<(String, &Value)> {
        let mut columns = Vec::new();
        for (name, value) in &self.0 {
            match value {
                Value::Array(parts) => {
                    columns.extend(
                        parts.iter().zip(["x", "y", "z"]).map(|(part, end)| (format!("{name}_{end}"), part)),
                    );
                }
                value => columns.push(((*name).to_owned(), value)),
            }
        }
        columns
    }

    /// Object of JSON.
    pub fn json(&self) -> String {
        object(self.0.iter().map(|(name, value)| (*name, json(value))))
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
pub struct Lists<'a>(pub Vec<(&'static str, &'a [Record])>, pub Record);

/// One list without further values.
pub fn list<'a>(key: &'static str, records: &'a [Record]) -> Lists<'a> {
    Lists(vec![(key, records)], Record::default())
}

/// Records in a form. CSV contains only the first list, or else one line with the other values; `table` makes the table. JSON is
/// the object `{"key":[record, ...], ..., "other":value, ...}`.
pub fn render(format: Format, Lists(lists, rest): &Lists<'_>, table: impl FnOnce() -> String) -> String {
    match format {
        Format::Table => table(),
        Format::Csv => csv(lists.first().map_or(std::slice::from_ref(rest), |(_, records)| records)),
        Format::Json => {
            let list =
                |(key, records): &(&'static str, &[Record])| (*key, array(records.iter().map(Record::json)));
            let rest = rest.0.iter().map(|(key, value)| (*key, json(value)));
            object(lists.iter().map(list).chain(rest)) + "\n"
        }
    }
}

/// Value as JSON.
pub fn json(value: &Value) -> String {
    match value {
        Value::Number(x) if x.is_f64() => x.as_f64().map_or_else(String::new, number),
        Value::Array(parts) => array(parts.iter().map(json)),
        Value::Object(entries) => object(entries.iter().map(|(key, value)| (&**key, json(value)))),
        value => value.to_string(),
    }
}

fn array(parts: impl Iterator<Item = String>) -> String {
    format!("[{}]", parts.collect::<Vec<_>>().join(","))
}

fn object<'a>(entries: impl Iterator<Item = (&'a str, String)>) -> String {
    let entries = entries.map(|(key, value)| format!("{}:{value}", Value::from(key)));
    format!("{{{}}}", entries.collect::<Vec<_>>().join(","))
}

/// Records as CSV, with a header line.
pub fn csv(records: &[Record]) -> String {
    let header = |record: &Record| csv_line(record.flat().into_iter().map(|(name, _)| name.into()));
    let line = |record: &Record| csv_line(record.flat().into_iter().map(|(_, value)| value.clone()));
    records.first().map(header).into_iter().chain(records.iter().map(line)).collect()
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

/// Beginning of a text of the input, short enough for a message.
pub fn shown(text: &str) -> String {
    const MOST: usize = 60;
    let beginning: String = text.chars().take(MOST).collect();
    if beginning.len() < text.len() { format!("{beginning}...") } else { beginning }
}

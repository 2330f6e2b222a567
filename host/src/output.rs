//! Records as an aligned table, CSV or JSON. In CSV and JSON a number has 17 significant digits, from which a reader obtains the same `f64`.

pub mod doc_markers;
#[cfg_attr(not(feature = "program"), path = "output/silent.rs")]
pub mod progress;
#[cfg(feature = "program")]
pub mod stdout;
pub mod whole_file;

pub use toytop_model::names;

#[cfg(feature = "program")]
use comfy_table::presets::NOTHING;
#[cfg(feature = "program")]
use comfy_table::{CellAlignment, Row, Table};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::Value;
use serde_json::ser::Formatter;
use std::io;

/// Named values, in order: words, numbers, arrays of numbers, and null for an absent value.
#[derive(Clone, Default)]
pub struct Record(pub Vec<(&'static str, Value)>);

impl Record {
    /// Record with one more value.
    pub fn with(mut self, name: &'static str, value: impl Into<Value>) -> Self {
        self.0.push((name, value.into()));
        self
    }

    fn get(&self, name: &str) -> Option<&Value> {
        self.0.iter().find(|(other, _)| *other == name).map(|(_, value)| value)
    }
}

/// Form of the output.
#[cfg(feature = "program")]
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
pub enum Format {
    /// Aligned table
    Table,
    /// Comma-separated values, one line for each record
    Csv,
    /// One JSON object
    Json,
}

/// Records in a form. CSV contains only the first list, or else one line with the other entries; `table` makes the table.
///
/// # Errors
/// None: the writers' types can fail, but a write to memory does not.
#[cfg(feature = "program")]
pub fn render(format: Format, lists: &Lists<'_>, table: impl FnOnce() -> String) -> io::Result<String> {
    match format {
        Format::Table => Ok(table()),
        Format::Csv => csv(lists.0.first().map_or(std::slice::from_ref(&lists.1), |(_, records)| records)),
        Format::Json => json(lists),
    }
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
        let text = |(name, _, of_number): &Column<'_>| {
            record.get(name).and_then(|value| text(value, *of_number)).unwrap_or_else(|| "-".to_owned())
        };
        shown.iter().map(text).collect()
    };
    let header = shown.iter().map(|(_, heading, _)| (*heading).to_owned()).collect();
    std::iter::once(header).chain(records.iter().map(row)).collect()
}

/// Records as aligned columns below their headings; texts are aligned to the left.
#[cfg(feature = "program")]
pub fn aligned(records: &[Record], shown: &[Column<'_>]) -> String {
    let mut rows = rows(records, shown);
    if shown.iter().all(|(_, heading, _)| heading.is_empty()) {
        rows.remove(0);
    }
    let is_text = |index: usize| {
        records.iter().all(|record| matches!(record.get(shown[index].0), Some(Value::String(_)) | None))
    };
    text_of(rows, is_text)
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

/// Records as CSV, with a header line.
///
/// # Errors
/// None: the writer's type can fail, but a write to memory does not.
pub fn csv(records: &[Record]) -> io::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    if let Some(first) = records.first() {
        writer.write_record(flat(first).into_iter().map(|(name, _)| name))?;
    }
    for record in records {
        writer.write_record(flat(record).into_iter().map(|(_, value)| value))?;
    }
    let bytes = writer.into_inner().map_err(io::Error::other)?;
    String::from_utf8(bytes).map_err(io::Error::other)
}

/// Word or number of a record as text; `None` for an absent value.
pub fn text(value: &Value, of_number: impl Fn(f64) -> String) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Number(whole) if !whole.is_f64() => Some(whole.to_string()),
        value => value.as_f64().map(of_number),
    }
}

/// Column names and values of a record. The columns of an array end in x, y and z.
pub fn flat(record: &Record) -> Vec<(String, String)> {
    let field = |value: &Value| text(value, number).unwrap_or_default();
    let columns = |(name, value): &(&'static str, Value)| match value {
        Value::Array(parts) => {
            let parts = parts.iter().zip(["x", "y", "z"]);
            parts.map(|(part, suffix)| (format!("{name}_{suffix}"), field(part))).collect()
        }
        value => vec![((*name).to_owned(), field(value))],
    };
    record.0.iter().flat_map(columns).collect()
}

/// Object of JSON `{"key":[record, ...], ...}`, with the entries of another record after the lists.
pub struct Lists<'a>(pub Vec<(&'static str, &'a [Record])>, pub Record);

impl Serialize for Lists<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(lists, Record(rest)) = self;
        let mut map = serializer.serialize_map(None)?;
        lists.iter().try_for_each(|(key, records)| map.serialize_entry(key, records))?;
        rest.iter().try_for_each(|(key, value)| map.serialize_entry(key, value))?;
        map.end()
    }
}

/// Object of JSON with one list.
pub fn list<'a>(key: &'static str, records: &'a [Record]) -> Lists<'a> {
    Lists(vec![(key, records)], Record::default())
}

/// Value as JSON, on one line.
///
/// # Errors
/// None: the writer's type can fail, but a write to memory does not.
pub fn json(value: &impl Serialize) -> io::Result<String> {
    let mut bytes = Vec::new();
    let mut serializer = serde_json::Serializer::with_formatter(&mut bytes, SeventeenDigits);
    value.serialize(&mut serializer)?;
    bytes.push(b'\n');
    String::from_utf8(bytes).map_err(io::Error::other)
}

impl Serialize for Record {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

struct SeventeenDigits;

impl Formatter for SeventeenDigits {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        writer.write_all(number(value).as_bytes())
    }
}

/// Rows as aligned columns without rules, the first `left` columns aligned to the left and the others to the right.
#[cfg(feature = "program")]
pub fn columns(rows: Vec<Vec<String>>, left: usize) -> String {
    text_of(rows, |index| index < left)
}

/// Rows as aligned columns without rules; `left` selects those that are aligned to the left.
#[cfg(feature = "program")]
fn text_of(rows: Vec<Vec<String>>, left: impl Fn(usize) -> bool) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING).add_rows(rows.into_iter().map(Row::from));
    for (index, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 2));
        column.set_cell_alignment(if left(index) { CellAlignment::Left } else { CellAlignment::Right });
    }
    table.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

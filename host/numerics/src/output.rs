//! Records as CSV and JSON. Numbers have 17 significant digits, from which a reader obtains the same `f64`.

mod base64;
#[cfg(feature = "program")]
pub(crate) mod digits;
pub mod doc_markers;
#[cfg_attr(not(feature = "program"), path = "output/silent.rs")]
pub mod progress;
pub mod whole_file;

pub use base64::base64;
pub use toytop_page::names;

#[cfg(feature = "program")]
use comfy_table::presets::NOTHING;
#[cfg(feature = "program")]
use comfy_table::{CellAlignment, Row, Table};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::ser::Formatter;
use std::io;

/// Value of a record.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Word or name.
    Text(String),
    /// Whole number.
    Count(u64),
    /// Number, with 17 significant digits in the output.
    Number(f64),
    /// Absent value: `null` in JSON, empty in CSV.
    Absent,
    /// Several numbers with the suffixes of their CSV columns: an array in JSON.
    Numbers(Vec<(&'static str, f64)>),
}

impl From<Option<f64>> for Cell {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Absent, Self::Number)
    }
}

/// Named values, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Record(pub Vec<(&'static str, Cell)>);

/// Number with 17 significant digits; -0 is written as 0.
#[must_use]
pub fn number(x: f64) -> String {
    format!("{:.16e}", x + 0.0)
}

/// Number with this many significant digits, without trailing zeros.
#[must_use]
pub fn short(x: f64, digits: usize) -> String {
    let rounded: f64 = format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x);
    if (1e-4..1e5).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// Beginning of a text of the input, short enough for a message.
#[must_use]
pub fn shown(text: &str) -> String {
    const MOST: usize = 60;
    let beginning: String = text.chars().take(MOST).collect();
    if beginning.len() < text.len() { format!("{beginning}...") } else { beginning }
}

/// Text for HTML.
#[must_use]
pub fn html(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
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

/// Column names and values of a record.
#[must_use]
pub fn flat(record: &Record) -> Vec<(String, String)> {
    let columns = |(name, cell): &(&'static str, Cell)| match cell {
        Cell::Text(text) => vec![((*name).to_owned(), text.clone())],
        Cell::Count(count) => vec![((*name).to_owned(), count.to_string())],
        Cell::Number(x) => vec![((*name).to_owned(), number(*x))],
        Cell::Absent => vec![((*name).to_owned(), String::new())],
        Cell::Numbers(parts) => {
            parts.iter().map(|(suffix, x)| (format!("{name}_{suffix}"), number(*x))).collect()
        }
    };
    record.0.iter().flat_map(columns).collect()
}

/// JSON object `{"key":[record, ...]}`, on one line.
///
/// # Errors
/// None: the writer's type can fail, but a write to memory does not.
pub fn json_list(key: &'static str, records: &[Record]) -> io::Result<String> {
    json_lists(&[(key, records)], &Record(Vec::new()))
}

/// JSON object `{"key":[record, ...], ...}` on one line, with the entries of another record after the lists.
///
/// # Errors
/// None: the writer's type can fail, but a write to memory does not.
pub fn json_lists(lists: &[(&'static str, &[Record])], rest: &Record) -> io::Result<String> {
    struct Lists<'a>(&'a [(&'static str, &'a [Record])], &'a Record);
    impl Serialize for Lists<'_> {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            let Self(lists, rest) = self;
            let mut map = serializer.serialize_map(Some(lists.len() + rest.0.len()))?;
            lists.iter().try_for_each(|(key, records)| map.serialize_entry(key, records))?;
            rest.0.iter().try_for_each(|(key, cell)| map.serialize_entry(key, cell))?;
            map.end()
        }
    }
    json(&Lists(lists, rest))
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
        serializer.collect_map(self.0.iter().map(|(name, cell)| (name, cell)))
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => serializer.serialize_str(text),
            Self::Count(count) => serializer.serialize_u64(*count),
            Self::Number(x) => serializer.serialize_f64(*x),
            Self::Absent => serializer.serialize_none(),
            Self::Numbers(parts) => serializer.collect_seq(parts.iter().map(|(_, x)| x)),
        }
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
#[must_use]
pub fn columns(rows: Vec<Vec<String>>, left: usize) -> String {
    let mut table = Table::new();
    table.load_style(NOTHING).add_rows(rows.into_iter().map(Row::from));
    for (index, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 2));
        column.set_cell_alignment(if index < left { CellAlignment::Left } else { CellAlignment::Right });
    }
    table.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

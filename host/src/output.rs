//! Rows as CSV or JSON. In CSV and JSON a number has 17 significant digits, from which a reader obtains the same `f64`.

use serde::ser::Serialize;
use serde_json::Value;
use serde_json::ser::Formatter;
use std::io::{self, Write};
use toytop_model::constants::{self, Constant};
use toytop_model::motion_with_period::MotionWithPeriod;

/// Form of the output.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum))]
pub enum Format {
    /// Aligned table
    Table,
    /// Comma-separated values, one line for each row
    Csv,
    /// One JSON object
    Json,
}

/// Output in a form: the document in JSON, its rows in CSV, or the text of `table`.
pub fn render(
    format: Format,
    document: &impl Serialize,
    rows: &[impl Serialize],
    table: impl FnOnce() -> String,
) -> String {
    match format {
        Format::Table => table(),
        Format::Csv => csv(rows),
        Format::Json => json(document) + "\n",
    }
}

/// Value of a constant in JSON; null where the motion does not have it.
pub fn constant_as_json(constant: &Constant, motion: &MotionWithPeriod) -> Value {
    match constant.value {
        constants::Value::Number(value) => value(motion).into(),
        constants::Value::Word(value) => value(motion).into(),
    }
}

/// JSON in which a number has 17 digits.
pub fn json(value: &impl Serialize) -> String {
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
        writer.write_all(exact(x).as_bytes())
    }
}

/// Rows as CSV below the header of the first one.
fn csv(rows: &[impl Serialize]) -> String {
    let header = rows.iter().take(1).map(csv_header);
    let line = |row| csv_line(fields(row).into_iter().map(|(_, value)| value));
    header.chain(rows.iter().map(line)).collect()
}

/// Line of CSV with the names of a row.
pub fn csv_header(row: &impl Serialize) -> String {
    csv_line(fields(row).into_iter().map(|(name, _)| name))
}

/// Names of the parts of a list of two, three or four numbers.
const PARTS: [&[&str]; 3] = [&["x", "y"], &["x", "y", "z"], &["w", "x", "y", "z"]];

/// Words and numbers of a row with their names. Nested keys are joined by `_`; numbers of a list get x, y, z or 1, 2, ...
pub fn fields(row: &impl Serialize) -> Vec<(String, Value)> {
    let mut fields = Vec::new();
    let row = serde_json::to_value(row).expect("a row has names");
    flatten(String::new(), row, &mut fields);
    fields
}

/// Appends the words and numbers of a value, each with its full name. A list of words becomes one field.
fn flatten(name: String, value: Value, fields: &mut Vec<(String, Value)>) {
    let named = |part: &str| if name.is_empty() { part.to_owned() } else { format!("{name}_{part}") };
    match value {
        Value::Object(parts) => parts.into_iter().for_each(|(key, part)| flatten(named(&key), part, fields)),
        Value::Array(words) if words.iter().all(Value::is_string) => {
            let words: Vec<_> = words.iter().filter_map(Value::as_str).collect();
            fields.push((name, words.join("; ").into()));
        }
        Value::Array(parts) => {
            let are_numbers = parts.iter().all(|part| !part.is_object() && !part.is_array());
            let names = PARTS.iter().find(|names| are_numbers && names.len() == parts.len());
            for (place, part) in parts.into_iter().enumerate() {
                let end = names.map_or_else(|| (place + 1).to_string(), |names| names[place].to_owned());
                flatten(named(&end), part, fields);
            }
        }
        value => fields.push((name, value)),
    }
}

/// Line of CSV, of names or of values. An absent value, or a number that is not finite, is an empty field.
pub fn csv_line(values: impl IntoIterator<Item: Into<Value>>) -> String {
    let fields = values.into_iter().map(|value| text(&value.into(), exact).unwrap_or_default());
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

/// Text of a number, or a dash where it is absent.
pub fn or_dash(number: Option<f64>, text: fn(f64) -> String) -> String {
    number.map_or_else(|| "-".to_owned(), text)
}

/// Error with two significant digits.
pub fn error_text(x: f64) -> String {
    format!("{x:.1e}")
}

/// Number with 17 significant digits; -0 is written as 0.
pub fn exact(x: f64) -> String {
    format!("{:.16e}", x + 0.0)
}

/// Number with this many significant digits, without trailing zeros.
pub fn significant(x: f64, digits: usize) -> String {
    let rounded: f64 = format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x);
    if (1e-4..1e5).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

//! Samples as rows of CSV, JSON or blocks of aligned lines, one at a time, because the text of all of them may not fit into memory.

use crate::terminal::table::TextTable;
use serde_json::Value;
use toytop::Support;
use toytop_host::input::scenario::Units;
use toytop_host::motion::column::SampleColumn;
use toytop_host::motion::sample::MotionSample;
use toytop_host::output::{Format, csv_line, json, significant};

/// Columns of the rows, the units of their numbers, and the form in which they are written.
pub struct RowFormat {
    /// Form of the output.
    pub format: Format,
    /// Columns in their order.
    pub columns: Vec<SampleColumn>,
    /// Units of the scenario.
    pub units: Units,
    /// Support of the tip; decides the unit of its position.
    pub support: Support,
}

impl RowFormat {
    /// Text before the rows.
    pub fn head(&self) -> String {
        match self.format {
            Format::Csv => csv_line(self.columns.iter().flat_map(|column| column.names()).copied()),
            Format::Json => "{\"samples\":[".to_owned(),
            Format::Table => String::new(),
        }
    }

    /// Row of this index.
    pub fn row(&self, index: u64, sample: &MotionSample) -> String {
        let entry = |column: &SampleColumn| {
            let numbers = column.numbers(sample);
            let value: Value = if let [x] = numbers[..] { x.into() } else { numbers.into() };
            (column.key(), value)
        };
        let between = |text: &str| if index == 0 { String::new() } else { text.to_owned() };
        match self.format {
            Format::Csv => csv_line(self.columns.iter().flat_map(|column| column.numbers(sample))),
            Format::Json => between(",") + &json(&self.columns.iter().map(entry).collect::<Value>()),
            Format::Table => between("\n") + &self.block(sample),
        }
    }

    /// Text after the rows.
    pub fn end(&self) -> String {
        let reason = match (self.format, self.support) {
            (Format::Json, _) => return "]}\n".to_owned(),
            (Format::Table, Support::Fixed) => "the tip is held",
            (Format::Table, Support::Free) => "the body is free",
            _ => return String::new(),
        };
        if !self.columns.contains(&SampleColumn::Tip) {
            return String::new();
        }
        format!("\ntip: 2 alpha beta, minus the horizontal part of the axis ({reason})\n")
    }

    /// Sample over several lines.
    fn block(&self, sample: &MotionSample) -> String {
        let line = |column: &SampleColumn| {
            let digits = match column {
                SampleColumn::T => 17,
                SampleColumn::ErrorBound => 2,
                _ => 8,
            };
            let (name, unit) = (column.key(), self.units.name(column.unit(self.support)));
            let numbers = column.numbers(sample).into_iter().filter(|x| !x.is_nan());
            let texts = [name.to_owned(), unit.to_owned()];
            texts.into_iter().chain(numbers.map(move |x| significant(x, digits)))
        };
        TextTable::new(2, [""; 0], self.columns.iter().map(line)).aligned()
    }
}

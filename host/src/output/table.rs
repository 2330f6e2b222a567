//! Table of texts, as aligned columns or in Markdown.

use super::text;
use comfy_table::{CellAlignment, Row, presets::NOTHING};
use serde_json::Value;
use std::iter::once;

/// Column: name of a value, heading, and text of a number.
pub type Column<'a> = (&'a str, &'a str, fn(f64) -> String);

/// Lines of texts.
pub struct TextTable {
    /// Lines, of which the first may be a header.
    pub lines: Vec<Vec<String>>,
    /// Number of columns that are aligned to the left.
    pub left: usize,
}

impl TextTable {
    /// Columns of records below their headings. An absent value is a dash. The first columns are aligned to the left as long as they
    /// contain words.
    pub fn new(records: &[Value], columns: &[Column<'_>]) -> Self {
        let line = |record: &Value| {
            let cell = |(name, _, of_number): &Column<'_>| text(&record[*name], *of_number);
            columns.iter().map(|column| cell(column).unwrap_or_else(|| "-".to_owned())).collect()
        };
        let header = columns.iter().map(|(_, heading, _)| (*heading).to_owned()).collect();
        let lines = once(header).chain(records.iter().map(line)).collect();
        let is_word = |(name, ..): &&Column<'_>| records.iter().all(|record| record[*name].is_string());
        Self { lines, left: columns.iter().take_while(is_word).count() }
    }

    /// All values of records, with their names as headings.
    pub fn of_all(records: &[Value], of_number: fn(f64) -> String) -> Self {
        let names = records.iter().take(1).filter_map(Value::as_object).flat_map(|record| record.keys());
        Self::new(records, &names.map(|name| (&**name, &**name, of_number)).collect::<Vec<_>>())
    }

    /// Aligned columns without rules.
    pub fn aligned(self) -> String {
        let mut table = comfy_table::Table::new();
        table.load_style(NOTHING).add_rows(self.lines.into_iter().map(Row::from));
        for (index, column) in table.column_iter_mut().enumerate() {
            column.set_padding((0, 2));
            let is_left = index < self.left;
            column.set_cell_alignment(if is_left { CellAlignment::Left } else { CellAlignment::Right });
        }
        table.lines().map(|line| format!("{}\n", line.trim_end())).collect()
    }

    /// Table in Markdown, whose first line is the header. Columns of numbers are aligned to the right, and whole numbers are grouped.
    pub fn markdown(&self) -> String {
        let Some((header, lines)) = self.lines.split_first() else { return String::new() };
        let is_number = |cell: &String| cell == "-" || cell.parse::<f64>().is_ok();
        let rule = |column| {
            let are_numbers = lines.iter().all(|line| line.get(column).is_some_and(is_number));
            if are_numbers { "--:" } else { "---" }.to_owned()
        };
        let row = |cells: Vec<String>, space: &str| {
            format!("|{space}{}{space}|\n", cells.join(&format!("{space}|{space}")))
        };
        let body = lines.iter().map(|line| row(line.iter().map(|cell| grouped(cell)).collect(), " "));
        row(header.clone(), " ") + &row((0..header.len()).map(rule).collect(), "") + &body.collect::<String>()
    }
}

/// Whole number with spaces between groups of three digits: 12345 is "12 345". Other words remain as they are.
fn grouped(number: &str) -> String {
    if !number.bytes().all(|digit| digit.is_ascii_digit()) {
        return number.to_owned();
    }
    let mut text = String::new();
    for (index, digit) in number.chars().enumerate() {
        if index > 0 && (number.len() - index).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_numbers_are_aligned_to_the_right() {
        let rows = [["what", "cycles", "error"], ["a tick", "12345", "1e-9"], ["999", "-", "none"]];
        let lines = rows.map(|row| row.map(str::to_owned).to_vec()).into();
        let text = TextTable { lines, left: 0 }.markdown();
        assert_eq!(
            text,
            "| what | cycles | error |\n|---|--:|---|\n| a tick | 12 345 | 1e-9 |\n| 999 | - | none |\n"
        );
        assert_eq!(["1234", "123456789", "1.5", ""].map(grouped), ["1 234", "123 456 789", "1.5", ""]);
    }
}

//! Table of texts, as aligned columns or in Markdown.

use comfy_table::{CellAlignment, Row, presets::NOTHING};
use serde::Serialize;
use serde_json::Value;
use toytop_host::output::{fields, significant, text};

/// Rows of texts below a header.
pub struct TextTable {
    /// Header, if there is one, and rows.
    pub lines: Vec<Vec<String>>,
    /// Number of columns that are aligned to the left.
    left: usize,
}

impl TextTable {
    /// Rows below a header, or without one if it is empty; the first `left` columns are aligned to the left.
    pub fn new<H: Into<String>, C: Into<String>>(
        left: usize,
        header: impl IntoIterator<Item = H>,
        rows: impl IntoIterator<Item: IntoIterator<Item = C>>,
    ) -> Self {
        let header: Vec<_> = header.into_iter().map(H::into).collect();
        let rows = rows.into_iter().map(|row| row.into_iter().map(C::into).collect());
        Self {
            lines: Some(header).filter(|header| !header.is_empty()).into_iter().chain(rows).collect(),
            left,
        }
    }

    /// Table with one column for each field, headed by the field's name. Numbers have `digits` significant digits; `-` is an absent
    /// value. The first columns of words are aligned to the left.
    pub fn of_fields(rows: &[impl Serialize], digits: usize) -> Self {
        let rows: Vec<_> = rows.iter().map(fields).collect();
        let header = rows.iter().take(1).flatten().map(|(name, _)| name);
        let is_word = |column: &usize| rows.iter().all(|row| row[*column].1.is_string());
        let left = (0..rows.first().map_or(0, Vec::len)).take_while(is_word).count();
        let number = |x| significant(x, digits);
        let cell = |(_, value): &(String, Value)| text(value, number).unwrap_or_else(|| "-".to_owned());
        Self::new(left, header, rows.iter().map(|row| row.iter().map(cell)))
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
        let text = TextTable::new(0, [""; 0], rows).markdown();
        assert_eq!(
            text,
            "| what | cycles | error |\n|---|--:|---|\n| a tick | 12 345 | 1e-9 |\n| 999 | - | none |\n"
        );
        assert_eq!(["1234", "123456789", "1.5", ""].map(grouped), ["1 234", "123 456 789", "1.5", ""]);
    }
}

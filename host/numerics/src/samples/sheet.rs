//! Rows of chosen columns as CSV, JSON or an aligned table.

use super::column::Column;
use crate::input::scenario::Units;
use crate::motion::propagate::Sample;
use crate::output::{self, digits, number};
use toytop::Support;

/// Columns of the rows, and the units of their numbers.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Columns in their order.
    pub columns: Vec<Column>,
    /// Units of the scenario.
    pub units: Units,
    /// Support of the tip, which decides the unit of its position.
    pub support: Support,
    /// Whether the names of CSV columns end in units.
    pub named_units: bool,
}

impl Sheet {
    /// Names of all numbers of a row.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let name = |column: &Column, name: &&str| match column.unit(self.units, self.support) {
            unit if self.named_units && !unit.is_empty() => format!("{name} [{unit}]"),
            _ => (*name).to_owned(),
        };
        let of_column =
            |column: &Column| column.names().iter().map(|part| name(column, part)).collect::<Vec<_>>();
        self.columns.iter().flat_map(of_column).collect()
    }

    /// Numbers of a row; NaN stands for a number that does not exist.
    pub fn numbers(&self, sample: &Sample, numbers: &mut Vec<f64>) {
        numbers.clear();
        self.columns.iter().for_each(|column| column.push(sample, numbers));
    }

    /// Header of CSV.
    #[must_use]
    pub fn csv_header(&self) -> String {
        self.names().join(",") + "\n"
    }

    /// Appends a line of CSV.
    pub fn csv(&self, sample: &Sample, numbers: &mut Vec<f64>, text: &mut Vec<u8>) {
        self.numbers(sample, numbers);
        for (index, x) in numbers.iter().enumerate() {
            if index > 0 {
                text.push(b',');
            }
            if !x.is_nan() {
                digits::push(text, *x);
            }
        }
        text.push(b'\n');
    }

    /// Appends an object of JSON.
    pub fn json(&self, sample: &Sample, numbers: &mut Vec<f64>, text: &mut Vec<u8>) {
        for (index, column) in self.columns.iter().enumerate() {
            text.extend_from_slice(if index == 0 { b"{\"" } else { b",\"" });
            text.extend_from_slice(column.key().as_bytes());
            text.extend_from_slice(b"\":");
            numbers.clear();
            column.push(sample, numbers);
            let several = column.names().len() > 1;
            for (index, x) in numbers.iter().enumerate() {
                if several {
                    text.push(if index == 0 { b'[' } else { b',' });
                }
                if x.is_nan() {
                    text.extend_from_slice(b"null");
                } else {
                    digits::push(text, *x);
                }
            }
            if several {
                text.push(b']');
            }
        }
        text.push(b'}');
    }

    /// Sample as a block of lines, because one line with all digits would be too long for a screen.
    #[must_use]
    pub fn block(&self, sample: &Sample) -> String {
        let most = self.columns.iter().map(|column| column.names().len()).max().unwrap_or(0);
        let line = |column: &Column| {
            let mut numbers = Vec::new();
            column.push(sample, &mut numbers);
            let unit = column.unit(self.units, self.support).to_owned();
            let mut line = vec![column.key().to_owned(), unit];
            line.extend(numbers.into_iter().filter(|x| !x.is_nan()).map(number));
            line.resize(2 + most, String::new());
            line
        };
        output::columns(self.columns.iter().map(line).collect(), 2)
    }
}

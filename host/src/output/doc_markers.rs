//! Parts of a page that a command writes, between the lines `<!-- toytop COMMAND: NAME -->` and `<!-- end of NAME -->`. The rest of the
//! page does not change.

use crate::Failure;
use crate::input::text_file;
use crate::output::whole_file;
use std::path::{Path, PathBuf};

/// Page with a part that a command writes.
pub struct Page {
    path: PathBuf,
    /// Text up to the first line of the mark, and from the last one on.
    around: [String; 2],
}

impl Page {
    /// Page of a file, with a part at a mark `toytop COMMAND: NAME`.
    ///
    /// # Errors
    /// [`Failure::Input`], with `--accept` in front: the page cannot be read, is larger than 16 MiB, or does not contain the lines.
    pub fn read(path: &Path, mark: &str) -> Result<Self, Failure> {
        let place = format!("--accept: {}", path.display());
        let text = text_file::read(&place, path, 16)?;
        let name = mark.split_once(": ").map_or(mark, |(_, name)| name);
        let [begin, end] = [format!("<!-- {mark} -->\n"), format!("<!-- end of {name} -->\n")];
        let found = text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?)));
        let (before, (_, after)) = found.ok_or_else(|| {
            Failure::Input(format!("{place}: must hold the lines {} and {}", begin.trim(), end.trim()))
        })?;
        Ok(Self { path: path.to_owned(), around: [before.to_owned() + &begin, end + after] })
    }

    /// Writes the page with this part.
    ///
    /// # Errors
    /// The failures of [`whole_file::write`].
    pub fn write(&self, part: &str) -> Result<(), Failure> {
        let [before, after] = &self.around;
        whole_file::write("--accept", &self.path, [before, part, after].concat().as_bytes())
    }
}

/// Table in Markdown, whose first row is the header. Columns of numbers are aligned to the right, and whole numbers are grouped.
pub fn table(rows: &[Vec<String>]) -> String {
    let Some((header, rows)) = rows.split_first() else { return String::new() };
    let is_number = |cell: &String| cell == "-" || cell.parse::<f64>().is_ok();
    let rule = |column| {
        let are_numbers = rows.iter().all(|row| row.get(column).is_some_and(is_number));
        if are_numbers { "--:" } else { "---" }.to_owned()
    };
    let line = |cells: Vec<String>, space: &str| {
        format!("|{space}{}{space}|\n", cells.join(&format!("{space}|{space}")))
    };
    line(header.clone(), " ")
        + &line((0..header.len()).map(rule).collect(), "")
        + &rows
            .iter()
            .map(|row| line(row.iter().map(|cell| grouped(cell)).collect(), " "))
            .collect::<String>()
}

/// Whole number with spaces between groups of three digits: 12345 is "12 345". Other words remain as they are.
pub fn grouped(number: &str) -> String {
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
        let text = table(&rows.map(|row| row.map(str::to_owned).to_vec()));
        assert_eq!(
            text,
            "| what | cycles | error |\n|---|--:|---|\n| a tick | 12 345 | 1e-9 |\n| 999 | - | none |\n"
        );
        assert_eq!(["1234", "123456789", "1.5", ""].map(grouped), ["1 234", "123 456 789", "1.5", ""]);
    }
}

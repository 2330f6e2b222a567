//! Parts of a page that a command writes, between the lines `<!-- toytop COMMAND: NAME -->` and `<!-- end of NAME -->`. The rest of the
//! page does not change.

use crate::Failure;

use crate::output::whole_file;
use std::path::Path;

/// Lines of a mark `toytop COMMAND: NAME`, which begin and end the part.
fn lines(mark: &str) -> [String; 2] {
    let name = mark.split_once(": ").map_or(mark, |(_, name)| name);
    [format!("<!-- {mark} -->\n"), format!("<!-- end of {name} -->\n")]
}

/// Text with this body between the lines of the mark.
///
/// # Errors
/// [`Failure::Input`]: the text does not contain the lines.
pub fn with(text: &str, mark: &str, body: &str) -> Result<String, Failure> {
    let [begin, end] = lines(mark);
    replaced(text, [&begin, &end], &format!("\n{body}\n"))
        .ok_or_else(|| Failure::Input(format!("must hold the lines {} and {}", begin.trim(), end.trim())))
}

/// Text with this part between two markers, which remain; `None` if the text does not contain both.
#[must_use]
pub fn replaced(text: &str, [begin, end]: [&str; 2], part: &str) -> Option<String> {
    let (before, rest) = text.split_once(begin)?;
    let (_, after) = rest.split_once(end)?;
    Some(format!("{before}{begin}{part}{end}{after}"))
}

/// Check that the page can be written, before a computation that takes long.
///
/// # Errors
/// As [`write()`].
pub fn check(path: &Path, option: &str, mark: &str) -> Result<(), Failure> {
    with(&read(path, option)?, mark, "").map(|_| ()).map_err(|error| named(error, option, path))
}

/// Writes this body into a page, between the lines of the mark.
///
/// # Errors
/// [`Failure::Input`], with the option that named the page: it cannot be read or written, or does not contain the lines.
pub fn write(path: &Path, option: &str, mark: &str, body: &str) -> Result<(), Failure> {
    let page = with(&read(path, option)?, mark, body).map_err(|error| named(error, option, path))?;
    whole_file::write(option, path, page.as_bytes())
}

/// Size of the largest page, MiB.
const LARGEST_PAGE: u64 = 16;

fn read(path: &Path, option: &str) -> Result<String, Failure> {
    whole_file::read(&format!("{option}: {}", path.display()), path, LARGEST_PAGE)
}

fn named(error: Failure, option: &str, path: &Path) -> Failure {
    error.of(&format!("{option}: {}", path.display()))
}

/// Table in Markdown, whose first row is the header. Columns of numbers are aligned to the right, and whole numbers are grouped.
#[must_use]
pub fn table(rows: &[Vec<String>]) -> String {
    let Some((header, rows)) = rows.split_first() else { return String::new() };
    let is_number = |cell: &String| cell == NO_FIGURE || cell.parse::<f64>().is_ok();
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

/// Cell of a figure that is not known.
pub const NO_FIGURE: &str = "-";

/// Whole number with spaces between groups of three digits: 12345 is "12 345". Other words remain as they are.
#[must_use]
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

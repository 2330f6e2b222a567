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

/// Table in Markdown, whose first row is the header.
pub fn table(rows: &[Vec<String>]) -> String {
    let line = |cells: &Vec<String>| format!("| {} |\n", cells.join(" | "));
    let Some((header, rows)) = rows.split_first() else { return String::new() };
    let rule = "|---".repeat(header.len()) + "|\n";
    line(header) + &rule + &rows.iter().map(line).collect::<String>()
}

//! Tables between markers: `<!-- toytop report: NAME -->` and `<!-- end of NAME -->`, each on a line of its own.

use super::Table;
use crate::Failure;

/// The text with these tables in their places.
pub(super) fn with(text: &str, tables: &[(&str, Table)]) -> Result<String, Failure> {
    tables.iter().try_fold(text.to_owned(), |text, (name, table)| {
        let [begin, end] = [format!("<!-- toytop report: {name} -->\n"), format!("<!-- end of {name} -->\n")];
        let parts =
            text.split_once(&begin).and_then(|(before, rest)| Some((before, rest.split_once(&end)?.1)));
        let Some((before, after)) = parts else {
            return Err(Failure::Input(format!("must hold the lines {} and {}", begin.trim(), end.trim())));
        };
        Ok(format!("{before}{begin}\n{}\n{end}{after}", markdown(table)))
    })
}

fn markdown(table: &Table) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = "|---".repeat(table.header.len()) + "|\n";
    let rows: String = table.rows.iter().map(|row| line(row)).collect();
    line(&table.header) + &rule + &rows
}

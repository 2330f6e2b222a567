//! The tables of a page, each at its mark.

use super::Table;
use toytop_host::Failure;
use toytop_host::output::doc_markers;

/// The text with these tables in their places.
pub(super) fn with(text: &str, tables: &[(&str, Table)]) -> Result<String, Failure> {
    tables.iter().try_fold(text.to_owned(), |text, (name, Table { header, rows })| {
        let lines: Vec<_> = std::iter::once(header).chain(rows).cloned().collect();
        doc_markers::with(&text, &format!("toytop-lab report: {name}"), &doc_markers::table(&lines))
    })
}

//! Tables of a page, each between its markers.

use super::Table;
use toytop_host::Failure;
use toytop_host::output::doc_markers;

/// Text with these tables between their markers.
pub(super) fn with(text: &str, tables: &[(&str, Table)]) -> Result<String, Failure> {
    tables.iter().try_fold(text.to_owned(), |text, (name, Table { header, rows })| {
        let lines: Vec<_> = std::iter::once(header).chain(rows).cloned().collect();
        doc_markers::with(&text, &format!("toytop-lab report: {name}"), &doc_markers::table(&lines))
    })
}

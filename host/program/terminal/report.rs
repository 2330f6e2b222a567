//! Report of a command.

use crate::files::file_or_stdout::write_stdout;
use std::io::{self, Write};
use std::process::ExitCode;
use toytop_host::Failure;

/// Report of a command.
#[derive(Default)]
pub struct Report {
    /// Text for stdout.
    pub text: String,
    /// Lines for stderr.
    pub notes: Vec<String>,
    /// Whether the exit code is 1 after the result is printed.
    pub check_failed: bool,
}

impl From<String> for Report {
    fn from(text: String) -> Self {
        Self { text, ..Self::default() }
    }
}

impl Report {
    /// Report with notes on the result.
    pub fn with_notes(mut self, notes: impl IntoIterator<Item = String>) -> Self {
        self.notes.extend(notes);
        self
    }
}

/// Prints a report. Returns the exit code.
pub(super) fn print(report: Report) -> Result<ExitCode, Failure> {
    if !report.text.is_empty() {
        write_stdout(|out| out.write_all(report.text.as_bytes()))?;
    }
    for note in &report.notes {
        let _ = writeln!(io::stderr(), "{note}");
    }
    Ok(ExitCode::from(u8::from(report.check_failed)))
}

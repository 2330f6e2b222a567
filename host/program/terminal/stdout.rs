//! Report of a command, and its way to standard output.

use crate::files::whole_file;
use std::io::{self, Write};
use std::path::Path;
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
        write(|out| out.write_all(report.text.as_bytes()))?;
    }
    for note in &report.notes {
        let _ = writeln!(io::stderr(), "{note}");
    }
    Ok(ExitCode::from(u8::from(report.check_failed)))
}

/// Writes to stdout. A reader that closes it early (`| head`) is no failure.
///
/// # Errors
/// [`Failure::Output`]: the error of `fill`.
fn write(fill: impl FnOnce(&mut io::Stdout) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::stdout();
    match fill(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Output(error)),
        _ => Ok(()),
    }
}

/// Writes the complete file of `--output`, or stdout where the path is `-` or absent.
///
/// # Errors
/// The failures of [`whole_file::write_by`], or [`Failure::Output`]: the error of `fill` on stdout.
pub fn write_or_file(
    path: Option<&Path>,
    fill: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        Some(path) if path.as_os_str() != "-" => whole_file::write_by("--output", path, |file| fill(file)),
        _ => write(|out| fill(out)),
    }
}

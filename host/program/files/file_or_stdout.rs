//! Output of a command: the file of `--output`, or standard output.

use super::whole_file;
use std::io::{self, Write};
use std::path::Path;
use toytop_host::Failure;

/// Writes to stdout. A reader that closes it early (`| head`) is no failure.
///
/// # Errors
/// [`Failure::output`]: the error of `fill`.
pub fn write_stdout(fill: impl FnOnce(&mut io::Stdout) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::stdout();
    match fill(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::output(error)),
        _ => Ok(()),
    }
}

/// Writes the complete file of `--output`, or stdout where the path is `-` or absent.
///
/// # Errors
/// The failures of [`whole_file::write_by`], or [`Failure::output`]: the error of `fill` on stdout.
pub fn write(
    path: Option<&Path>,
    fill: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        Some(path) if path.as_os_str() != "-" => whole_file::write_by("--output", path, |file| fill(file)),
        _ => write_stdout(|out| fill(out)),
    }
}

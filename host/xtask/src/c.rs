//! Crate for programs in C, `core/c`: its archives, its header, and its examples.

mod archive;
mod examples;
mod header;

use std::path::Path;
use std::process::Command;

pub(crate) use archive::{list, make};
pub(crate) use examples::{cmake as check_cmake, on_chip as check_on_chip, on_host as check_on_host};
pub(crate) use header::check as check_header;

const WARNINGS: [&str; 6] = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"];

/// Command that compiles in a standard, with warnings as errors.
fn compile(compiler: &str, standard: &str, include: &Path) -> Command {
    let mut command = Command::new(compiler);
    command.arg(format!("-std={standard}")).args(WARNINGS).arg("-I").arg(include);
    command
}

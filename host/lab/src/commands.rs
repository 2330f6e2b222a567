//! One file a command. A command returns its whole output; nothing is printed before all of it is there.

mod longrun;
mod overflow;
mod report;
mod sines;
mod study;

use crate::cli::Command;
use toytop_host::{Failure, Report};

/// Runs a command.
///
/// # Errors
/// See [`Failure`].
pub fn run(command: &Command) -> Result<Report, Failure> {
    match command {
        Command::Study(arguments) => study::run(arguments),
        Command::Longrun(arguments) => longrun::run(arguments),
        Command::Sines(arguments) => sines::run(arguments),
        Command::Overflow(arguments) => overflow::run(arguments),
        Command::Report(arguments) => report::run(arguments),
    }
}

//! Commands of `toytop-lab`, one file for each. A command returns its whole output, and nothing is printed before it is complete.

mod longrun;
mod overflow;
mod report;
mod sines;
mod study;

use crate::cli::Command;
use toytop_host::{Failure, Report};

/// Report of a command.
///
/// # Errors
/// See [`Failure`].
pub(crate) fn run(command: &Command) -> Result<Report, Failure> {
    match command {
        Command::Study(arguments) => study::run(arguments),
        Command::Longrun(arguments) => longrun::run(arguments),
        Command::Sines(arguments) => sines::run(arguments),
        Command::Overflow(arguments) => overflow::run(arguments),
        Command::Report(arguments) => report::run(arguments),
    }
}

//! Parser of the command line, and the exit code. Help and refusals are printed like the report of a command.

use super::report::{Report, print};
use clap::error::ErrorKind;
use clap::{Arg, ArgMatches, Command};
use std::io::{self, Write};
use std::process::ExitCode;
use toytop_host::Failure;

/// Parses the command line of the process, runs the command and prints its report or its failure. Returns the exit code.
pub fn run(command: Command, execute: impl FnOnce(&ArgMatches) -> Result<Report, Failure>) -> ExitCode {
    match parsed(command, execute).and_then(print) {
        Ok(code) => code,
        Err(failure) => {
            // if stderr is closed, the message cannot be shown
            let _ = writeln!(io::stderr(), "error: {failure}");
            ExitCode::from(failure.kind as u8)
        }
    }
}

/// Report of the command on the command line. Help and version are reports too.
///
/// # Errors
/// [`Failure::input`] for everything that clap refuses, and the failures of the command.
fn parsed(
    command: Command,
    execute: impl FnOnce(&ArgMatches) -> Result<Report, Failure>,
) -> Result<Report, Failure> {
    let error = match with_negative_numbers(command).try_get_matches() {
        Ok(matches) => return execute(&matches),
        Err(error) => error,
    };
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => Ok(error.render().to_string().into()),
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            Err(Failure::input("no command given; see toytop --help"))
        }
        _ => Err(Failure::input(in_one_line(&error.render().to_string()))),
    }
}

/// Command whose options take negative numbers as values.
fn with_negative_numbers(command: Command) -> Command {
    let takes_one = |argument: &Arg| !argument.is_positional() && argument.get_action().takes_values();
    command
        .mut_args(
            |argument| if takes_one(&argument) { argument.allow_negative_numbers(true) } else { argument },
        )
        .mut_subcommands(with_negative_numbers)
}

/// Message of clap in one line: its first paragraph and its suggestion.
fn in_one_line(message: &str) -> String {
    let paragraph = message.lines().take_while(|line| !line.trim().is_empty());
    let line = paragraph.map(str::trim).collect::<Vec<_>>().join(" ");
    let meant = message
        .lines()
        .find_map(|line| line.trim().strip_prefix("tip: ").filter(|tip| tip.contains("similar")));
    let meant = meant.map(|tip| format!("; {tip}")).unwrap_or_default();
    line.trim_start_matches("error: ").to_owned() + &meant
}

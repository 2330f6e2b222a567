//! Frame of a program with commands, from its arguments to its exit code.

use crate::output::stdout;
use crate::{Failure, Report};
use clap::error::ErrorKind;
use clap::{Arg, Command, Parser};
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

/// Report of `run`, or the help or the version that the command line asks for; it begins with the program's name.
///
/// # Errors
/// [`Failure::Input`] for everything that clap refuses, and the failures of `run`.
pub fn report<C: Parser>(
    arguments: impl IntoIterator<Item = OsString>,
    run: impl FnOnce(&C) -> Result<Report, Failure>,
) -> Result<Report, Failure> {
    let parsed = with_negative_numbers(C::command())
        .try_get_matches_from(arguments)
        .and_then(|matches| C::from_arg_matches(&matches));
    let error = match parsed {
        Ok(cli) => return run(&cli),
        Err(error) => error,
    };
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => Ok(error.render().to_string().into()),
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            Err(Failure::Input(format!("no command given; see {} --help", C::command().get_name())))
        }
        _ => Err(Failure::Input(in_one_line(&error.render().to_string()))),
    }
}

/// Command whose options take negative numbers as values, so that the check of their range refuses them, and not as other options.
fn with_negative_numbers(command: Command) -> Command {
    let takes_one = |argument: &Arg| !argument.is_positional() && argument.get_action().takes_values();
    command
        .mut_args(
            |argument| if takes_one(&argument) { argument.allow_negative_numbers(true) } else { argument },
        )
        .mut_subcommands(with_negative_numbers)
}

/// Message of clap in one line: its first paragraph, which names the error and the allowed values, and its suggestion.
fn in_one_line(message: &str) -> String {
    let paragraph = message.lines().take_while(|line| !line.trim().is_empty());
    let line = paragraph.map(str::trim).collect::<Vec<_>>().join(" ");
    let meant = message
        .lines()
        .find_map(|line| line.trim().strip_prefix("tip: ").filter(|tip| tip.contains("similar")));
    let meant = meant.map(|tip| format!("; {tip}")).unwrap_or_default();
    line.trim_start_matches("error: ").to_owned() + &meant
}

/// Exit code, after the report or the failure of a command is printed.
pub fn finish(result: Result<Report, Failure>) -> ExitCode {
    match result.and_then(|report| print(&report)) {
        Ok(code) => code,
        Err(failure) => {
            // if stderr is closed, the message cannot be shown
            let _ = writeln!(io::stderr(), "error: {failure}");
            ExitCode::from(failure.exit_code())
        }
    }
}

/// Exit code after the report is printed. Everything was computed before, so the output is complete.
fn print(report: &Report) -> Result<ExitCode, Failure> {
    for note in &report.notes {
        let _ = writeln!(io::stderr(), "{note}");
    }
    if !report.text.is_empty() {
        stdout::require_open().map_err(Failure::Output)?;
    }
    let mut stdout = io::stdout().lock();
    match stdout.write_all(report.text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Output(error)),
        // a reader that closes the pipe (`| head`) is no failure
        _ => Ok(ExitCode::from(u8::from(report.missed))),
    }
}

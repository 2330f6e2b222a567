//! Program `toytop`: parses the command line, runs the command, prints its report and returns the exit code.

// Visibility is that of the modules.
#![allow(unreachable_pub)]

mod commands;

use clap::Parser;
use commands::Command;
use std::process::ExitCode;
use toytop_host::terminal;

/// Exact motion of a spinning top whose tip slides on a plane or is held, or of a free body.
#[derive(Parser)]
#[command(
    name = "toytop",
    version,
    help_template = "{about}\n{usage-heading} {usage}; each command has --help, and toytop has --version\n\nCommands:\n{subcommands}\n\n\
        Checks of toytop itself: accuracy bench budget errata figures\n"
)]
struct Cli {
    /// Command to run.
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    terminal::command_line::run(|cli: &Cli| cli.command.run())
}

//! Program `toytop`: parses the command line, runs the command, prints its report and returns the exit code.

use std::process::ExitCode;
use toytop_host::{cli, output::stdout};

fn main() -> ExitCode {
    stdout::finish(cli::run(std::env::args_os()))
}

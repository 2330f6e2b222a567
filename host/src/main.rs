//! Program `toytop`: parses the command line, runs the command, prints its report and returns the exit code.

use std::process::ExitCode;
use toytop_host::{program, run};

fn main() -> ExitCode {
    program::finish(run(std::env::args_os()))
}

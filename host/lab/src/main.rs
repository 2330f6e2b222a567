//! Program `toytop-lab`: parses the command line, runs the command, prints its report and returns the exit code.

use std::process::ExitCode;
use toytop_host::output::stdout;
use toytop_lab::run;

fn main() -> ExitCode {
    stdout::finish(run(std::env::args_os()))
}

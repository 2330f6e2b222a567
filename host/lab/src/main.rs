//! `toytop-lab`: parse, run, print, exit code.

use std::process::ExitCode;
use toytop_host::program;
use toytop_lab::run;

fn main() -> ExitCode {
    program::finish(run(std::env::args_os()))
}

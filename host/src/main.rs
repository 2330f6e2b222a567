//! `toytop`: parse, run, print, exit code.

use std::process::ExitCode;
use toytop_host::{program, run};

fn main() -> ExitCode {
    program::finish(run(std::env::args_os()))
}

//! Program `toytop`: parses the command line, runs the command, prints its report and returns the exit code.
//!
//! | module | contents |
//! |---|---|
//! | `files` | files that a command writes: completely or not at all, and pages of the documentation |
//! | `terminal` | command line, standard output, progress, rows that all processor cores compute |
//! | `table` | table of texts |
//! | `values`, `times` | values of one number; times at which a motion is computed |
//! | `commands` | the commands |

// A private module limits the visibility of what it declares `pub`.
#![allow(unreachable_pub)]

mod files {
    pub mod whole_file;

    pub mod doc_page;
}
mod terminal {
    pub mod parallel_rows;
    pub mod progress;
    pub mod stdout;

    pub mod command_line;
}

mod table;

mod values;

mod times;

mod commands;

use std::process::ExitCode;

fn main() -> ExitCode {
    terminal::command_line::run(commands::toytop(), commands::run)
}

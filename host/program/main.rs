//! Program `toytop`: parses the command line, runs the command, prints its report and returns the exit code.
//!
//! | module | contents |
//! |---|---|
//! | `files` | files written completely or not at all |
//! | `terminal` | command line, standard output, progress |
//! | `table` | table of texts |
//! | `values`, `times` | values of one number; times at which a motion is computed |
//! | `drawing` | drawings as SVG, PNG and GIF |
//! | `commands` | the commands |

// A private module limits the visibility of what it declares `pub`.
#![allow(unreachable_pub)]

mod files;
mod terminal;

mod table;

mod values;

mod times;

mod drawing;

mod commands;

use std::process::ExitCode;

fn main() -> ExitCode {
    terminal::command_line::run(commands::toytop(), commands::run)
}

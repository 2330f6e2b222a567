//! Program `toytop`: parses the command line, runs the command, prints its report and returns the exit code.
//!
//! | module | contents |
//! |---|---|
//! | `files` | whole-file writes, the output of `-o`, generated parts of the documentation |
//! | `drawing` | frames, colours, texts, dots and lines of pictures |
//! | `terminal` | command line, report, tables of texts, parallel work with a progress bar |
//! | `arguments` | arguments of several commands: numbers and ranges, times, options |
//! | `commands` | the commands |

// All modules are private: `pub` means that the program sees it.
#![allow(unreachable_pub)]

mod files {
    pub mod whole_file;

    pub mod doc_page;
    pub mod file_or_stdout;
}
mod terminal {
    pub mod parallel;
    pub mod report;
    pub mod table;

    pub mod command_line;
}

mod drawing;

mod arguments {
    pub mod values;

    pub mod times;

    pub mod options;
}

mod commands;

use std::process::ExitCode;

fn main() -> ExitCode {
    let (command, run) = commands::toytop();
    terminal::command_line::run(command, run)
}

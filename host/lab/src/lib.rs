//! Studies that check `toytop` itself, and the pages that show their results.
//!
//! | module | contents |
//! |---|---|
//! | `study` | ephemerides of random motions against the truth and their bounds |
//! | `longrun` | steppers and cursors over very many ticks |
//! | `sines` | errors of the sines of an integer phase |
//! | [`overflow`] | fixed point for random motions in checked arithmetic |
//! | `cli`, `commands` | command line, one file for each command |

mod cli;
mod commands;
mod longrun;
pub mod overflow;
mod sines;
mod study;

use std::ffi::OsString;
use toytop_host::program::{self, Request};
use toytop_host::{Failure, Report};

/// Report of one command line, which begins with the program's name.
///
/// # Errors
/// See [`Failure`].
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<Report, Failure> {
    match program::parse::<cli::Cli>(arguments)? {
        Request::Show(text) => Ok(Report { text, ..Report::default() }),
        Request::Run(cli) => commands::run(&cli.command),
    }
}

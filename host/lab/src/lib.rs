//! Studies that check `toytop` itself, and the pages that show their results.
//!
//! | module | contents |
//! |---|---|
//! | [`study`] | ephemerides of random motions against the truth and their bounds |
//! | [`longrun`] | steppers and cursors over very many ticks |
//! | [`sines`] | sines of an integer phase, at every phase |
//! | [`overflow`] | fixed point on random motions in checked arithmetic |
//! | [`cli`], [`commands`] | command line, one file a command |

pub mod cli;
pub mod commands;
pub mod longrun;
pub mod overflow;
pub mod sines;
pub mod study;

use std::ffi::OsString;
use toytop_host::program::{self, Request};
use toytop_host::{Failure, Report};

/// Runs one command line (with the program's name in front).
///
/// # Errors
/// See [`Failure`].
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Result<Report, Failure> {
    match program::parse::<cli::Cli>(arguments)? {
        Request::Show(text) => Ok(Report { text, ..Report::default() }),
        Request::Run(cli) => commands::run(&cli.command),
    }
}

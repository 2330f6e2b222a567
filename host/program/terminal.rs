//! Terminal of a program: its command line, its output and its exit code.
//!
//! | module | contents |
//! |---|---|
//! | [`stdout`] | report of a command, and its way to standard output |
//! | [`progress`] | progress bar on stderr |
//! | [`parallel_rows`] | rows of a result, computed on all processor cores |
//! | [`command_line`] | parser of the command line, and exit code |

pub mod parallel_rows;
pub mod progress;
pub mod stdout;

pub mod command_line;

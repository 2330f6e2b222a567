//! The command that prints the catalogue of benchmark problems.

use super::Format;
use clap::Args;
use std::path::PathBuf;

/// `toytop benchmark`
#[derive(Args, Debug)]
pub(crate) struct BenchmarkArgs {
    /// Name of a problem; without it, all problems are listed
    pub(crate) name: Option<String>,
    /// Times, s, in place of the source's, with 17 digits in place of 30: T1,T2,... or LOW..HIGH/PLACES
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true, requires = "name")]
    pub(crate) times: Option<String>,
    /// Print the scenario file of the problem
    #[arg(long, requires = "name", conflicts_with_all = ["times", "format", "page"])]
    pub(crate) scenario: bool,
    /// Page whose tables are rewritten: the page of the problem, or without NAME that of the catalogue
    #[arg(long, value_name = "FILE", conflicts_with_all = ["times", "format"])]
    pub(crate) page: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

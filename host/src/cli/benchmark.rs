//! The command that prints the catalogue of benchmark problems.

use super::Format;
use clap::Args;
use std::path::PathBuf;

/// `toytop benchmark`
#[derive(Args, Debug)]
pub struct BenchmarkArgs {
    /// Problem; without it, a list of all
    pub name: Option<String>,
    /// Times instead of the source's, to 17 digits: T1,T2,... or LOW..HIGH/PLACES
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true, requires = "name")]
    pub times: Option<String>,
    /// Print the scenario file of the problem instead
    #[arg(long, requires = "name", conflicts_with_all = ["times", "format", "page"])]
    pub scenario: bool,
    /// Page whose tables are written anew: that of the problem, or that of all
    #[arg(long, value_name = "FILE", conflicts_with_all = ["times", "format"])]
    pub page: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

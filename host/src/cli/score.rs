//! The command that judges an integrator.

use super::Format;
use clap::Args;
use std::path::PathBuf;

/// `toytop score`
#[derive(Args, Debug)]
pub struct ScoreArgs {
    /// Scenario file; with --benchmark the first CSV file
    pub scenario: PathBuf,
    /// CSV files with an integrator's output for this scenario; several are several step sizes, or several methods
    #[arg(value_name = "RESULT.csv", required_unless_present = "benchmark")]
    pub results: Vec<PathBuf>,
    /// Problem of `toytop benchmark` instead of a scenario; the files are in the conventions of its source
    #[arg(long, value_name = "NAME")]
    pub benchmark: Option<String>,
    /// Step size of each file, s; without it, what the file states, or the spacing of its rows
    #[arg(long, value_name = "H1,H2,...", value_delimiter = ',', allow_hyphen_values = true, value_parser = super::measure::positive)]
    pub steps: Vec<f64>,
    /// Greatest error against work, as a picture: a file that ends in .svg, .png or (in a build with that feature) .pdf
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

//! Arguments of the command that compares an integrator with the exact motion.

use super::Format;
use clap::Args;
use std::path::PathBuf;

/// `toytop score`
#[derive(Args, Debug)]
pub(crate) struct ScoreArgs {
    /// Scenario file; with --benchmark, the first CSV file
    pub(crate) scenario: PathBuf,
    /// CSV files with the output of integrators for this scenario: one file for each step size and method
    #[arg(value_name = "RESULT.csv", required_unless_present = "benchmark")]
    pub(crate) results: Vec<PathBuf>,
    /// Problem of `toytop benchmark` that replaces the scenario; the files are in the conventions of its source
    #[arg(long, value_name = "NAME")]
    pub(crate) benchmark: Option<String>,
    /// Step size of each file, s; without it, the step size that the file states, or the spacing of its rows
    #[arg(long, value_name = "H1,H2,...", value_delimiter = ',', allow_hyphen_values = true, value_parser = super::measure::positive)]
    pub(crate) steps: Vec<f64>,
    /// Picture of the greatest error against the work, whose name ends in .svg, .png or, with the feature pdf, .pdf
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

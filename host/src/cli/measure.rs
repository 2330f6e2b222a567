//! Arguments of the commands that measure errors, costs and times.

use super::{Format, ScalarChoice};
use clap::Args;
use std::path::PathBuf;

/// `toytop compare`
#[derive(Args, Debug)]
pub struct CompareArgs {
    /// Scenario files; without any, the built-in motions are compared
    #[arg(value_name = "SCENARIO")]
    pub scenarios: Vec<PathBuf>,
    /// Nutation periods to compare over (for a motion without a period: times of 2 pi sqrt((A/p + s)/g))
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub periods: u32,
    /// Scalar types of the core
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    pub scalar: Vec<ScalarChoice>,
    /// Print one row for each run of the built-in motions, not one for each motion. CSV and JSON always contain every run
    #[arg(long)]
    pub all: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop figures`
#[derive(Args, Debug)]
pub(crate) struct FiguresArgs {
    /// Folder to write to, which is created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
}

/// `toytop bench`
#[derive(Args, Debug)]
pub(crate) struct BenchArgs {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

/// `toytop budget`
#[derive(Args, Debug)]
#[command(
    after_help = "Example: toytop budget --chip m4f,m0plus --clock 48\nNeeds QEMU (qemu-system-arm, qemu-system-misc) and, without --elf, the repository."
)]
pub(crate) struct BudgetArgs {
    /// Chips, separated by commas: m0plus, m4f, m7, m33, riscv; without it, all
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) chip: Vec<String>,
    /// Clock of the chip, MHz, from which times follow
    #[arg(long, value_name = "MHZ", default_value_t = 64.0, value_parser = positive)]
    pub(crate) clock: f64,
    /// ELF file of your own, whose functions named bench_... are measured
    #[arg(long, value_name = "FILE", conflicts_with_all = ["check", "accept"])]
    pub(crate) elf: Option<PathBuf>,
    /// Compare with firmware-examples/budgets.toml, and that file with the tables of host/docs/costs.md and README.md
    #[arg(long, conflicts_with = "accept")]
    pub(crate) check: bool,
    /// Measure all chips, and rewrite these files
    #[arg(long, conflicts_with = "chip")]
    pub(crate) accept: bool,
    /// Measure the set-up of 200 different launches: median and greatest cost on each chip; with --accept, on those with a model
    /// of their cycles, for the table in host/docs/costs.md
    #[arg(long, conflicts_with_all = ["elf", "check"])]
    pub(crate) corpus: bool,
    /// Compile for size (opt-level s) instead of speed
    #[arg(long, conflicts_with_all = ["elf", "check", "accept"])]
    pub(crate) size: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

/// Number above 0.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| *x > 0.0 && f64::is_finite(*x)).ok_or_else(|| "a number above 0".into())
}

/// `toytop errata`
#[derive(Args, Debug)]
pub(crate) struct ErrataArgs {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

/// `toytop accuracy`
#[derive(Args, Debug)]
pub(crate) struct AccuracyArgs {
    /// Scalar types
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    pub(crate) scalar: Vec<ScalarChoice>,
    /// Picture of error against cost, whose name ends in .svg, .png or, with the feature pdf, .pdf
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

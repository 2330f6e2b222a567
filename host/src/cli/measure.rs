//! Commands that measure the core and show what they found.

use super::{Format, ScalarChoice};
use clap::Args;
use std::path::PathBuf;

/// `toytop compare`
#[derive(Args, Debug)]
pub struct CompareArgs {
    /// Scenario files; none: the built-in motions
    #[arg(value_name = "SCENARIO")]
    pub scenarios: Vec<PathBuf>,
    /// Nutation periods to compare over (where there is no period: natural times of the top)
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub periods: u32,
    /// Scalar types of the core
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    pub scalar: Vec<ScalarChoice>,
    /// Every run of the built-in motions in a row of its own, as for scenario files; without it a row a motion. CSV and JSON always have every run
    #[arg(long)]
    pub all: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop figures`
#[derive(Args, Debug)]
pub struct FiguresArgs {
    /// Folder to write to; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
}

/// `toytop bench`
#[derive(Args, Debug)]
pub struct BenchArgs {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop budget`
#[derive(Args, Debug)]
#[command(
    after_help = "Example: toytop budget --chip m4f,m0plus --clock 48\nNeeds QEMU (qemu-system-arm, qemu-system-misc) and, without --elf, the repository."
)]
pub struct BudgetArgs {
    /// Chips: m0plus, m4f, m7, m33, riscv; none: all
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub chip: Vec<String>,
    /// Clock of the chip in MHz, for times
    #[arg(long, value_name = "MHZ", default_value_t = 64.0, value_parser = positive)]
    pub clock: f64,
    /// An ELF of your own: measures its functions named bench_...
    #[arg(long, value_name = "FILE", conflicts_with_all = ["check", "accept"])]
    pub elf: Option<PathBuf>,
    /// Compare with firmware-examples/budgets.toml and the tables of host/docs/costs.md and README.md
    #[arg(long, conflicts_with = "accept")]
    pub check: bool,
    /// Rewrite both, with all chips
    #[arg(long, conflicts_with = "chip")]
    pub accept: bool,
    /// Set-up of 200 different launches instead: median and greatest of each chip with a model of its cycles
    #[arg(long, conflicts_with_all = ["elf", "check", "accept"])]
    pub corpus: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// A number above 0.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| *x > 0.0 && f64::is_finite(*x)).ok_or_else(|| "a number above 0".into())
}

/// `toytop errata`
#[derive(Args, Debug)]
pub struct ErrataArgs {
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop accuracy`
#[derive(Args, Debug)]
pub struct AccuracyArgs {
    /// Scalar types
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "all")]
    pub scalar: Vec<ScalarChoice>,
    /// Error against cost, as a picture: a file that ends in .svg, .png or (in a build with that feature) .pdf
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

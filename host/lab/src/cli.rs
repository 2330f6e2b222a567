//! Command line of `toytop-lab`.

use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use toytop_host::cli::Format;

/// Studies that check toytop itself, and write the pages that show the results.
#[derive(Debug, Parser)]
#[command(name = "toytop-lab", version)]
pub(crate) struct Cli {
    /// Command of the program.
    #[command(subcommand)]
    pub command: Command,
}

/// Command with its arguments.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Errors of the ephemeris for random motions of every regime, beside its error bounds (exit code 1 if one is exceeded)
    #[command(
        after_help = "Example: toytop-lab study --motions 5000 --seed 2\n         toytop-lab study --corners --seeds 20 --motions 20000 --truths 1000 --docs host/docs/study.md"
    )]
    Study(StudyArgs),
    /// Errors of steppers and cursors over 10^9 ticks, forward and back, and of the full solver
    #[command(after_help = "Example: toytop-lab longrun --ticks 10000000 --format csv")]
    Longrun(LongrunArgs),
    /// Greatest errors of the sines of an integer phase over all 2^32 phases
    #[command(
        after_help = "Example: toytop-lab sines --format json\n         toytop-lab sines --every 4099   a million phases, in less than a second"
    )]
    Sines(SinesArgs),
    /// Test that fixed point does not overflow for random motions, in a build that checks every sum (exit code 1 if one overflows)
    #[command(
        after_help = "Example: toytop-lab overflow --motions 100000\nSums are checked in a build of: cargo run --release --config profile.release.overflow-checks=true -p toytop-lab -- overflow"
    )]
    Overflow(OverflowArgs),
    /// Page with accuracy, work against precision, and figures; or the tables of host/docs/accuracy.md
    #[command(after_help = "Example: toytop-lab report -o report")]
    Report(ReportArgs),
}

/// `toytop-lab overflow`
#[derive(Args, Debug)]
pub(crate) struct OverflowArgs {
    /// Number of motions
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: u64,
    /// Number of ticks of each motion, in 32 and in 16 bits
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub ticks: u32,
    /// Seed of the random motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

/// `toytop-lab study`
#[derive(Args, Debug)]
pub(crate) struct StudyArgs {
    /// Number of motions of each seed [default: 100000; with --corners 1000000; with --fit 10000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: Option<u64>,
    /// Seed of the random motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Number of consecutive seeds from this one, each with a row of its own
    #[arg(long, value_name = "N", default_value_t = 1, requires = "corners", value_parser = clap::value_parser!(u64).range(1..=10_000))]
    pub seeds: u64,
    /// Random launches near every degenerate case, from branch points and from states, in four scalars
    #[arg(long)]
    pub corners: bool,
    /// Simulated launches, fitted to samples of three sets of sensors (exit code 1 if a wrong launch is not refused)
    #[arg(long, conflicts_with = "corners")]
    pub fit: bool,
    /// Number of launches of each seed that are compared with the truth
    #[arg(long, value_name = "N", default_value_t = 10_000, requires = "corners", value_parser = clap::value_parser!(u64).range(1..))]
    pub truths: u64,
    /// Markdown page whose tables are rewritten, with --corners or --fit
    #[arg(long, value_name = "FILE")]
    pub docs: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

impl StudyArgs {
    /// Number of motions
    #[must_use]
    pub(crate) fn count(&self) -> u64 {
        self.motions.unwrap_or(match (self.corners, self.fit) {
            (true, _) => 1_000_000,
            (false, true) => 10_000,
            (false, false) => 100_000,
        })
    }
}

/// `toytop-lab longrun`
#[derive(Args, Debug)]
pub(crate) struct LongrunArgs {
    /// Number of ticks
    #[arg(long, value_name = "N", default_value_t = 1_000_000_000, value_parser = clap::value_parser!(u64).range(1000..=1_000_000_000_000))]
    pub ticks: u64,
    /// Markdown page whose table is rewritten
    #[arg(long, value_name = "FILE")]
    pub docs: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop-lab report`
#[derive(Args, Debug)]
#[command(group = clap::ArgGroup::new("what").required(true).multiple(true).args(["output", "readme"]))]
pub(crate) struct ReportArgs {
    /// Folder for index.html, which is created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Markdown file whose tables are rewritten
    #[arg(long, value_name = "FILE")]
    pub readme: Option<PathBuf>,
    /// Change nothing, and exit with 1 if a table is not up to date
    #[arg(long, requires = "readme")]
    pub check: bool,
    /// Output of `toytop budget --format json` for the page; without it, the page shows the limits of the calls
    #[arg(long, value_name = "FILE", requires = "output")]
    pub budget: Option<PathBuf>,
    /// Output of host/benches/by_heyoka.py --json for the page
    #[arg(long, value_name = "FILE", requires = "output")]
    pub others: Option<PathBuf>,
}

/// `toytop-lab sines`
#[derive(Args, Debug)]
pub(crate) struct SinesArgs {
    /// Compute every N-th phase
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub every: u32,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

//! The command line of `toytop-lab`.

use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;
use toytop_host::cli::Format;

/// Studies that check toytop itself; each computes its truth, and writes the page that shows its result.
#[derive(Debug, Parser)]
#[command(name = "toytop-lab", version)]
pub struct Cli {
    /// Command of the program.
    #[command(subcommand)]
    pub command: Command,
}

/// A command with its arguments.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Random motions of every regime: does the ephemeris keep its error bound? (exit code 1 if not)
    #[command(
        after_help = "Example: toytop-lab study --motions 5000 --seed 2\n         toytop-lab study --corners --seeds 20 --motions 20000 --truths 1000 --docs host/docs/study.md"
    )]
    Study(StudyArgs),
    /// Steppers and ephemeris cursors over very many ticks against the truth, there and back, and the full solver against itself
    #[command(after_help = "Example: toytop-lab longrun --ticks 10000000 --format csv")]
    Longrun(LongrunArgs),
    /// Sines of an integer phase at all 2^32 phases
    #[command(
        after_help = "Example: toytop-lab sines --format json\n         toytop-lab sines --every 4099   a million phases, in less than a second"
    )]
    Sines(SinesArgs),
    /// Fixed point on random motions, in a build that checks every sum (exit code 1 if one overflows)
    #[command(
        after_help = "Example: toytop-lab overflow --motions 100000\nSums are checked in a build of: cargo run --release --config profile.release.overflow-checks=true -p toytop-lab -- overflow"
    )]
    Overflow(OverflowArgs),
    /// One page with accuracy, work and precision, figures; and the tables of the README
    #[command(after_help = "Example: toytop-lab report -o report")]
    Report(ReportArgs),
}

/// `toytop-lab overflow`
#[derive(Args, Debug)]
pub struct OverflowArgs {
    /// Number of motions
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: u64,
    /// Ticks of each, in 32 and in 16 bits
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub ticks: u32,
    /// Another seed, other motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

/// `toytop-lab study`
#[derive(Args, Debug)]
pub struct StudyArgs {
    /// Motions to try, of each seed [default: 100000; with --corners 1000000; with --fit 10000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    pub motions: Option<u64>,
    /// Another seed, other motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// This seed and those after it, so many in all, a row each
    #[arg(long, value_name = "N", default_value_t = 1, requires = "corners", value_parser = clap::value_parser!(u64).range(1..=10_000))]
    pub seeds: u64,
    /// Launches towards every degenerate corner, of branch points and of states, in four scalars
    #[arg(long)]
    pub corners: bool,
    /// Simulated throws instead, whose launches are fitted to samples of three sets of sensors (exit code 1 if a wrong launch is
    /// believed)
    #[arg(long, conflicts_with = "corners")]
    pub fit: bool,
    /// Number of launches of each seed that are compared with the truth
    #[arg(long, value_name = "N", default_value_t = 10_000, requires = "corners", value_parser = clap::value_parser!(u64).range(1..))]
    pub truths: u64,
    /// Markdown page whose table to write, of --corners or --fit
    #[arg(long, value_name = "FILE")]
    pub docs: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

impl StudyArgs {
    /// Number of motions
    #[must_use]
    pub fn count(&self) -> u64 {
        self.motions.unwrap_or(match (self.corners, self.fit) {
            (true, _) => 1_000_000,
            (false, true) => 10_000,
            (false, false) => 100_000,
        })
    }
}

/// `toytop-lab longrun`
#[derive(Args, Debug)]
pub struct LongrunArgs {
    /// Number of ticks
    #[arg(long, value_name = "N", default_value_t = 1_000_000_000, value_parser = clap::value_parser!(u64).range(1000..=1_000_000_000_000))]
    pub ticks: u64,
    /// Markdown page whose table to write
    #[arg(long, value_name = "FILE")]
    pub docs: Option<PathBuf>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// `toytop-lab report`
#[derive(Args, Debug)]
#[command(group = clap::ArgGroup::new("what").required(true).multiple(true).args(["output", "readme"]))]
pub struct ReportArgs {
    /// Folder for index.html; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Markdown file whose tables to bring up to date
    #[arg(long, value_name = "FILE")]
    pub readme: Option<PathBuf>,
    /// Change nothing; exit code 1 if a table is stale
    #[arg(long, requires = "readme")]
    pub check: bool,
    /// Output of `toytop budget --format json`, for the page; without it, the limits of the calls are shown
    #[arg(long, value_name = "FILE", requires = "output")]
    pub budget: Option<PathBuf>,
    /// Output of host/benches/by_heyoka.py --json, for the page
    #[arg(long, value_name = "FILE", requires = "output")]
    pub others: Option<PathBuf>,
}

/// `toytop-lab sines`
#[derive(Args, Debug)]
pub struct SinesArgs {
    /// Only every N-th phase
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub every: u32,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

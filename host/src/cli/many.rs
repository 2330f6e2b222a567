//! Arguments of the command that computes many motions.

use crate::sweep::{Axis, Column, DEFAULT_COLUMNS, SignChoice};
use clap::{Args, Subcommand};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Work on existing files of a sweep.
#[derive(Debug, Subcommand)]
pub(crate) enum SweepFiles {
    /// Compare every row of CSV files with its checksum, and check that none is missing
    Verify {
        /// CSV files that `toytop sweep` wrote
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
    },
    /// Join all shards of a sweep in one file, in the order of the sweep
    Join {
        /// CSV files of the shards, in any order
        #[arg(required = true, value_name = "PART")]
        parts: Vec<PathBuf>,
        /// CSV file to write, or Parquet if it ends in .parquet (in a build with that feature)
        #[arg(short, long, value_name = "FILE")]
        output: PathBuf,
    },
}

/// `toytop sweep`
#[derive(Args, Debug)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct SweepArgs {
    /// Work on existing files
    #[command(subcommand)]
    pub(crate) files: Option<SweepFiles>,
    /// CSV file to write (- is stdout), or Parquet file if its name ends in .parquet (in a build with the feature parquet). It must not exist, unless --resume is given
    #[arg(short, long, value_name = "FILE", required = true)]
    output: Option<PathBuf>,
    /// Scenario file whose numbers vary; without it, the paper's constants e1, e2, e3, A/(ps) and C/A vary
    #[arg(conflicts_with_all = ["e1", "e2", "e3", "a_over_ps", "c_over_a", "signs"])]
    pub(crate) scenario: Option<PathBuf>,
    /// Spin of a release, rad/s, as an axis (see --e1)
    #[arg(long, value_name = "AXIS", requires = "scenario", allow_hyphen_values = true)]
    pub(crate) spin: Option<Axis>,
    /// Tilt of a release, degrees
    #[arg(long, value_name = "AXIS", requires = "scenario", allow_hyphen_values = true)]
    pub(crate) tilt: Option<Axis>,
    /// Precession of a release, rad/s
    #[arg(long, value_name = "AXIS", requires = "scenario", allow_hyphen_values = true)]
    pub(crate) precession: Option<Axis>,
    /// Nutation of a release, rad/s
    #[arg(long, value_name = "AXIS", requires = "scenario", allow_hyphen_values = true)]
    pub(crate) nutation: Option<Axis>,
    /// Any other number of the scenario, in the key's unit: --axis com_height=0.02..0.04/21
    #[arg(long, value_name = "KEY=AXIS", requires = "scenario", value_parser = key_and_axis)]
    pub(crate) axis: Vec<(String, Axis)>,
    /// Heat map of a column over two keys of a grid, as an SVG file beside the output
    #[arg(long, value_name = "X,Y,COLUMN", requires = "scenario")]
    pub(crate) plot: Option<String>,
    /// Number of random motions; without it, the motions are the grid of all combinations
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000_000_000))]
    pub(crate) motions: Option<u64>,
    /// Axis of e1: X,Y,... or LOW..HIGH, in a grid LOW..HIGH/PLACES; with log: in front the values are evenly spaced in the logarithm
    #[arg(long, value_name = "AXIS", default_value = "-1..1", allow_hyphen_values = true)]
    pub(crate) e1: Axis,
    /// Axis of e2, which must not be less than e1
    #[arg(long, value_name = "AXIS", default_value = "-1..1", allow_hyphen_values = true)]
    pub(crate) e2: Axis,
    /// Axis of e3, from 1
    #[arg(long, value_name = "AXIS", default_value = "log:1..100", allow_hyphen_values = true)]
    pub(crate) e3: Axis,
    /// Axis of A/(ps), the transverse moment of inertia
    #[arg(long, value_name = "AXIS", default_value = "log:0.1..10", allow_hyphen_values = true)]
    pub(crate) a_over_ps: Axis,
    /// Axis of C/A, the axial moment of inertia
    #[arg(long, value_name = "AXIS", default_value = "0.1..2", allow_hyphen_values = true)]
    pub(crate) c_over_a: Axis,
    /// Signs of l + n and l - n (the two other pairs are mirror images)
    #[arg(long, value_enum, default_value_t = SignChoice::Both)]
    pub(crate) signs: SignChoice,
    /// Seed of the random motions
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Columns of each motion
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',', default_value = DEFAULT_COLUMNS)]
    pub(crate) columns: Vec<Column>,
    /// Number of times at which each motion is evaluated
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) ticks: u32,
    /// Nutation periods that these times are spread over (for a motion without a period: times of 2 pi sqrt((A/p + s)/g))
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = periods, allow_hyphen_values = true)]
    pub(crate) periods: f64,
    /// Every N-th motion, beginning with the I-th; 1/1 selects all
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    pub(crate) shard: Shard,
    /// Continue the output file if it exists. It must be a regular file that no other process writes
    #[arg(long)]
    pub(crate) resume: bool,
    /// Compute every row of the existing CSV file again, and name the first line that differs. Nothing is written
    #[arg(long, conflicts_with_all = ["resume", "plot"])]
    pub(crate) recompute: bool,
}

fn key_and_axis(text: &str) -> Result<(String, Axis), String> {
    let (key, axis) = text.split_once('=').ok_or("must be KEY=AXIS")?;
    Ok((key.to_owned(), axis.parse()?))
}

impl SweepArgs {
    /// File to write.
    #[must_use]
    pub(crate) fn output(&self) -> &Path {
        // clap asks for it where there is no subcommand
        self.output.as_deref().unwrap_or(Path::new("-"))
    }

    /// Keys of the scenario that vary, each with its axis.
    #[must_use]
    pub(crate) fn varied(&self) -> Vec<(String, Axis)> {
        let of_release = [
            ("spin", &self.spin),
            ("tilt_deg", &self.tilt),
            ("precession", &self.precession),
            ("nutation", &self.nutation),
        ];
        let named = of_release.into_iter().filter_map(|(key, axis)| Some((key.to_owned(), axis.clone()?)));
        named.chain(self.axis.iter().cloned()).collect()
    }
}

fn periods(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|x| *x > 0.0 && *x <= 1e9);
    number.ok_or_else(|| "must be above 0 and at most 1e9".to_owned())
}

/// Part of a sweep: its number, from 1, and the number of parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shard(pub [u64; 2]);

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const MOST: u64 = 1 << 32;
        let number = |text: &str| text.parse::<u64>().ok();
        let pair = text.split_once('/').and_then(|(shard, of)| Some([number(shard)?, number(of)?]));
        match pair {
            Some([_, of]) if of > MOST => Err(format!("N must be at most {MOST}")),
            Some(pair @ [shard, of]) if (1..=of).contains(&shard) => Ok(Self(pair)),
            _ => Err("must be I/N with I from 1 to N".to_owned()),
        }
    }
}

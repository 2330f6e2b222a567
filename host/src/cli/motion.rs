//! Arguments of the commands for one motion of a scenario file.

use super::{Format, Method, Scalar};
use crate::samples::column::{Column, DEFAULT_COLUMNS};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `toytop state`
#[derive(Args, Debug)]
pub(crate) struct StateArgs {
    /// Scenario file
    pub(crate) scenario: PathBuf,
    // without a doc comment, which would replace the help text of the whole command
    #[command(flatten)]
    pub(crate) times: TimesArgs,
    /// Method that computes the motion
    #[arg(long, value_enum, default_value_t = Method::Ephemeris)]
    pub(crate) method: Method,
    /// Scalar type of the core
    #[arg(long, value_enum, default_value_t = Scalar::F64)]
    pub(crate) scalar: Scalar,
    /// Steps of the stepper in a nutation period (for a motion without a period: in a time of 2 pi sqrt((A/p + s)/g)), for --method
    /// stepper; 4096 without this option
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1 << 24))]
    pub(crate) steps_per_period: Option<u32>,
    /// Ticks in a second, for --ticks; 1000 without this option and --tick
    #[arg(long, value_name = "N", conflicts_with = "tick", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) hertz: Option<u32>,
    /// Tick rate of A ticks in B seconds, for --ticks
    #[arg(long, value_name = "A/B", value_parser = ratio)]
    pub(crate) tick: Option<[u32; 2]>,
    /// Columns, in the order of the output
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',', default_value = DEFAULT_COLUMNS)]
    pub(crate) columns: Vec<Column>,
    /// Add units to the column names, as in omega_x [rad/s], except in Parquet
    #[arg(long)]
    pub(crate) units: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = SampleFormat::Table)]
    pub(crate) format: SampleFormat,
    /// Output file; without it, stdout
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

/// Form of the output of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SampleFormat {
    /// Aligned table
    Table,
    /// Comma-separated values, one line for each record
    Csv,
    /// One JSON object
    Json,
    /// NumPy file: a structured array with the names of the CSV columns
    Npy,
    /// Parquet file (in a build with the feature parquet)
    Parquet,
}

/// Steps in a period without `--steps-per-period`.
pub(crate) const DEFAULT_STEPS: u32 = 4096;

/// Times of `toytop state`: exactly one of the three options.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct TimesArgs {
    /// Times, s, separated by commas, in any order; they may be negative. LOW..HIGH/PLACES spreads times evenly, both ends included,
    /// log:LOW..HIGH/PLACES evenly in the logarithm
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true)]
    pub(crate) times: Option<String>,
    /// File with one time, s, in each line; # starts a comment
    #[arg(long, value_name = "FILE")]
    pub(crate) times_file: Option<PathBuf>,
    /// Ticks of a clock, as an interrupt counts them, in place of times: N1,N2,... or FIRST..LAST
    #[arg(long, value_name = "N1,N2,...", allow_hyphen_values = true)]
    pub(crate) ticks: Option<String>,
}

/// `toytop constants`
#[derive(Args, Debug)]
pub(crate) struct ConstantsArgs {
    /// Scenario file
    pub(crate) scenario: PathBuf,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub(crate) format: Format,
}

/// Kind of picture that `plot` draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlotKind {
    /// Curve of the tip between its two bounding circles, from above; for a held tip, the curve of the axis
    Tip,
    /// Curve of the axis on the unit sphere
    Axis,
    /// Tilt of the axis against time
    Tilt,
    /// Azimuth of the axis against time
    Precession,
    /// Effective potential of the nutation against the tilt
    Potential,
}

impl PlotKind {
    /// Greatest number of nutation periods of a picture, and the kind of picture as a message names it. More would fill the frame.
    #[must_use]
    pub(crate) fn most_cycles(self) -> (u32, &'static str) {
        match self {
            Self::Tilt => (300, " for --kind tilt"),
            Self::Precession => (300, " for --kind precession"),
            Self::Tip | Self::Axis | Self::Potential => (1000, ""),
        }
    }
}

/// Two times, LOW..HIGH, s.
pub(super) fn span(text: &str) -> Result<[f64; 2], &'static str> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let ends = text.split_once("..").and_then(|(from, until)| Some([number(from)?, number(until)?]));
    ends.filter(|[from, until]| from < until).ok_or("must be LOW..HIGH, two times in s")
}

/// `toytop plot`
#[derive(Args, Debug)]
pub(crate) struct PlotArgs {
    /// Scenario file
    pub(crate) scenario: PathBuf,
    /// Kind of picture
    #[arg(long, value_enum, default_value_t = PlotKind::Tip)]
    pub(crate) kind: PlotKind,
    /// Times to draw, s, at most 1000 nutation periods for the tip and the axis, 300 for tilt and precession, and none for the
    /// potential; without it, from 0 over about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    pub(crate) times: Option<[f64; 2]>,
    /// Width of the picture, pixels
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(100..=10_000))]
    pub(crate) size: Option<u32>,
    /// Output file, whose name ends in .svg, .png or, with the feature pdf, .pdf
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
}

/// `toytop animate`
#[derive(Args, Debug)]
pub(crate) struct AnimateArgs {
    /// Scenario file
    pub(crate) scenario: PathBuf,
    /// Times to show, s; without it, from 0 over about one turn of the tip around the centre
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    pub(crate) times: Option<[f64; 2]>,
    /// Length of the film, s
    #[arg(long, value_name = "S", default_value_t = 6.0, value_parser = length)]
    pub(crate) seconds: f64,
    /// Width and height of the film, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u32).range(64..=2160))]
    pub(crate) size: u32,
    /// Output file, whose name ends in .gif, or in .webm or .mp4, which need ffmpeg
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
}

fn length(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|x| (0.1..=600.0).contains(x)).ok_or("must be a number from 0.1 to 600")
}

/// `toytop view`
#[derive(Args, Debug)]
pub(crate) struct ViewArgs {
    /// Scenario file of the motion that the page begins with; without it, the page begins with a toy top
    pub(crate) scenario: Option<PathBuf>,
    /// Output file, whose name ends in .html or .htm
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,
}

/// `toytop bake`
#[derive(Args, Debug)]
pub(crate) struct BakeArgs {
    /// Scenario file
    pub(crate) scenario: PathBuf,
    /// Scalar type of the results
    #[arg(long, value_enum, default_value_t = Scalar::F32)]
    pub(crate) scalar: Scalar,
    /// Language of the table
    #[arg(long, value_enum, default_value_t = Language::Rust)]
    pub(crate) lang: Language,
    /// Number of segments that the table can hold: 8, 16, 32, ... 4096; in f32 also 25, in f64 also 48. Without it, the default of the
    /// crate (25 in f32, 48 in f64, 32 in q31, 16 in q15), or if the motion needs more, the smallest size that is enough
    #[arg(long, value_name = "SEGMENTS")]
    pub(crate) size: Option<u32>,
    /// Ticks in a second
    #[arg(long, value_name = "N", default_value_t = 1000, conflicts_with = "tick",
        value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) hertz: u32,
    /// Tick rate of A ticks in B seconds
    #[arg(long, value_name = "A/B", value_parser = ratio)]
    pub(crate) tick: Option<[u32; 2]>,
    /// Name of the table; without it, that of the scenario file
    #[arg(long, value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Output file; without it, stdout
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Folder for NAME.h and NAME.c in C, beside toytop_baked.h and toytop_baked.c, which all tables share. Without it, C is one
    /// header that needs no other file
    #[arg(long, value_name = "FOLDER", conflicts_with = "output")]
    pub(crate) split: Option<PathBuf>,
    /// Folder for the same files as a library of Arduino and PlatformIO
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["output", "split"])]
    pub(crate) arduino: Option<PathBuf>,
}

/// Language that `bake` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    /// Module with one static
    Rust,
    /// Header with the table and the code that evaluates it
    C,
    /// One JSON object with all numbers
    Json,
}

fn ratio(text: &str) -> Result<[u32; 2], &'static str> {
    two(text, '/')
        .filter(|two| !two.contains(&0))
        .ok_or("must be two whole numbers from 1 to 4294967295, as 44100/2")
}

fn two(text: &str, between: char) -> Option<[u32; 2]> {
    let (first, second) = text.split_once(between)?;
    Some([first.parse().ok()?, second.parse().ok()?])
}

//! Commands that take one motion, from a scenario file.

use super::{Format, Method, Scalar};
use crate::samples::column::{Column, DEFAULT_COLUMNS};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `toytop state`
#[derive(Args, Debug)]
pub struct StateArgs {
    /// Scenario file
    pub scenario: PathBuf,
    #[expect(missing_docs, reason = "a comment would head the help text of the whole command")]
    #[command(flatten)]
    pub times: TimesArgs,
    /// Method that reaches the times
    #[arg(long, value_enum, default_value_t = Method::Ephemeris)]
    pub method: Method,
    /// Scalar type of the core
    #[arg(long, value_enum, default_value_t = Scalar::F64)]
    pub scalar: Scalar,
    /// Steps of the stepper in a nutation period (where there is none: in a natural time of the top)
    #[arg(long, value_name = "N", default_value_t = DEFAULT_STEPS, value_parser = clap::value_parser!(u32).range(1..=1 << 24))]
    pub steps_per_period: u32,
    /// Ticks a second, for --ticks; 1000 if nothing is said
    #[arg(long, value_name = "N", conflicts_with = "tick", value_parser = clap::value_parser!(u32).range(1..))]
    pub hertz: Option<u32>,
    /// A ticks in B seconds, for --ticks
    #[arg(long, value_name = "A/B", value_parser = ratio)]
    pub tick: Option<[u32; 2]>,
    /// Columns of each time, in this order
    #[arg(long, value_enum, value_name = "LIST", value_delimiter = ',', default_value = DEFAULT_COLUMNS)]
    pub columns: Vec<Column>,
    /// Name the units in the header of CSV, Parquet excepted: omega_x [rad/s]
    #[arg(long)]
    pub units: bool,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = SampleFormat::Table)]
    pub format: SampleFormat,
    /// Output file; without it, stdout
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Form of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SampleFormat {
    /// For reading
    Table,
    /// Comma-separated, one line a record
    Csv,
    /// One JSON object
    Json,
    /// NumPy file: a structured array with the names of the CSV columns
    Npy,
    /// Parquet file (in a build with that feature)
    Parquet,
}

/// Steps a period where nothing else is said.
pub const DEFAULT_STEPS: u32 = 4096;

/// The instants of `toytop state`: exactly one of the three.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct TimesArgs {
    /// Times, separated by commas, in any order, negative ones too; or LOW..HIGH/PLACES, evenly spread with both ends, or
    /// log:LOW..HIGH/PLACES, even in the logarithm
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true)]
    pub times: Option<String>,
    /// File with one time a line; # starts a comment
    #[arg(long, value_name = "FILE")]
    pub times_file: Option<PathBuf>,
    /// Ticks of a clock, as an interrupt counts them: N1,N2,... or FIRST..LAST
    #[arg(long, value_name = "N1,N2,...", allow_hyphen_values = true)]
    pub ticks: Option<String>,
}

/// `toytop constants`
#[derive(Args, Debug)]
pub struct ConstantsArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// Kind of picture that `plot` draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PlotKind {
    /// Curve of the tip between its circles, from above; of the axis, if the tip is held
    Tip,
    /// Curve of the axis on the unit sphere
    Axis,
    /// Tilt of the axis against time
    Tilt,
    /// Azimuth of the axis against time
    Precession,
    /// Potential that the axis nutates in, against the tilt
    Potential,
}

/// Two times, LOW..HIGH.
pub(super) fn span(text: &str) -> Result<[f64; 2], &'static str> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let ends = text.split_once("..").and_then(|(from, until)| Some([number(from)?, number(until)?]));
    ends.filter(|[from, until]| from < until).ok_or("must be LOW..HIGH, two times in s")
}

/// `toytop plot`
#[derive(Args, Debug)]
pub struct PlotArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Kind of picture
    #[arg(long, value_enum, default_value_t = PlotKind::Tip)]
    pub kind: PlotKind,
    /// Times to draw, s; without it, until the curve of the tip has gone round
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    pub times: Option<[f64; 2]>,
    /// Width of the picture, pixels
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(100..=10_000))]
    pub size: Option<u32>,
    /// Output file, which ends in .svg, .png or (in a build with that feature) .pdf
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `toytop animate`
#[derive(Args, Debug)]
pub struct AnimateArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Times to show, s; without it, until the curve of the tip has gone round
    #[arg(long, value_name = "LOW..HIGH", value_parser = span, allow_hyphen_values = true)]
    pub times: Option<[f64; 2]>,
    /// Length of the film, s
    #[arg(long, value_name = "S", default_value_t = 6.0, value_parser = length)]
    pub seconds: f64,
    /// Width and height of the film, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u32).range(64..=2160))]
    pub size: u32,
    /// Output file, which ends in .gif, or by ffmpeg in .webm or .mp4
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

fn length(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|x| (0.1..=600.0).contains(x)).ok_or("must be a number from 0.1 to 600")
}

/// `toytop view`
#[derive(Args, Debug)]
pub struct ViewArgs {
    /// Scenario file to start with; without it, a toy top
    pub scenario: Option<PathBuf>,
    /// Output file, which ends in .html
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `toytop bake`
#[derive(Args, Debug)]
pub struct BakeArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Scalar type of the results
    #[arg(long, value_enum, default_value_t = Scalar::F32)]
    pub scalar: Scalar,
    /// Language of the table
    #[arg(long, value_enum, default_value_t = Language::Rust)]
    pub lang: Language,
    /// Room for so many segments: a power of two from 16 to 4096, 25 in f32, or 48 in f64; without it the crate's default, or the
    /// smallest that fits the motion
    #[arg(long, value_name = "SEGMENTS")]
    pub size: Option<u32>,
    /// Ticks a second
    #[arg(long, value_name = "N", default_value_t = 1000, conflicts_with = "tick",
        value_parser = clap::value_parser!(u32).range(1..))]
    pub hertz: u32,
    /// A ticks in B seconds
    #[arg(long, value_name = "A/B", value_parser = ratio)]
    pub tick: Option<[u32; 2]>,
    /// Name of the table; without it, that of the scenario file
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    /// Output file; without it, stdout
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// In C: NAME.h and NAME.c in this folder, beside toytop_baked.h and .c, which all tables share; without it, a header that needs no
    /// other file
    #[arg(long, value_name = "FOLDER", conflicts_with = "output")]
    pub split: Option<PathBuf>,
    /// In C: the same as a library of Arduino and PlatformIO, in this folder
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["output", "split"])]
    pub arduino: Option<PathBuf>,
}

/// Language that `bake` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Language {
    /// A module with one static
    Rust,
    /// A header with the table and what evaluates it
    C,
    /// One object with all numbers
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

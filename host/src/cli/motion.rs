//! Commands that take one motion, from a scenario file.

use super::{Format, Method, Scalar};
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
    /// How to get there
    #[arg(long, value_enum, default_value_t = Method::Ephemeris)]
    pub method: Method,
    /// Scalar type of the core
    #[arg(long, value_enum, default_value_t = Scalar::F64)]
    pub scalar: Scalar,
    /// Steps of the stepper in a nutation period (where there is none: in a natural time of the top)
    #[arg(long, value_name = "N", default_value_t = DEFAULT_STEPS, value_parser = clap::value_parser!(u32).range(1..=1 << 24))]
    pub steps_per_period: u32,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
}

/// Steps a period where nothing else is said.
pub const DEFAULT_STEPS: u32 = 4096;

/// The times of `toytop state`: exactly one of the two.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct TimesArgs {
    /// Times, separated by commas, in any order, negative ones too; or LOW..HIGH/PLACES, evenly spread with both ends
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true)]
    pub times: Option<String>,
    /// File with one time a line; # starts a comment
    #[arg(long, value_name = "FILE")]
    pub times_file: Option<PathBuf>,
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

/// `toytop plot`
#[derive(Args, Debug)]
pub struct PlotArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Where to: a file that ends in .svg or .png
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// `toytop view`
#[derive(Args, Debug)]
pub struct ViewArgs {
    /// Scenario file to start with; without it, a toy top
    pub scenario: Option<PathBuf>,
    /// Where to: a file that ends in .html
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
    /// What to write
    #[arg(long, value_enum, default_value_t = Language::Rust)]
    pub lang: Language,
    /// Room for so many segments, a power of two from 16 to 4096; without it the crate's default, or the smallest that fits
    #[arg(long, value_name = "SEGMENTS")]
    pub size: Option<u32>,
    /// Ticks a second
    #[arg(long, value_name = "N", default_value_t = 1000, conflicts_with = "tick",
        value_parser = clap::value_parser!(u32).range(1..))]
    pub hertz: u32,
    /// A ticks in B seconds
    #[arg(long, value_name = "A/B", value_parser = ratio)]
    pub tick: Option<[u32; 2]>,
    /// Where to; without it, to stdout
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// What `bake` writes.
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

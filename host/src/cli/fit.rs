//! The commands between measurements and launches.

use super::Format;
use crate::fit::free::FreeKey;
use clap::Args;
use std::path::PathBuf;

/// `toytop simulate`
#[derive(Args, Debug)]
pub(crate) struct SimulateArgs {
    /// Scenario file
    pub scenario: PathBuf,
    /// Sensors; without this option, a gyroscope, an accelerometer and a magnetometer of a telephone at the centre of mass
    #[arg(long, value_name = "SENSORS.toml")]
    pub sensors: Option<PathBuf>,
    /// Samples a second
    #[arg(long, value_name = "N", default_value_t = 1000.0, value_parser = super::measure::positive)]
    pub hertz: f64,
    /// Length of the recording, s
    #[arg(long, value_name = "S", default_value_t = 1.0, value_parser = super::measure::positive)]
    pub duration: f64,
    /// Seed of the noise
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Output file
    #[arg(short, long, value_name = "SAMPLES.csv")]
    pub output: PathBuf,
}

/// `toytop fit`
#[derive(Args, Debug)]
pub(crate) struct FitArgs {
    /// Samples, as `toytop simulate` writes them
    pub samples: PathBuf,
    /// Scenario file with the top; its motion is not read
    #[arg(long, value_name = "TOP.toml")]
    pub top: PathBuf,
    /// Sensors; without this option, those of a telephone, as far as the samples have their columns
    #[arg(long, value_name = "SENSORS.toml")]
    pub sensors: Option<PathBuf>,
    /// Keys of the top that are fitted too
    #[arg(long, value_enum, value_name = "KEY,...", value_delimiter = ',')]
    pub free: Vec<FreeKey>,
    /// Residual, in standard deviations, from which a sample is an outlier; inf for least squares
    #[arg(long, value_name = "X", default_value_t = 3.0, value_parser = huber)]
    pub huber: f64,
    /// Fits a slow loss of rotation too, and reports the drift of l, n and h: standard deviation of the loss in units of the rotation
    /// itself, 1/s, such as 0.017 where the spin may be lost in a minute
    #[arg(long, value_name = "X", value_parser = super::measure::positive)]
    pub drift: Option<f64>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    pub format: Format,
    /// Residuals against time, as a picture: a file that ends in .svg or .png
    #[arg(long, value_name = "FILE")]
    pub plot_residuals: Option<PathBuf>,
    /// Error of the prediction against time, as a picture
    #[arg(long, value_name = "FILE")]
    pub plot_prediction: Option<PathBuf>,
    /// Scenario file to write
    #[arg(short, long, value_name = "FITTED.toml")]
    pub output: Option<PathBuf>,
}

fn huber(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|x| *x >= 1.0).ok_or("must be a number from 1, or inf")
}

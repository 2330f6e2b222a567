//! `toytop simulate`: simulated readings of sensors on a top.

use crate::arguments::values::{POSITIVE, number};
use crate::files::{file_or_stdout, whole_file};
use crate::terminal::report::Report;
use clap::Args;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::sensors::columns;
use toytop_host::sensors::models::{Sensors, centre_of_mass};
use toytop_host::sensors::simulated::{MAX_SAMPLES, Recording, simulate_measurements};

/// Samples of sensors on a top, with noise, bias and limited range
#[derive(Args)]
#[command(
    after_help = "Example: toytop simulate host/scenarios/toy_top.toml --sample-rate 1000 --duration 1 --seed 7 -o samples.csv"
)]
pub struct SimulateArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Sensors; by default a telephone at the centre of mass: gyroscope, accelerometer, magnetometer
    #[arg(long, value_name = "SENSORS.toml")]
    sensors: Option<PathBuf>,
    /// Samples per second
    #[arg(long, value_name = "HZ", default_value_t = 1000.0, value_parser = number(POSITIVE))]
    sample_rate: f64,
    /// Length of the recording, s
    #[arg(long, value_name = "S", default_value_t = 1.0, value_parser = number(POSITIVE))]
    duration: f64,
    /// Seed of the noise
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Output file
    #[arg(short, long, value_name = "SAMPLES.csv")]
    output: PathBuf,
}

pub fn run(arguments: &SimulateArgs) -> Result<Report, Failure> {
    let inputs = [Some(&*arguments.scenario), arguments.sensors.as_deref()];
    whole_file::require_other("--output", Some(&arguments.output), &inputs)?;
    let scenario = Scenario::read(&arguments.scenario)?;
    let com = centre_of_mass(scenario.motion.top(), scenario.input.top.com_height);
    let sensors = Sensors::read(arguments.sensors.as_deref(), com)?;
    let recording =
        Recording::new(arguments.sample_rate, arguments.duration, arguments.seed).ok_or_else(|| {
            Failure::input(format!("--sample-rate, --duration: must give from 1 to {MAX_SAMPLES:e} samples"))
        })?;
    let samples = simulate_measurements(&scenario.motion, &sensors, &recording).ok_or_else(|| {
        let reason = "the motion has no period, and cannot be followed for so long";
        Failure::method(reason).at(&scenario.name)
    })?;
    let text = columns::csv(&sensors, &samples);
    file_or_stdout::write(Some(&arguments.output), |out| out.write_all(text.as_bytes()))?;
    Ok(Report::default())
}

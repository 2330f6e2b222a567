//! `toytop simulate`: simulated readings of sensors on a top.

use super::Report;
use crate::Failure;
use crate::cli::SimulateArgs;
use crate::commands::fit::body;
use crate::fit::sensors::Sensors;
use crate::fit::simulated::{MOST_SAMPLES, Recording, measurements};
use crate::fit::table;
use crate::input::scenario::Scenario;
use crate::output::whole_file;

pub(super) fn run(arguments: &SimulateArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let table = Scenario::keys(&arguments.scenario)?;
    let body = body(&table, scenario.motion.top());
    let sensors = match &arguments.sensors {
        Some(path) => Sensors::read(path, body)?,
        None => Sensors::telephone(body),
    };
    let recording = Recording::new(arguments.hertz, arguments.duration, arguments.seed).ok_or_else(|| {
        Failure::Input(format!("--hertz, --duration: must give from 1 to {MOST_SAMPLES:e} samples"))
    })?;
    let found = measurements(&scenario.motion, &sensors, &recording).ok_or_else(|| {
        let reason = "the motion has no period, and cannot be followed for so long";
        Failure::Method(format!("{}: {reason}", scenario.name))
    })?;
    let text = table::written(&sensors, &found);
    whole_file::write("--output", &arguments.output, text.as_bytes())?;
    Ok(Report::default())
}

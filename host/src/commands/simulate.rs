//! `toytop simulate`: simulated readings of sensors on a top.

use super::Report;
use crate::Failure;
use crate::cli::SimulateArgs;
use crate::commands::fit::body;
use crate::fit::sensors::Sensors;
use crate::fit::simulated::{Recording, measurements};
use crate::fit::table;
use crate::input::scenario::Scenario;
use crate::output::whole_file;

/// Largest number of samples.
const MOST: f64 = 1e7;

pub(super) fn run(arguments: &SimulateArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let table = Scenario::keys(&arguments.scenario)?;
    let body = body(&table, scenario.motion.top());
    let sensors = match &arguments.sensors {
        Some(path) => Sensors::read(path, body)?,
        None => Sensors::telephone(body),
    };
    let count = (arguments.hertz * arguments.duration).round();
    if !(1.0..=MOST).contains(&count) {
        return Err(Failure::Input("--hertz, --duration: must give from 1 to 1e7 samples".to_owned()));
    }
    let recording = Recording { hertz: arguments.hertz, count: count as u64, seed: arguments.seed };
    let found = measurements(&scenario.motion, &sensors, &recording).ok_or_else(|| {
        let reason = "the motion has no period, and cannot be followed for so long";
        Failure::Method(format!("{}: {reason}", scenario.name))
    })?;
    let text = table::written(&sensors, &found);
    whole_file::write("-o", &arguments.output, text.as_bytes())?;
    Ok(Report::default())
}

//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use crate::commands::warnings::warnings;
use crate::terminal::stdout::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use serde_json::Value;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::motion::constant_as_json;
use toytop_host::output::{self, Format, significant};
use toytop_model::timed_motion::{CONSTANTS, Constant};

/// First integrals, branch points, period and mean rotations
#[derive(Args)]
#[command(
    after_help = "tilt: angle of the axis from the upward vertical; precession: mean rate of the axis about the vertical;\n\
        spin: component of omega along the axis. Above the critical spin an upright top is stable.\n\
        With units = \"none\" a second is the unit of time of the scenario.\n\n\
        Example: toytop constants host/scenarios/figure_3_loops.toml"
)]
pub struct ConstantsArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let values: Value = CONSTANTS
        .iter()
        .map(|constant| (constant.name, constant_as_json(constant, &scenario.motion)))
        .collect();
    let table = || {
        let line = |constant: &Constant| {
            let unit = constant.unit;
            let named = scenario.units == Units::Si
                || !(unit.contains("kg") || ["s", "1/s", "degrees/s", "turns/min"].contains(&unit));
            let value = output::text(&values[constant.name], |x| significant(x, 8));
            [constant.name, value.as_deref().unwrap_or("-"), if named { unit } else { "" }]
                .map(str::to_owned)
                .to_vec()
        };
        TextTable { lines: CONSTANTS.iter().map(line).collect(), left: 3 }.aligned()
    };
    let text = output::render(arguments.format, &values, std::slice::from_ref(&values), table);
    Ok(Report::from(text).with_notes(warnings(&[scenario])))
}

//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::{Scenario, Units};
use crate::motion::constants::{CONSTANTS, Constant};
use crate::output::{self, Format, Lists, Record, eight_digits};
use clap::Args;
use std::path::PathBuf;
use toytop_model::constants::MotionConstants;

/// `toytop constants`
#[derive(Args)]
pub struct ConstantsArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let motion = MotionConstants::new(scenario.motion);
    let record = Record(CONSTANTS.map(|(name, _, value)| (name, value(&motion))).into());
    let table = || {
        let line = |(name, unit, value): Constant| {
            let named = scenario.units == Units::Si
                || !(unit.contains("kg") || ["s", "1/s", "degrees/s"].contains(&unit));
            let unit = if named { unit } else { "" };
            Record::default().with("key", name).with("value", value(&motion)).with("unit", unit)
        };
        output::aligned(
            &CONSTANTS.map(line),
            &[("key", "", eight_digits), ("value", "", eight_digits), ("unit", "", eight_digits)],
        )
    };
    let text = output::render(arguments.format, &Lists(Vec::new(), record), table)?;
    Ok(Report::from(text).with_remarks(warnings(&[scenario]), arguments.format == Format::Table))
}

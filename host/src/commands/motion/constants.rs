//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use super::{Report, warnings};
use crate::Failure;
use crate::constants::{ALL, Constant, value};
use crate::input::scenario::{Scenario, Units};
use crate::output::{self, Format, Lists, Record, eight};
use clap::Args;
use std::path::PathBuf;
use toytop_page::constants::MotionConstants;

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
    let record = Record(ALL.map(|(name, _)| (name, value(&motion, name))).into());
    let table = || {
        let line = |(name, unit): Constant| {
            let named = scenario.units == Units::Si
                || !(unit.contains("kg") || ["s", "1/s", "degrees/s"].contains(&unit));
            let unit = if named { unit } else { "" };
            Record::default().with("key", name).with("value", value(&motion, name)).with("unit", unit)
        };
        output::aligned(&ALL.map(line), &[("key", "", eight), ("value", "", eight), ("unit", "", eight)])
    };
    let text = output::written(arguments.format, &Lists(Vec::new(), record), table)?;
    Ok(Report::from(text).with_remarks(warnings(&[scenario]), arguments.format == Format::Table))
}

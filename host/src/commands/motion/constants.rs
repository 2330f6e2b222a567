//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use super::{Report, warnings};
use crate::Failure;
use crate::input::scenario::{Scenario, Units};
use crate::motion::value;
use crate::output::{self, Format, Lists, Record, eight_digits};
use clap::Args;
use std::path::PathBuf;
use toytop_model::constants::{CONSTANTS, Constant, MotionConstants};

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
    let values = CONSTANTS.iter().map(|constant| (constant.name, value(constant, &motion)));
    let table = || {
        let line = |constant: &Constant| {
            let unit = constant.unit;
            let named = scenario.units == Units::Si
                || !(unit.contains("kg") || ["s", "1/s", "degrees/s"].contains(&unit));
            let value = output::text(&value(constant, &motion), eight_digits);
            [constant.name, value.as_deref().unwrap_or("-"), if named { unit } else { "" }]
                .map(str::to_owned)
                .to_vec()
        };
        output::columns(CONSTANTS.iter().map(line).collect(), 3)
    };
    let text = output::render(arguments.format, &Lists(Vec::new(), Record(values.collect())), table);
    Ok(Report::from(text).with_notes(warnings(&[scenario]), arguments.format == Format::Table))
}

//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use crate::commands::warnings::warnings;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use clap::Args;
use serde_json::Value;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::Scenario;
use toytop_host::output::constant_as_json;
use toytop_host::output::{self, Format, significant};
use toytop_model::constants::{CONSTANTS, Constant};

/// First integrals, branch points, period and mean rotations
#[derive(Args)]
#[command(after_help = format!(
    "{}\nWith units = \"none\" a second is the unit of time of the scenario.\n\n\
    Example: toytop constants host/scenarios/figure_3_loops.toml",
    meanings().aligned()
))]
pub struct ConstantsArgs {
    /// Scenario file
    scenario: PathBuf,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// Names, units and meanings of the constants.
fn meanings() -> TextTable {
    let line = |constant: &Constant| [constant.name, constant.unit.name(), constant.meaning];
    TextTable::new(3, ["constant", "unit", "meaning"], CONSTANTS.iter().map(line))
}

pub fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let scenario = Scenario::read(&arguments.scenario)?;
    let values: Value = CONSTANTS
        .iter()
        .map(|constant| (constant.name, constant_as_json(constant, &scenario.motion)))
        .collect();
    let table = || {
        let line = |Constant { name, unit, .. }: &Constant| {
            let value = output::text(&values[*name], |x| significant(x, 8));
            [
                (*name).to_owned(),
                value.unwrap_or_else(|| "-".to_owned()),
                scenario.units.name(*unit).to_owned(),
            ]
        };
        TextTable::new(3, [""; 0], CONSTANTS.iter().map(line)).aligned()
    };
    let text = output::render(arguments.format, &values, std::slice::from_ref(&values), table);
    Ok(Report::from(text).with_notes(warnings(&[scenario])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::doc_page::DocPage;
    use std::fs::read_to_string;
    use std::path::Path;

    /// The page has the printed table, and a docstring of Python begins with the meaning of its constant.
    #[test]
    fn pages_and_docstrings_have_the_meanings() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        DocPage::assert_current(
            "host/docs/constants.md",
            "toytop constants: meanings",
            &meanings().markdown(),
        );
        let python = read_to_string(root.join("host/python/python/toytop/_constants.py")).expect("the class");
        let docstring = |constant: &&Constant| {
            let (_, function) = python.split_once(&format!("    def {}(", constant.name))?;
            Some((constant.meaning, function.split("\"\"\"").nth(1)?))
        };
        let documented: Vec<_> = CONSTANTS.iter().filter_map(|constant| docstring(&constant)).collect();
        // the docstrings of regime and tip_class list their words instead
        assert_eq!(documented.len() + 2, python.matches("@property").count());
        for (meaning, docstring) in documented {
            assert!(docstring.starts_with(meaning), "{docstring}: {meaning}");
        }
    }
}

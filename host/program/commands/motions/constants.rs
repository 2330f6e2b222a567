//! `toytop constants`: first integrals, branch points, period and mean rotations of a motion.

use crate::commands::warnings::warnings;
use crate::files::doc_page::DocPage;
use crate::terminal::stdout::Report;
use crate::terminal::table::{Column, TextTable};
use clap::Args;
use serde_json::Value;
use std::path::PathBuf;
use toytop_host::Failure;
use toytop_host::input::scenario::{Scenario, Units};
use toytop_host::motion::constant_as_json;
use toytop_host::output::{self, Format, significant};
use toytop_model::constants::{CONSTANTS, Constant};

/// First integrals, branch points, period and mean rotations
#[derive(Args)]
#[command(
    override_usage = "toytop constants [OPTIONS] <SCENARIO>",
    after_help = format!(
        "{}\nWith units = \"none\" a second is the unit of time of the scenario.\n\n\
        Example: toytop constants host/scenarios/figure_3_loops.toml",
        meanings().aligned()
    )
)]
pub struct ConstantsArgs {
    /// Scenario file
    #[arg(required_unless_present = "accept")]
    scenario: Option<PathBuf>,
    /// Rewrite the table of host/docs/constants.md
    #[arg(long, hide = true, conflicts_with = "scenario")]
    accept: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

const PAGE: &str = "host/docs/constants.md";
const MARK: &str = "toytop constants: meanings";

/// Names, units and meanings of the constants.
fn meanings() -> TextTable {
    let columns: [Column<Constant>; 3] = [
        ("constant", |constant| constant.name.to_owned()),
        ("unit", |constant| constant.unit.to_owned()),
        ("meaning", |constant| constant.meaning.to_owned()),
    ];
    TextTable::new(3, &columns, &CONSTANTS)
}

pub fn run(arguments: &ConstantsArgs) -> Result<Report, Failure> {
    let Some(scenario) = &arguments.scenario else {
        DocPage::read(PAGE, MARK)?.write(&meanings().markdown())?;
        return Ok(format!("written: the table in {PAGE}\n").into());
    };
    let scenario = Scenario::read(scenario)?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::read_to_string;
    use std::path::Path;

    /// The page has the printed table, and a docstring of Python begins with the meaning of its constant.
    #[test]
    fn pages_and_docstrings_have_the_meanings() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let page = read_to_string(root.join(PAGE)).expect("the page");
        let table = meanings().markdown();
        assert!(
            page.contains(&format!("<!-- {MARK} -->\n{table}<!-- end of ")),
            "toytop constants --accept:\n{table}"
        );
        let python = read_to_string(root.join("host/python/python/toytop/_constants.py")).expect("the class");
        let docstring = |constant: &&Constant| {
            let (_, function) = python.split_once(&format!("    def {}(", constant.name))?;
            Some((constant.meaning, function.split("\"\"\"").nth(1)?))
        };
        let documented: Vec<_> = CONSTANTS.iter().filter_map(|constant| docstring(&constant)).collect();
        assert_eq!(documented.len(), 19);
        for (meaning, docstring) in documented {
            assert!(docstring.starts_with(meaning), "{docstring}: {meaning}");
        }
    }
}

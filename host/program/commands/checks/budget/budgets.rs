//! Allowed cost of each call: `firmware-examples/budgets.toml`.

use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use toytop_chips::costs::{Cost, Costs};
use toytop_host::Failure;
use toytop_host::input::text_file;

/// Expected costs of each call, by the name of the chip.
#[derive(Debug, Deserialize, PartialEq)]
pub struct Budgets(pub BTreeMap<String, Costs>);

/// Factor of an expected cost that is still allowed, because another compiler may need a little more; RAM is the size of a type.
const MOST: f64 = 1.05;
/// Factor of an expected cost below which the expected cost must be lowered.
const LEAST: f64 = 0.8;

/// Row with the flash of launch, table and tick at opt-level s.
pub const FLASH_S: &str = "flash_s";
/// Limit of this flash, which is a promise, bytes.
const MAX_FLASH_S: u64 = 80_000;

/// First lines of the file.
const HEAD: &str = "\
# Cost of each call on each chip, as it was measured. `cargo xtask test` measures every call on m0plus and m4f, with --all on every
# chip, and fails where a figure is more than 5 % above this one (ram: above it at all), or less than four fifths of it.
#
# To change them: see what costs more and why (`cargo run --release --bin toytop -- budget`), then
#     cargo run --release --bin toytop -- budget --accept
# which rewrites this file and the tables in host/docs/costs.md and README.md; justify the difference in the commit message.
#
# Each figure is that of the costliest of several calls:
#   instructions  executed
#   cycles        by a model without wait states
#   stack         bytes that a painted stack shows as changed
#   ram           bytes kept between calls
#   flash         of a tick or step: bytes of every function that the call ran through
#   flash         of a set-up: bytes of code and constants of a program with launch, table and tick, minus those of the program without them
# The call flash_s is that program compiled for little flash (opt-level s); its limit is 80 000, a promise.
";

impl Budgets {
    /// Budgets of a file.
    ///
    /// # Errors
    /// [`Failure::input`]: the file cannot be read, or as [`Budgets::parse`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::parse(&text_file::read(&path.display().to_string(), path, 1)?)
    }

    /// Text of the file.
    pub fn to_toml(&self) -> String {
        let mut text = HEAD.to_owned();
        for (chip, costs) in &self.0 {
            text += &format!("\n[{chip}]\n");
            for (call, cost) in costs {
                let figure = |(name, figure): (_, Option<u64>)| Some(format!("{name} = {}", figure?));
                let figures: Vec<_> = cost.figures().into_iter().filter_map(figure).collect();
                text += &format!("{call} = {{ {} }}\n", figures.join(", "));
            }
        }
        text
    }

    /// Budgets of the text of a file.
    ///
    /// # Errors
    /// [`Failure::input`]: the text is not of the form that [`Budgets::to_toml`] writes.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        toml::from_str(text).map_err(|error| Failure::input(error.message()).at("budgets.toml"))
    }

    /// Expected cost of a call on a chip.
    pub fn budget(&self, chip: &str, call: &str) -> Cost {
        self.0.get(chip).and_then(|costs| costs.get(call)).cloned().unwrap_or_default()
    }

    /// One line for each figure too far from its expected one, and for each without a measurement or an expected figure.
    pub fn violations(&self, measured: &BTreeMap<String, Costs>) -> Vec<String> {
        let mut lines = Vec::new();
        for (chip, costs) in measured {
            let budgeted = self.0.get(chip).into_iter().flat_map(BTreeMap::keys);
            for call in costs.keys().chain(budgeted).collect::<BTreeSet<_>>() {
                let [measured, expected] =
                    [costs.get(call).cloned().unwrap_or_default(), self.budget(chip, call)];
                let figures = measured.figures().into_iter().zip(expected.figures());
                lines.extend(figures.filter_map(|((name, measured), (_, expected))| {
                    let violation = violation(call, name, measured, expected)?;
                    Some(format!("{chip}: {call}: {violation}"))
                }));
            }
        }
        lines
    }
}

/// Text about a figure that is too far from the expected one.
fn violation(call: &str, name: &str, measured: Option<u64>, expected: Option<u64>) -> Option<String> {
    let (figure, expected) = match (measured, expected) {
        (Some(figure), Some(expected)) => (figure, expected),
        (None, None) => return None,
        _ => return Some(format!("{name}: is in only one of the measurement and the budgets")),
    };
    let most = match (call, name) {
        (FLASH_S, _) => MAX_FLASH_S,
        (_, "ram") => expected,
        _ => (MOST * expected as f64).ceil() as u64,
    };
    if figure > most {
        Some(format!("{figure} {name}, {most} allowed"))
    } else if (figure as f64) < LEAST * expected as f64 {
        Some(format!("{figure} {name}, {expected} expected: the budget must be lowered"))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost(instructions: u64) -> Cost {
        let [cycles, flash, instructions, ram, stack] = [400, 900, instructions, 2000, 40].map(Some);
        Cost { cycles, flash, instructions, ram, stack }
    }

    fn cost_of_flash(bytes: u64) -> Cost {
        Cost { flash: Some(bytes), ..Cost::default() }
    }

    fn on_m4f(call: &str, cost: Cost) -> BTreeMap<String, Costs> {
        BTreeMap::from([("m4f".to_owned(), Costs::from([(call.to_owned(), cost)]))])
    }

    #[test]
    fn written_budgets_can_be_read() {
        let mut two = on_m4f("tick", cost(300));
        two.insert("riscv".into(), Costs::from([("tick".into(), cost_of_flash(5))]));
        let budgets = Budgets(two);
        assert_eq!(Budgets::parse(&budgets.to_toml()).unwrap(), budgets);
        assert!(Budgets::parse("[m4f]\ntick = { instructions = -1, flash = 2 }").is_err());
    }

    #[test]
    fn a_promise_has_its_own_limit() {
        let flash = |bytes| on_m4f(FLASH_S, cost_of_flash(bytes));
        let budgets = Budgets(flash(76_000));
        assert_eq!(budgets.violations(&flash(80_000)), Vec::<String>::new());
        assert_eq!(budgets.violations(&flash(80_001)), ["m4f: flash_s: 80001 flash, 80000 allowed"]);
    }

    #[test]
    fn costs_far_from_the_expected_are_reported() {
        let budgets = Budgets(on_m4f("tick", cost(300)));
        let lines = |call: &str, cost: Cost| budgets.violations(&on_m4f(call, cost));
        assert_eq!(lines("tick", cost(315)), Vec::<String>::new());
        assert_eq!(lines("tick", cost(316)), ["m4f: tick: 316 instructions, 315 allowed"]);
        assert_eq!(lines("tick", cost(240)), Vec::<String>::new());
        let larger = Cost { ram: Some(2001), ..cost(300) };
        assert_eq!(lines("tick", larger), ["m4f: tick: 2001 ram, 2000 allowed"]);
        assert!(lines("tick", cost(239))[0].contains("lowered"));
        assert_eq!(
            lines("tick", Cost { stack: None, ..cost(300) }),
            ["m4f: tick: stack: is in only one of the measurement and the budgets"]
        );
        // each of five figures of two calls
        let others = lines("tock", cost(300));
        assert_eq!(others.len(), 10);
        assert!(others.iter().all(|line| line.contains(": is in only one of")), "{others:?}");
    }
}

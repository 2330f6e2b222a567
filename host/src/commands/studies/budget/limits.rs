//! Allowed cost of each call: `firmware-examples/budgets.toml`.

use super::meter::{Cost, Costs};
use crate::Failure;
use crate::output::whole_file;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Allowed costs, by the name of the chip.
#[derive(Debug, Deserialize, PartialEq)]
pub struct Limits(pub BTreeMap<String, Costs>);

/// Reciprocal of the tolerance of a limit, 5 % above the measured cost, so that another compiler causes no failure.
const SLACK: u64 = 20;

const HEAD: &str = "\
# Limits of what each call costs on each chip: the measured figures plus 5 %. `cargo xtask test` measures every call on m0plus and
# m4f, with --all on every chip, and fails where one exceeds its limit, or is so far below it (a quarter) that the limit is out of date.
#
# To change them: see what costs more and why (`cargo run --release --bin toytop -- budget`), then
#     cargo run --release --bin toytop -- budget --accept
# which rewrites this file and the tables in host/docs/costs.md and README.md; justify the difference in the commit message.
#
# instructions: those executed. cycles: by a model without wait states. stack: as a painted stack shows, bytes. flash: code of every
# function that a call ran through, and for set-ups code and constants of a program with launch, table and tick minus those of the same
# program without them, bytes. ram: kept between calls, bytes. Each figure is that of the costliest of several calls.
";

impl Limits {
    /// Limits of a file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the file cannot be read, or as [`Limits::parse`].
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::parse(&whole_file::read(&path.display().to_string(), path, 1)?)
    }

    /// Limits that exceed the measured costs by a twentieth. RAM is the size of a type, which does not vary.
    pub fn around(mut measured: BTreeMap<String, Costs>) -> Self {
        let more = |figure: u64| figure + figure.div_ceil(SLACK);
        for cost in measured.values_mut().flat_map(BTreeMap::values_mut) {
            let Cost { instructions, cycles, stack, flash, ram } = *cost;
            *cost = Cost {
                instructions: more(instructions),
                cycles: cycles.map(more),
                stack: stack.map(more),
                flash: more(flash),
                ram,
            };
        }
        Self(measured)
    }

    /// Text of the file.
    pub fn to_toml(&self) -> String {
        let mut text = HEAD.to_owned();
        for (chip, costs) in &self.0 {
            text += &format!("\n[{chip}]\n");
            for (call, cost) in costs {
                let figure = |(name, figure): (&str, Option<u64>)| Some(format!("{name} = {}", figure?));
                let figures: Vec<_> = figures(cost).into_iter().filter_map(figure).collect();
                text += &format!("{call} = {{ {} }}\n", figures.join(", "));
            }
        }
        text
    }

    /// Limits of the text of a file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the text is not of the form that [`Limits::to_toml`] writes.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        toml::from_str(text).map_err(|error| Failure::Input(format!("budgets.toml: {}", error.message())))
    }

    /// Limit of a call on a chip.
    pub fn of(&self, chip: &str, call: &str) -> Option<&Cost> {
        self.0.get(chip)?.get(call)
    }

    /// Line for each figure that is not within its limit, and for each call that has a measurement or a limit but not both.
    pub fn complaints(&self, measured: &BTreeMap<String, Costs>) -> Vec<String> {
        measured.iter().flat_map(|(chip, costs)| self.of_chip(chip, costs)).collect()
    }

    fn of_chip(&self, chip: &str, measured: &Costs) -> Vec<String> {
        let mut lines = Vec::new();
        let limits = self.0.get(chip).into_iter().flat_map(BTreeMap::keys);
        for call in limits.chain(measured.keys()).collect::<BTreeSet<_>>() {
            let (Some(cost), Some(allowed)) = (measured.get(call), self.of(chip, call)) else {
                lines.push(format!("{chip}: {call}: is in only one of the measurement and the budgets"));
                continue;
            };
            for ((name, figure), (_, most)) in figures(cost).into_iter().zip(figures(allowed)) {
                let complaint = match (figure, most) {
                    (Some(figure), Some(most)) if figure > most => {
                        let over = figure - most;
                        let percent = 100.0 * over as f64 / most.max(1) as f64;
                        format!("{figure} {name}, {most} allowed: {over} too many ({percent:.1} %)")
                    }
                    (Some(figure), Some(most)) if figure < most - most / 4 => {
                        format!("{figure} {name}, {most} allowed: the budget must be lowered")
                    }
                    (Some(_), None) | (None, Some(_)) => {
                        format!("{name}: is in only one of the measurement and the budget")
                    }
                    _ => continue,
                };
                lines.push(format!("{chip}: {call}: {complaint}"));
            }
        }
        lines
    }
}

fn figures(cost: &Cost) -> [(&'static str, Option<u64>); 5] {
    [
        ("instructions", Some(cost.instructions)),
        ("cycles", cost.cycles),
        ("stack", cost.stack),
        ("flash", Some(cost.flash)),
        ("ram", cost.ram),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost(instructions: u64) -> Cost {
        Cost { instructions, cycles: Some(400), stack: Some(40), flash: 900, ram: Some(2000) }
    }

    fn costs(call: &str, cost: Cost) -> Costs {
        Costs::from([(call.to_owned(), cost)])
    }

    #[test]
    fn written_limits_can_be_read() {
        let limits = Limits::around(BTreeMap::from([
            ("m4f".into(), costs("tick", cost(300))),
            ("riscv".into(), costs("tick", Cost { cycles: None, ..cost(5) })),
        ]));
        assert_eq!(Limits::parse(&limits.to_toml()).unwrap(), limits);
        assert!(Limits::parse("[m4f]\ntick = { instructions = -1, flash = 2 }").is_err());
    }

    #[test]
    fn costs_above_and_far_below_the_limit_are_reported() {
        let limits = Limits::around(BTreeMap::from([("m4f".into(), costs("tick", cost(300)))]));
        let said = |measured: &Costs| limits.complaints(&BTreeMap::from([("m4f".into(), measured.clone())]));
        let of_tick = |cost: Cost| said(&costs("tick", cost));
        assert_eq!(of_tick(cost(315)), Vec::<String>::new());
        assert_eq!(of_tick(cost(316)), ["m4f: tick: 316 instructions, 315 allowed: 1 too many (0.3 %)"]);
        assert!(of_tick(cost(200))[0].contains("lowered"));
        assert!(of_tick(Cost { stack: None, ..cost(300) })[0].contains("stack"));
        let [tick, tock] = &said(&costs("tock", cost(300)))[..] else { panic!("two complaints") };
        assert!(
            tick.starts_with("m4f: tick: is in only one") && tock.starts_with("m4f: tock: is in only one")
        );
        assert!(said(&Costs::new())[0].contains("only one"));
    }
}

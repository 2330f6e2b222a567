//! Allowed cost of each call: `firmware-examples/budgets.toml`.

use super::Cost;
use crate::Failure;
use toml::{Table, Value};

/// Allowed costs, by chip.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Limits(pub Vec<(String, Vec<Cost>)>);

/// Reciprocal of the share by which a limit exceeds the measured cost, so that another compiler causes no failure.
const SLACK: u64 = 20;

const HEAD: &str = "\
# Limits of what each call costs on each chip: the measured figures plus 5 %. `cargo xtask test` measures every call and fails where
# one exceeds its limit, or is so far below it (a quarter) that the limit is out of date.
#
# To change them: see what costs more and why (`cargo run --release --bin toytop -- budget`), then
#     cargo run --release --bin toytop -- budget --accept
# which rewrites this file and the tables in host/docs/costs.md and README.md; justify the difference in the commit message.
#
# instructions: those executed. cycles: by a model without wait states. stack, flash (code of every function it calls), ram (kept
# between calls): bytes. Each figure is that of the costliest of several calls.
";

impl Limits {
    /// Limits that exceed the measured costs by a twentieth.
    #[must_use]
    pub fn around(measured: &[(String, Vec<Cost>)]) -> Self {
        let more = |figure: u64| figure + figure.div_ceil(SLACK);
        let widened = |cost: &Cost| Cost {
            call: cost.call.clone(),
            instructions: more(cost.instructions),
            cycles: cost.cycles.map(more),
            stack: cost.stack.map(more),
            flash: more(cost.flash),
            // RAM is the size of a type, which does not vary
            ram: cost.ram,
        };
        let chips = measured.iter().map(|(chip, costs)| (chip.clone(), costs.iter().map(widened).collect()));
        Self(chips.collect())
    }

    /// Text of the file.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let mut text = HEAD.to_owned();
        for (chip, costs) in &self.0 {
            text += &format!("\n[{chip}]\n");
            for cost in costs {
                let figures: Vec<_> =
                    figures(cost).map(|(name, figure)| format!("{name} = {figure}")).collect();
                text += &format!("{} = {{ {} }}\n", cost.call, figures.join(", "));
            }
        }
        text
    }

    /// Limits of the text of a file.
    ///
    /// # Errors
    /// [`Failure::Input`]: the text is not of the form that [`Limits::to_toml`] writes.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        let refuse = |what: String| Failure::Input(format!("budgets.toml: {what}"));
        let table: Table =
            text.parse().map_err(|error: toml::de::Error| refuse(error.message().to_owned()))?;
        let chip = |(chip, calls): (&String, &Value)| {
            let calls = calls.as_table().ok_or_else(|| refuse(format!("{chip}: a table of calls")))?;
            let cost = |(call, figures): (&String, &Value)| {
                let figure = |name: &str| figures.get(name).and_then(Value::as_integer)?.try_into().ok();
                let needed = |name: &str| {
                    figure(name)
                        .ok_or_else(|| refuse(format!("{chip}.{call}.{name}: a number, not negative")))
                };
                Ok(Cost {
                    call: call.clone(),
                    instructions: needed("instructions")?,
                    cycles: figure("cycles"),
                    stack: figure("stack"),
                    flash: needed("flash")?,
                    ram: figure("ram"),
                })
            };
            Ok((chip.clone(), calls.iter().map(cost).collect::<Result<_, Failure>>()?))
        };
        Ok(Self(table.iter().map(chip).collect::<Result<_, Failure>>()?))
    }

    /// Limit of a call on a chip.
    #[must_use]
    pub fn of(&self, chip: &str, call: &str) -> Option<&Cost> {
        let (_, costs) = self.0.iter().find(|(name, _)| name == chip)?;
        costs.iter().find(|cost| cost.call == call)
    }

    /// Line for each figure that is not within its limit, and for each call that has a measurement or a limit but not both.
    #[must_use]
    pub(crate) fn complaints(&self, chip: &str, measured: &[Cost]) -> Vec<String> {
        let mut lines = Vec::new();
        for cost in measured {
            let call = &cost.call;
            let Some(allowed) = self.of(chip, call) else {
                lines.push(format!("{chip}: {call}: has no budget"));
                continue;
            };
            for ((name, figure), (_, most)) in all_figures(cost).into_iter().zip(all_figures(allowed)) {
                let (Some(figure), Some(most)) = (figure, most) else {
                    if figure != most {
                        lines.push(format!(
                            "{chip}: {call}: {name}: is in only one of the measurement and the budget"
                        ));
                    }
                    continue;
                };
                if figure > most {
                    let over = figure - most;
                    let percent = 100.0 * over as f64 / most.max(1) as f64;
                    lines.push(format!(
                        "{chip}: {call}: {figure} {name}, {most} allowed: {over} too many ({percent:.1} %)"
                    ));
                } else if figure < most - most / 4 {
                    lines.push(format!(
                        "{chip}: {call}: {figure} {name}, {most} allowed: the budget must be lowered"
                    ));
                }
            }
        }
        let gone = |cost: &&Cost| !measured.iter().any(|found| found.call == cost.call);
        let limits = self.0.iter().filter(|(name, _)| name == chip).flat_map(|(_, costs)| costs);
        lines.extend(
            limits
                .filter(gone)
                .map(|cost| format!("{chip}: {}: has a budget, but was not called", cost.call)),
        );
        lines
    }
}

fn all_figures(cost: &Cost) -> [(&'static str, Option<u64>); 5] {
    [
        ("instructions", Some(cost.instructions)),
        ("cycles", cost.cycles),
        ("stack", cost.stack),
        ("flash", Some(cost.flash)),
        ("ram", cost.ram),
    ]
}

fn figures(cost: &Cost) -> impl Iterator<Item = (&'static str, u64)> {
    all_figures(cost).into_iter().filter_map(|(name, figure)| Some((name, figure?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost(instructions: u64) -> Cost {
        Cost {
            call: "tick".into(),
            instructions,
            cycles: Some(400),
            stack: Some(40),
            flash: 900,
            ram: Some(2000),
        }
    }

    #[test]
    fn written_limits_can_be_read() {
        let limits = Limits::around(&[
            ("m4f".into(), vec![cost(300)]),
            ("riscv".into(), vec![Cost { cycles: None, ..cost(5) }]),
        ]);
        assert_eq!(Limits::parse(&limits.to_toml()).unwrap(), limits);
        assert!(Limits::parse("[m4f]\ntick = { instructions = -1, flash = 2 }").is_err());
    }

    #[test]
    fn costs_above_and_far_below_the_limit_are_reported() {
        let limits = Limits::around(&[("m4f".into(), vec![cost(300)])]);
        let said = |measured: &[Cost]| limits.complaints("m4f", measured);
        assert_eq!(said(&[cost(315)]), Vec::<String>::new());
        assert_eq!(said(&[cost(316)]), ["m4f: tick: 316 instructions, 315 allowed: 1 too many (0.3 %)"]);
        assert!(said(&[cost(200)])[0].contains("lowered"));
        assert!(said(&[Cost { stack: None, ..cost(300) }])[0].contains("stack"));
        assert!(said(&[Cost { call: "tock".into(), ..cost(300) }])[0].contains("no budget"));
        assert!(said(&[])[0].contains("not called"));
    }
}

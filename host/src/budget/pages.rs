//! Parts of pages that have costs: tables of the limits, and of the set-up of many launches.

use super::{CorpusCost, Cost, Limits};
use crate::output::doc_markers::{self, NO_FIGURE, grouped};

/// Part of a page: the page, its mark, and its text by the costs.
pub type Part<T> = (&'static str, &'static str, fn(&T) -> String);

const COSTS: &str = "host/docs/costs.md";
const FRONT_PAGE: &str = "README.md";

/// Parts of pages that have limits.
pub const OF_LIMITS: [Part<Limits>; 2] =
    [(COSTS, "toytop budget: calls", calls), (FRONT_PAGE, "toytop budget: front page", front_page)];

/// Parts of pages that have costs of many launches.
pub const OF_CORPUS: [Part<[CorpusCost]>; 2] = [
    (COSTS, "toytop budget: launches", launches),
    (FRONT_PAGE, "toytop budget: median launch", median_launch),
];

/// Calls, each with its text on the page.
const ROWS: [(&str, &str); 24] = [
    ("ephemeris_f32", "**ephemeris**, any tick, `f32`"),
    ("cursor_f32", "**ephemeris**, the next tick, `f32`"),
    (
        "fast_tick",
        "**ephemeris**, the next tick, `f32`, in a crate of its own: α and β, which is fast in a program compiled for size too",
    ),
    ("omega_fixed_f32", "**ephemeris**, any tick, `f32`: α, β and ω in the fixed frame"),
    ("omega_f32", "**ephemeris**, any tick, `f32`: α, β and Ω in the body frame"),
    ("ephemeris_q31", "**ephemeris**, any tick, fixed point of 32 bits"),
    ("cursor_q31", "**ephemeris**, the next tick, fixed point of 32 bits, the tip in units of s"),
    ("tip_q31", "**ephemeris**, the next tick, fixed point of 32 bits: α, β and the tip in m"),
    ("omega_q31", "**ephemeris**, any tick, fixed point of 32 bits: α, β and Ω in the body frame"),
    ("ephemeris_q15", "**ephemeris**, any tick, fixed point of 16 bits"),
    ("cursor_q15", "**ephemeris**, the next tick, fixed point of 16 bits"),
    ("stepper_f32", "stepper, `f32`"),
    ("rk4_f32", "a Runge-Kutta step of the full equations, `f32`"),
    ("multicalc_rk4_f32", "the same by the crate multicalc"),
    ("ephemeris_f64", "**ephemeris**, any tick, `f64`"),
    ("cursor_f64", "**ephemeris**, the next tick, `f64`"),
    ("stepper_f64", "stepper, `f64`"),
    ("rk4_f64", "a Runge-Kutta step of the full equations, `f64`"),
    (
        "launch",
        "set-up, once per launch, `f32`: from measured numbers to the ephemeris, of a 50 g top at 150 rad/s",
    ),
    ("new", "set-up of this top, table by value on the stack (`EphemerisF32::new`)"),
    ("slices", "set-up of this top in slices, whose `Launch` and `SetUp` are kept in static memory"),
    ("launch_slow", "set-up of the same top at 5 rad/s"),
    ("launch_falling", "set-up of the same top almost upright, at 30 rad/s, which is too slow to sleep"),
    (
        "fit",
        "fit of a launch, `f32`, to 250 samples of a gyroscope and an accelerometer, and 25 of a magnetometer",
    ),
];

/// Figure of a cost.
type Figure = fn(&Cost) -> Option<u64>;

/// Columns, each with its heading, its chip and its figure.
const COLUMNS: [(&str, &str, Figure); 6] = [
    ("M0+ cycles", "m0plus", |cost| cost.cycles),
    ("M4F cycles", "m4f", |cost| cost.cycles),
    ("M7 instr.", "m7", |cost| Some(cost.instructions)),
    ("RISC-V instr.", "riscv", |cost| Some(cost.instructions)),
    ("M4F stack, bytes", "m4f", |cost| cost.stack),
    ("kept, bytes", "m4f", |cost| cost.ram),
];

fn calls(limits: &Limits) -> String {
    let mut header = vec!["from a tick to α, β, u and the tip in memory, at most"];
    header.extend(COLUMNS.map(|(heading, ..)| heading));
    let row = |(call, what): (&str, &str)| {
        let figures = COLUMNS.map(|(_, chip, figure)| cell(limits.of(chip, call).and_then(figure)));
        [&[what.to_owned()][..], &figures].concat()
    };
    table(&header, ROWS.map(row))
}

/// Rows of the front page: chip, call and text.
const FRONT_ROWS: [(&str, &str, &str); 4] = [
    ("m4f", "cursor_f32", "next tick in `f32`, Cortex-M4F"),
    ("m0plus", "cursor_q31", "next tick in 32-bit fixed point, Cortex-M0+"),
    ("m0plus", "cursor_q15", "next tick in 16-bit fixed point, Cortex-M0+"),
    ("m4f", "slices", "set-up in static memory, once per launch, Cortex-M4F"),
];

fn front_page(limits: &Limits) -> String {
    let row = |(chip, call, what): (&str, &str, &str)| {
        let Cost { cycles, ram, stack, flash, .. } = limits.of(chip, call).copied().unwrap_or_default();
        [&[what.to_owned()][..], &[cycles, ram, stack, Some(flash)].map(cell)].concat()
    };
    table(&["at most", "cycles", "kept, bytes", "stack, bytes", "flash, bytes"], FRONT_ROWS.map(row))
}

fn launches(costs: &[CorpusCost]) -> String {
    let header = [
        "chip",
        "scalar",
        "result",
        "launches",
        "median cycles",
        "greatest cycles",
        "cycles of the longest slice",
    ];
    let rows = costs.iter().map(|cost| {
        let CorpusCost { chip, scalar, result, launches, cycles, .. } = cost;
        let words = [(*chip).to_owned(), scalar.clone(), result.clone(), launches.to_string()];
        words.into_iter().chain(cycles.map(cell)).collect()
    });
    table(&header, rows)
}

/// Cost of the launches in one sentence; empty if those of this chip and scalar are not known.
fn median_launch(costs: &[CorpusCost]) -> String {
    let of_chip = |cost: &&CorpusCost| cost.chip == "m4f" && cost.scalar == "f32" && cost.result == "ready";
    let Some(cost) = costs.iter().find(of_chip) else { return String::new() };
    let [median, greatest, slice] = cost.cycles.map(|figure| grouped(&cell(figure)));
    let launches = cost.launches;
    format!(
        "Set-up of {launches} [very different launches](host/docs/costs.md#set-up-of-200-launches): median {median} cycles, worst {greatest}. Other work can run at \
         least every {slice} cycles.\n"
    )
}

fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let header = header.iter().map(|&word| word.to_owned()).collect();
    doc_markers::table(&std::iter::once(header).chain(rows).collect::<Vec<_>>())
}

/// Figure, or a dash where it is not known.
fn cell(figure: Option<u64>) -> String {
    figure.map_or(NO_FIGURE.to_owned(), |figure| figure.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn tables_have_figures_of_several_chips() {
        let costs = |cycles| {
            BTreeMap::from([("cursor_q31".into(), Cost { cycles: Some(cycles), ..Cost::default() })])
        };
        let limits = Limits(BTreeMap::from([("m4f".into(), costs(260)), ("m0plus".into(), costs(1221))]));
        assert!(front_page(&limits).contains("Cortex-M0+ | 1 221 | - | - | 0 |"));
        assert!(calls(&limits).contains("the tip in units of s | 1 221 | 260 | - | - |"));
    }
}

//! Parts of pages that have costs: tables of the budgets, and of the set-up of many launches.

use super::budgets::{Budgets, FLASH_S};
use crate::files::doc_page::DocPage;
use crate::terminal::report::Report;
use crate::terminal::table::TextTable;
use serde_json::{Value, json};
use std::iter::once;
use toytop_chips::chip::{Chip, M0PLUS, M4F, M7, RISCV};
use toytop_chips::costs::Cost;
use toytop_host::Failure;

/// Part of a page: the page, its mark, and its text.
pub type Part = (&'static str, &'static str, String);

const COSTS: &str = "host/docs/costs.md";
const FRONT_PAGE: &str = "README.md";

/// Parts of pages that have budgets.
pub fn parts_with_budgets(budgets: &Budgets) -> [Part; 2] {
    [
        (COSTS, "toytop budget: calls", table_of_calls(budgets)),
        (FRONT_PAGE, "toytop budget: front page", table_of_front_page(budgets)),
    ]
}

/// Part of a page that has the costs of many launches.
pub fn part_with_launches(rows: &[Value]) -> Part {
    let columns = [
        ("chip", "chip"),
        ("scalar", "scalar"),
        ("result", "result"),
        ("launches", "launches"),
        ("median_cycles_model", "median cycles"),
        ("greatest_cycles_model", "greatest cycles"),
        ("slice_cycles_model", "cycles of the longest slice"),
    ];
    let named = |row: &Value| columns.iter().map(|(name, heading)| (*heading, row[*name].clone())).collect();
    let rows: Vec<Value> = rows.iter().map(named).collect();
    (COSTS, "toytop budget: launches", TextTable::of_fields(&rows, 8).markdown())
}

/// Writes parts of pages of the repository, after each of them was found to have a place.
///
/// # Errors
/// The failures of [`DocPage::read`] and [`DocPage::write`].
pub fn write(parts: &[Part]) -> Result<Report, Failure> {
    let pages = parts.iter().map(|(name, mark, _)| DocPage::read(name, mark));
    for (page, (.., text)) in pages.collect::<Result<Vec<_>, _>>()?.iter().zip(parts) {
        page.write(text)?;
    }
    let names: Vec<_> = parts.iter().map(|(name, ..)| *name).collect();
    Ok(format!("written: the tables in {}\n", names.join(" and ")).into())
}

/// Calls, each with its text on the page.
const ROWS: [(&str, &str); 24] = [
    ("ephemeris_f32", "**table**, any tick, `f32`"),
    ("cursor_f32", "**table**, the next tick, `f32`"),
    ("fast_tick", "**table**, the next tick, `f32`, α and β only, in the crate `fast-tick`"),
    ("omega_fixed_f32", "**table**, any tick, `f32`: α, β and ω in the fixed frame"),
    ("omega_f32", "**table**, any tick, `f32`: α, β and Ω in the body frame"),
    ("ephemeris_q31", "**table**, any tick, fixed point of 32 bits"),
    ("cursor_q31", "**table**, the next tick, fixed point of 32 bits, the tip in units of s"),
    ("tip_q31", "**table**, the next tick, fixed point of 32 bits: α, β and the tip in m"),
    ("omega_q31", "**table**, any tick, fixed point of 32 bits: α, β and Ω in the body frame"),
    ("ephemeris_q15", "**table**, any tick, fixed point of 16 bits"),
    ("cursor_q15", "**table**, the next tick, fixed point of 16 bits"),
    ("stepper_f32", "stepper, `f32`"),
    ("rk4_f32", "a Runge-Kutta step of the full equations, `f32`"),
    ("multicalc_rk4_f32", "the same by the crate multicalc"),
    ("ephemeris_f64", "**table**, any tick, `f64`"),
    ("cursor_f64", "**table**, the next tick, `f64`"),
    ("stepper_f64", "stepper, `f64`"),
    ("rk4_f64", "a Runge-Kutta step of the full equations, `f64`"),
    (
        "launch",
        "set-up, once per launch, `f32`: from measured numbers to the table, of a 50 g top at 150 rad/s",
    ),
    ("new", "set-up of this top, table by value on the stack (`TableF32::new`)"),
    ("launch_in_static", "set-up of this top, whose `Workspace` is kept in static memory"),
    ("launch_slow", "set-up of the same top at 5 rad/s"),
    ("launch_falling", "set-up of the same top released at 0.057 degrees and 30 rad/s, from where it falls"),
    (
        "fit",
        "fit of a launch, `f32`, to 250 samples of a gyroscope and an accelerometer, and 25 of a magnetometer",
    ),
];

/// Figure of a cost.
type Figure = fn(&Cost) -> Option<u64>;

/// Columns, each with its heading, its chip and its figure.
const COLUMNS: [(&str, Chip, Figure); 6] = [
    ("M0+ cycles", M0PLUS, |cost| cost.cycles),
    ("M4F cycles", M4F, |cost| cost.cycles),
    ("M7 instr.", M7, |cost| cost.instructions),
    ("RISC-V instr.", RISCV, |cost| cost.instructions),
    ("M4F stack, bytes", M4F, |cost| cost.stack),
    ("kept, bytes", M4F, |cost| cost.ram),
];

fn table_of_calls(budgets: &Budgets) -> String {
    let row = |(call, what): (&str, &str)| -> Value {
        let figure = |(heading, chip, figure): (_, Chip, Figure)| {
            (heading, Value::from(figure(&budgets.budget(chip.name, call))))
        };
        once(("call; a tick gives α, β, u and the tip", Value::from(what)))
            .chain(COLUMNS.map(figure))
            .collect()
    };
    TextTable::of_fields(&ROWS.map(row), 8).markdown()
}

/// Rows of the front page: chip, call and text.
const FRONT_ROWS: [(Chip, &str, &str); 5] = [
    (M4F, "cursor_f32", "next tick in `f32`, Cortex-M4F"),
    (M0PLUS, "cursor_q31", "next tick in 32-bit fixed point, Cortex-M0+"),
    (M0PLUS, "cursor_q15", "next tick in 16-bit fixed point, Cortex-M0+"),
    (M4F, "launch_in_static", "set-up in static memory, once per launch, Cortex-M4F"),
    (M4F, FLASH_S, "set-up compiled for size (opt-level s), Cortex-M4F"),
];

fn table_of_front_page(budgets: &Budgets) -> String {
    let row = |(chip, call, what): (Chip, &str, &str)| {
        let Cost { cycles, ram, stack, flash, .. } = budgets.budget(chip.name, call);
        json!({ "call": what, "cycles": cycles, "kept, bytes": ram, "stack, bytes": stack, "flash, bytes": flash })
    };
    TextTable::of_fields(&FRONT_ROWS.map(row), 8).markdown()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn the_pages_have_the_tables_of_the_budgets() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let budgets = Budgets::read(&root.join("firmware-examples/budgets.toml")).expect("the budgets");
        for (name, mark, text) in parts_with_budgets(&budgets) {
            DocPage::assert_current(name, mark, &text);
        }
    }

    /// Sentences of the front page have figures of the pages that it links.
    #[test]
    fn the_front_page_repeats_figures_of_the_tables() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let cell = |page: &str, row: &str, column: usize| {
            let page = std::fs::read_to_string(root.join(page)).expect("a page");
            let cells = page.lines().find_map(|line| line.strip_prefix(row)).expect(row);
            cells.split('|').nth(column).expect("a cell").replace(' ', "")
        };
        let error = |scalar| cell("host/docs/accuracy.md", &format!("| {scalar} |"), 0);
        let [f64, f32, q31] = ["f64", "f32", "q31"].map(error);
        let ready = |column| cell(COSTS, "| m4f | f32 | ready |", column);
        let millions = |column| ready(column).parse::<f64>().expect("cycles") / 1e6;
        let figures = format!(
            "* **Error** up to 10⁹ periods, of [these motions](host/docs/accuracy.md): {f64} rad in `f64`, {f32} in `f32`, {q31} in \
             32-bit fixed point.\n\
             * **Other launches:** set-up of [200 very different ones](host/docs/costs.md#set-up-of-200-launches), `f32`, Cortex-M4F: \
             median {:.2} million cycles, at most {:.1} million; {} refused.\n",
            millions(1),
            millions(2),
            cell(COSTS, "| m4f | f32 | refused |", 0)
        );
        DocPage::assert_current(FRONT_PAGE, "toytop budget: figures", &figures);
    }
}

//! Tables of costs in pages, written from the limits, so that a test checks every figure of a page.

use super::{CorpusCost, Cost, Limits};
use crate::output::doc_markers::{self, NO_FIGURE, grouped, replaced};

const BEGIN: &str = "<!-- budget: written by `toytop budget --accept` -->\n";
const END: &str = "<!-- budget: end -->";

/// Calls, each with its text on the page.
const ROWS: [(&str, &str); 21] = [
    ("ephemeris_f32", "**ephemeris**, any tick, `f32`"),
    ("cursor_f32", "**ephemeris**, the next tick, `f32`"),
    ("omega_f32", "**ephemeris**, any tick, `f32`: α, β and Ω in the body frame"),
    ("ephemeris_q31", "**ephemeris**, any tick, fixed point of 32 bits"),
    ("cursor_q31", "**ephemeris**, the next tick, fixed point of 32 bits"),
    ("omega_q31", "**ephemeris**, any tick, fixed point of 32 bits: α, β and Ω in the body frame"),
    ("ephemeris_q15", "**ephemeris**, any tick, fixed point of 16 bits"),
    ("cursor_q15", "**ephemeris**, the next tick, fixed point of 16 bits"),
    ("cursor_micromath", "the same table in `f32` with the sines of the crate micromath, the next tick"),
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
    ("slices", "set-up of this top in slices, whose `Launch` and `SetUp` are kept in static memory"),
    ("launch_slow", "set-up of the same top at 5 rad/s"),
    ("launch_falling", "set-up of the same top almost upright, at 30 rad/s, which is too slow to sleep"),
    (
        "fit",
        "fit of a launch, `f32`, to a second of samples: 1000 of a gyroscope and an accelerometer, 100 of a magnetometer",
    ),
];

const FRONT_BEGIN: &str = "<!-- budget: front page, written by `toytop budget --accept` -->\n";
const FRONT_END: &str = "<!-- budget: end of front page -->";

/// Rows of the front page: chip, call and text.
const FRONT_ROWS: [(&str, &str, &str); 7] = [
    ("m4f", "cursor_f32", "the next tick in `f32`, Cortex-M4F"),
    ("m0plus", "cursor_q31", "the next tick in 32-bit fixed point, Cortex-M0+"),
    ("m0plus", "cursor_q15", "the next tick in 16-bit fixed point, Cortex-M0+"),
    ("m4f", "launch", "set-up of this motion, once per launch, Cortex-M4F"),
    ("m4f", "slices", "set-up of this motion in slices, in static memory, Cortex-M4F"),
    ("m4f", "launch_slow", "set-up of the same top at 5 rad/s, Cortex-M4F"),
    ("m4f", "launch_falling", "set-up of the same top almost upright, falling, Cortex-M4F"),
];

/// Front page with the table of the limits; `None` if the page has no markers for it.
#[must_use]
pub fn with_front_table(page: &str, limits: &Limits) -> Option<String> {
    let header = ["at most", "cycles", "kept, bytes", "stack, bytes", "flash, bytes"];
    let rows = FRONT_ROWS.map(|(chip, call, what)| {
        let cell = |figure: fn(&Cost) -> Option<u64>| cell(limits.of(chip, call).and_then(figure));
        let (cycles, ram) = (cell(|cost| cost.cycles), cell(|cost| cost.ram));
        let (stack, flash) = (cell(|cost| cost.stack), cell(|cost| Some(cost.flash)));
        vec![what.to_owned(), cycles, ram, stack, flash]
    });
    replaced(page, [FRONT_BEGIN, FRONT_END], &table(&header, rows))
}

const CORPUS_BEGIN: &str = "<!-- budget: corpus, written by `toytop budget --corpus --accept` -->\n";
const CORPUS_END: &str = "<!-- budget: end of corpus -->";

/// Page with the table of the 200 launches; `None` if the page has no markers for it.
#[must_use]
pub(crate) fn with_corpus(page: &str, costs: &[CorpusCost]) -> Option<String> {
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
        let CorpusCost { chip, scalar, result, launches, .. } = cost;
        let words = [(*chip).to_owned(), scalar.clone(), result.clone(), launches.len().to_string()];
        words.into_iter().chain(cost.modelled_cycles().map(cell)).collect()
    });
    replaced(page, [CORPUS_BEGIN, CORPUS_END], &table(&header, rows))
}

const BRIEF_BEGIN: &str = "<!-- budget: corpus in brief, written by `toytop budget --corpus --accept` -->\n";
const BRIEF_END: &str = "<!-- budget: end of brief -->";

/// Front page with the cost of the 200 launches in one sentence; `None` if the page has no markers for it, or the costs of this chip and
/// scalar are not known.
#[must_use]
pub(crate) fn with_corpus_in_brief(page: &str, costs: &[CorpusCost]) -> Option<String> {
    let of_chip = |cost: &&CorpusCost| cost.chip == "m4f" && cost.scalar == "f32" && cost.result == "ready";
    let cost = costs.iter().find(of_chip)?;
    let [median, greatest, slice] = cost.modelled_cycles().map(|figure| grouped(&cell(figure)));
    let launches = cost.launches.len();
    let text = format!(
        "In `f32` {launches} of [200 very different launches](host/docs/costs.md#set-up-of-200-launches) fit a table of 64 segments; their set-up takes \
         {median} cycles of a Cortex-M4F in the median and {greatest} at most, in slices of at most {slice}.\n"
    );
    replaced(page, [BRIEF_BEGIN, BRIEF_END], &text)
}

/// Page with the table of the limits; `None` if the page has no markers for it.
#[must_use]
pub fn with_table(page: &str, limits: &Limits) -> Option<String> {
    let header = [
        "from a tick to α, β, u and the tip in memory, at most",
        "M0+ cycles",
        "M4F cycles",
        "M7 instr.",
        "RISC-V instr.",
        "M4F stack, bytes",
        "kept, bytes",
    ];
    let rows = ROWS.map(|(call, what)| {
        let cell =
            |chip: &str, figure: fn(&Cost) -> Option<u64>| cell(limits.of(chip, call).and_then(figure));
        vec![
            what.to_owned(),
            cell("m0plus", |cost| cost.cycles),
            cell("m4f", |cost| cost.cycles),
            cell("m7", |cost| Some(cost.instructions)),
            cell("riscv", |cost| Some(cost.instructions)),
            cell("m4f", |cost| cost.stack),
            cell("m4f", |cost| cost.ram),
        ]
    });
    replaced(page, [BEGIN, END], &table(&header, rows))
}

fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let header = header.iter().map(|&word| word.to_owned()).collect();
    doc_markers::table(&[header].into_iter().chain(rows).collect::<Vec<_>>())
}

/// Figure, or a dash where it is not known.
fn cell(figure: Option<u64>) -> String {
    figure.map_or(NO_FIGURE.to_owned(), |figure| figure.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_page_has_figures_of_several_chips() {
        let cost = |cycles| Cost { call: "cursor_q31".into(), cycles: Some(cycles), ..Cost::default() };
        let limits = Limits(vec![("m4f".into(), vec![cost(260)]), ("m0plus".into(), vec![cost(1221)])]);
        let page = with_front_table(&format!("a\n{FRONT_BEGIN}old\n{FRONT_END}\nb"), &limits).unwrap();
        assert!(page.contains("Cortex-M0+ | 1 221 | - | - | 0 |") && !page.contains("old"), "{page}");
        assert_eq!(with_front_table(&page, &limits).as_ref(), Some(&page));
        assert_eq!(with_front_table("no place", &limits), None);
    }

    #[test]
    fn only_the_table_is_replaced() {
        let cost = Cost { call: "rk4_f32".into(), cycles: Some(1234), ..Cost::default() };
        let limits = Limits(vec![("m4f".into(), vec![cost])]);
        let page = with_table(&format!("a\n{BEGIN}old\n{END}\nb"), &limits).unwrap();
        assert!(page.starts_with("a\n") && page.ends_with("\nb") && !page.contains("old"), "{page}");
        assert!(page.contains("| - | 1 234 | - |"), "{page}");
        assert_eq!(with_table(&page, &limits).as_ref(), Some(&page));
        assert_eq!(with_table("no place", &limits), None);
    }
}

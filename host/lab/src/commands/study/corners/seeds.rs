//! Row of each seed.

use crate::study::corners::reading::SCALARS;
use crate::study::corners::tally::{Side, Tally};
use toytop_host::output::{Cell, Record};

/// Keys of the greatest errors as a share of the bound, by scalar, in the order of [`SCALARS`].
const OF_BOUND: [&str; SCALARS.len()] =
    ["f64_error_of_bound", "f32_error_of_bound", "q31_error_of_bound", "q15_error_of_bound"];

/// Totals of a seed.
pub(super) fn record(seed: u64, tally: &Tally) -> Record {
    let sides: Vec<_> = (0..SCALARS.len()).map(|scalar| tally.of_scalar(scalar)).collect();
    let refused = tally.refused.values().sum();
    let mut cells = vec![
        ("seed", Cell::Count(seed)),
        ("moving", Cell::Count(tally.moving)),
        ("refused", Cell::Count(refused)),
        ("beyond_range", Cell::Count(tally.beyond)),
        ("truths", Cell::Count(tally.truths())),
        ("places", Cell::Count(sides.iter().map(|side| side.places[0]).sum())),
        ("places_by_ticks", Cell::Count(sides.iter().map(|side| side.places[1]).sum())),
    ];
    cells.extend(OF_BOUND.into_iter().zip(&sides).map(|(key, side)| (key, Cell::Number(side.of_bound))));
    let checks_of_bound = sides.iter().map(|side| side.checks_of_bound).fold(0.0, f64::max);
    cells.push(("checks_of_bound", Cell::Number(checks_of_bound)));
    cells.push(("beyond_bound", Cell::Count(sides.iter().map(Side::beyond_bound).sum())));
    cells.push(("failures", Cell::Count(tally.failures.len() as u64)));
    Record(cells)
}

/// Headings of the table, for the keys of the records.
const HEADER: [&str; 14] = [
    "seed",
    "move",
    "refused in range",
    "beyond the range",
    "truths",
    "places",
    "places where ticks dominate the bound",
    "f64: error / bound",
    "f32: error / bound",
    "q31: error / bound",
    "q15: error / bound",
    "norm, turning points / bound",
    "beyond bound",
    "failures",
];

/// Header and rows of the table.
pub(super) fn rows(records: &[Record]) -> Vec<Vec<String>> {
    super::text(&HEADER, records)
}

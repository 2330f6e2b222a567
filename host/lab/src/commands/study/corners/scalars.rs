//! Row of each scalar for all regimes together.

use crate::study::corners::reading::SCALARS;
use crate::study::corners::tally::{Side, Tally};
use toytop_host::output::{Cell, Record};

/// Totals of all seeds and regimes in each scalar.
pub(super) fn records(tally: &Tally) -> Vec<Record> {
    let record = |(scalar, (name, _)): (usize, (&str, f64))| {
        let side = tally.of_scalar(scalar);
        let Side { judged: [motions, close, close_rates], places: [places, by_ticks], .. } = side;
        let share = |close: u64| Cell::Number(close as f64 / motions.max(1) as f64);
        Record(vec![
            ("scalar", Cell::Text(name.to_owned())),
            ("judged_motions", Cell::Count(motions)),
            ("judged_places", Cell::Count(places)),
            ("places_by_ticks", Cell::Count(by_ticks)),
            ("share_of_motions_within_ten", share(close)),
            ("error_of_bound", Cell::Number(side.of_bound)),
            ("share_of_motions_with_rates_within_ten", share(close_rates)),
            ("rate_error_of_bound", Cell::Number(side.rates_of_bound)),
            ("beyond_bound", Cell::Count(side.beyond_bound())),
        ])
    };
    SCALARS.into_iter().enumerate().map(record).collect()
}

/// Headings of the table, for the keys of the records.
const HEADER: [&str; 9] = [
    "scalar",
    "motions judged",
    "places judged",
    "places where ticks dominate the bound",
    "share of motions whose bound is at most ten times the error",
    "error / bound",
    "share of motions whose bound on the rates is at most ten times their error",
    "error of the rates / bound",
    "beyond bound",
];

/// Header and rows of the table.
pub(super) fn rows(records: &[Record]) -> Vec<Vec<String>> {
    super::text(&HEADER, records)
}

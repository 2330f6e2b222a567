//! A row of each scalar, all regimes together.

use crate::study::corners::reading::SCALARS;
use crate::study::corners::tally::{Side, Tally};
use toytop_host::output::{Cell, Record};

/// What the seeds and regimes add up to in each scalar.
pub(super) fn records(tally: &Tally) -> Vec<Record> {
    let record = |(scalar, (name, _)): (usize, (&str, f64))| {
        let Side { judged: [motions, close], places: [places, by_ticks], of_bound, violated, astray, .. } =
            tally.of_scalar(scalar);
        Record(vec![
            ("scalar", Cell::Text(name.to_owned())),
            ("judged_motions", Cell::Count(motions)),
            ("judged_places", Cell::Count(places)),
            ("places_by_ticks", Cell::Count(by_ticks)),
            ("share_of_motions_within_ten", Cell::Number(close as f64 / motions.max(1) as f64)),
            ("error_of_bound", Cell::Number(of_bound)),
            ("beyond_bound", Cell::Count(violated + astray)),
        ])
    };
    SCALARS.into_iter().enumerate().map(record).collect()
}

/// For reading, what the keys mean.
const HEADER: [&str; 7] = [
    "scalar",
    "motions judged",
    "places judged",
    "places where ticks dominate the bound",
    "share of motions whose bound is at most ten times the error",
    "error / bound",
    "beyond bound",
];

/// Header and cells, for reading.
pub(super) fn rows(records: &[Record]) -> Vec<Vec<String>> {
    super::text(&HEADER, records)
}

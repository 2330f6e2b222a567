//! `toytop errata`: its table, and its residuals against those of `tests/reference/errata.py`, which has 50 digits.

use crate::command::{json, list, number, read, repository, toytop};
use serde_json::Value;

#[test]
fn the_table_has_four_lines_an_erratum() {
    let table = toytop("errata").ok();
    assert_eq!((table.lines().count(), table.split_whitespace().next()), (1 + 4 * 18, Some("residual")));
    assert!(table.lines().all(|line| line.chars().count() <= 120));
}

#[test]
fn printed_formulas_fail_and_corrected_ones_hold() {
    let (errata, reference) = (json("errata"), read(&repository("tests/reference/data/errata.json")));
    let reference: Value = serde_json::from_str(&reference).expect("JSON");
    let (errata, rows) = (list(&errata["errata"]), list(&reference["rows"]));
    assert_eq!((errata.len(), rows.len()), (18, 18));
    for (erratum, row) in errata.iter().zip(rows) {
        let digits =
            |key: &str| row[key].as_str().and_then(|text| text.parse::<f64>().ok()).expect("a number");
        let (printed, corrected) = (digits("printed"), digits("corrected"));
        let [stated, bound] = ["residual_printed", "residual_corrected"].map(|key| number(&erratum[key]));
        assert!((printed - stated).abs() <= 0.005_000_1 && printed > 0.1, "{}: {printed}", erratum["place"]);
        assert!(corrected < 1e-42 && bound <= 1e-14, "{}: {corrected:e}", erratum["place"]);
        assert_ne!(erratum["printed"], erratum["corrected"]);
    }
}

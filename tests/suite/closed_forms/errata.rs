//! Errata of the paper, as `toytop errata` lists them: every printed formula is wrong and every correction is right, at 50 digits
//! (`tests/reference/errata.py`).

use toytop_host::errata::ERRATA;
use toytop_tests::vectors::{entries, json, number};

#[test]
fn printed_versions_fail_and_corrected_ones_hold() {
    let json = json("errata.json");
    let rows = entries(&json["rows"]);
    assert_eq!(rows.len(), ERRATA.len());
    for (erratum, row) in ERRATA.iter().zip(rows) {
        let [printed, corrected] = ["printed", "corrected"].map(|key| number(&row[key]));
        let [stated, bound] = erratum.residuals;
        assert!((printed - stated).abs() <= 0.005_000_1 && printed > 0.1, "{}: {printed}", erratum.place);
        assert!(corrected < 1e-42 && bound <= 1e-14, "{}: {corrected:e}", erratum.place);
        assert_ne!(erratum.printed, erratum.corrected);
    }
}

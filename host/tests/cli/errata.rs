//! Tests of `toytop errata`: every printed formula is wrong, every correction is right, and the page agrees with the program.

use super::{json, run, stdout};

#[test]
fn printed_versions_fail_and_corrected_ones_hold() {
    let slips = json(&["errata", "--format", "json"]);
    let slips = slips["slips"].as_array().expect("slips");
    assert_eq!(slips.len(), 18);
    for slip in slips {
        let residual = |key: &str| slip[key].as_f64().expect("a number");
        assert!(residual("residual_printed") > 0.1, "{slip}");
        assert!(residual("residual_corrected") < 1e-14, "{slip}");
        assert_ne!(slip["printed"], slip["corrected"]);
    }
    let csv = run(&["errata", "--format", "csv"]);
    assert!(stdout(&csv).starts_with("number,place,against,printed,corrected,residual_printed,"));
    assert_eq!(stdout(&csv).lines().count(), 19);
}

/// The page core/docs/errata.md contains the output of `toytop errata`; after an intended change, copy the new table into it.
#[test]
fn the_document_holds_the_table() {
    let output = run(&["errata"]);
    assert_eq!(output.status.code(), Some(0));
    let document = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../core/docs/errata.md"));
    let document = document.expect("core/docs/errata.md");
    let fenced = document.split("```text\n").nth(1).and_then(|rest| rest.split("```").next());
    assert_eq!(fenced, Some(stdout(&output)));
    assert!(stdout(&output).lines().all(|line| line.chars().count() <= 120));
}

//! `toytop errata`: the table of the printed errors, which the suite of the cross-crate tests compares with fifty digits.

use crate::command::{json, list, read, repository, toytop};
use toytop_host::errata::ERRATA;

#[test]
fn the_document_and_the_records_hold_the_table() {
    let table = toytop("errata").ok();
    let document = read(&repository("core/closed-forms/docs/errata.md"));
    let fenced = document.split("```text\n").nth(1).and_then(|rest| rest.split("```").next());
    assert_eq!(fenced, Some(&*table));
    assert!(table.lines().all(|line| line.chars().count() <= 120));
    let slips = json("errata");
    assert_eq!(list(&slips["slips"]).len(), ERRATA.len());
    assert_eq!(slips["slips"][17]["residual_printed"], ERRATA[17].residuals[0]);
}

//! `toytop study --corners` and `toytop longrun`: rows, pages, and what they refuse.

use super::{json, run, stderr};
use std::path::Path;

#[test]
fn corners_keep_their_bounds_and_fill_their_page() {
    let page = Path::new(env!("CARGO_TARGET_TMPDIR")).join("study.md");
    let page = page.to_str().expect("UTF-8");
    std::fs::write(page, "before\n<!-- toytop study: corners -->\nold\n<!-- end of corners -->\nafter\n")
        .expect("written");
    let arguments =
        ["study", "--corners", "--motions", "150", "--truths", "30", "--docs", page, "--format", "json"];
    let rows = json(&arguments);
    let rows = rows["rows"].as_array().expect("rows");
    let nutating: Vec<_> = rows.iter().filter(|row| row["regime"] == "nutating").collect();
    assert_eq!(nutating.len(), 4);
    for (row, (least, most)) in
        nutating.iter().zip([(1e-17, 1e-13), (1e-9, 1e-6), (1e-10, 1e-7), (1e-6, 1e-3)])
    {
        let error = row["error_rad"].as_f64().expect("a number");
        assert!(error > least && error < most, "{row}");
        assert!(row["error_of_bound"].as_f64().is_some_and(|share| share > 0.01 && share <= 1.0), "{row}");
        assert_eq!(row["beyond_bound"], 0, "{row}");
    }
    let text = std::fs::read_to_string(page).expect("the page");
    assert!(text.starts_with("before\n") && text.ends_with("after\n") && !text.contains("old"), "{text}");
    assert!(text.contains("seed 1: 150 launches") && text.contains("all refused; failures: 0."), "{text}");
}

#[test]
fn a_page_without_a_place_is_refused_before_the_work() {
    let page = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_place.md");
    std::fs::write(&page, "no place\n").expect("written");
    let page = page.to_str().expect("UTF-8");
    for arguments in [vec!["study", "--corners", "--docs", page], vec!["longrun", "--docs", page]] {
        let output = run(&arguments);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains("must hold the lines <!-- toytop "), "{message}");
    }
    assert_eq!(run(&["study", "--docs", page]).status.code(), Some(2));
}

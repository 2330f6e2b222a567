//! `toytop study`: rows and pages.

use crate::command::{Run, bash, folder, list, number, read, write};
use serde_json::Value;

/// Result of a study in a folder of this name, whose pages have this text.
fn study(name: &str, text: &str, arguments: &str) -> Run {
    std::fs::create_dir_all(folder(name).join("host/docs")).expect("a folder");
    for page in ["accuracy", "fit"] {
        write(&format!("{name}/host/docs/{page}.md"), text);
    }
    bash(&format!("cd {name} && \"$@\""), format!("study {arguments}"))
}

#[test]
fn corners_keep_their_bounds_and_fill_their_page() {
    let text = "before\n<!-- toytop study corners: corners -->\nold\n<!-- end of corners -->\nafter\n";
    let study = study("study", text, "corners --motions 150 --truths 30 --accept --format json").ok();
    let study: Value = serde_json::from_str(&study).expect("JSON");
    let rows = list(&study["rows"]);
    assert_eq!(rows.len(), 4);
    // the rates of all but f64 have 64 bits, in motions from branch points too, and the most distant ticks are beyond 2^62
    for (row, (least, most)) in rows.iter().zip([(1e-17, 1e-7), (1e-9, 0.5), (1e-10, 0.5), (1e-6, 0.5)]) {
        let error = number(&row["error_rad"]);
        assert!(error > least && error < most, "{row}");
        for share in ["error_over_bound", "rate_error_over_bound"] {
            assert!(number(&row[share]) > 0.01 && number(&row[share]) <= 1.0, "{row}");
        }
    }
    assert!(rows.iter().all(|row| row["beyond_bound"] == 0), "{study}");
    // at distant ticks their number dominates the bound, and the bound is not far above the errors
    for row in rows {
        let count = |key: &str| number(&row[key]);
        assert!(
            count("compared_motions") >= 25.0 && count("compared_ticks") >= 10.0 * count("compared_motions"),
            "{row}"
        );
        // the bound on the rates is within a hundred times the error for 25 of these 28 motions in f64
        for (share, least) in [("tight_bounds", 0.95), ("tight_rate_bounds", 0.85)] {
            assert!(number(&row[share]) >= least, "{row}");
        }
    }
    assert!(number(&rows[0]["distant_ticks"]) > 50.0, "{study}");
    let text = read("study/host/docs/accuracy.md");
    assert!(text.starts_with("before\n") && text.ends_with("after\n") && !text.contains("old"), "{text}");
    assert!(
        text.contains("seed 1: 150 launches (")
            && text.contains(" nutating")
            && text.contains("; failures: 0."),
        "{text}"
    );
}

#[test]
fn a_page_without_a_place_is_refused_before_the_work() {
    for name in ["corners", "fit"] {
        let run = study("no_place", "no place\n", &format!("{name} --accept"));
        run.refused(2, &format!("must hold the lines <!-- toytop study {name}: "));
    }
}

//! Tests of `toytop-lab study --corners` and `toytop-lab longrun`: rows, pages and refusals.

use super::{json, run, stderr, stdout};
use std::path::Path;

#[test]
fn corners_keep_their_bounds_and_fill_their_page() {
    let page = Path::new(env!("CARGO_TARGET_TMPDIR")).join("study.md");
    let page = page.to_str().expect("UTF-8");
    std::fs::write(page, "before\n<!-- toytop-lab study: corners -->\nold\n<!-- end of corners -->\nafter\n")
        .expect("written");
    let arguments =
        ["study", "--corners", "--motions", "150", "--truths", "30", "--docs", page, "--format", "json"];
    let study = json(&arguments);
    let rows = study["rows"].as_array().expect("rows");
    let nutating: Vec<_> = rows.iter().filter(|row| row["regime"] == "nutating").collect();
    assert_eq!(nutating.len(), 4);
    // the rates of all but f64 have some 60 bits, and the most distant ticks are beyond 2^62
    for (row, (least, most)) in nutating.iter().zip([(1e-17, 1e-7), (1e-9, 0.1), (1e-10, 0.1), (1e-6, 0.1)]) {
        let error = row["error_rad"].as_f64().expect("a number");
        assert!(error > least && error < most, "{row}");
        for share in ["error_of_bound", "rate_error_of_bound"] {
            assert!(row[share].as_f64().is_some_and(|share| share > 0.01 && share <= 1.0), "{row}");
        }
        assert_eq!(row["beyond_bound"], 0, "{row}");
    }
    // at distant ticks their number dominates the bound, and the bound is not far above the errors
    for scalar in study["scalars"].as_array().expect("scalars") {
        let count = |key: &str| scalar[key].as_u64().expect("a count");
        assert!(
            count("judged_motions") >= 25 && count("judged_places") >= 10 * count("judged_motions"),
            "{scalar}"
        );
        for share in ["share_of_motions_within_ten", "share_of_motions_with_rates_within_ten"] {
            assert!(scalar[share].as_f64().is_some_and(|share| share > 0.5), "{scalar}");
        }
    }
    assert!(study["scalars"][0]["places_by_ticks"].as_u64().is_some_and(|count| count > 50), "{study}");
    let seeds = study["seeds"].as_array().expect("seeds");
    assert_eq!((seeds.len(), &seeds[0]["seed"]), (1, &1.into()), "{study}");
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
        assert!(message.contains("must hold the lines <!-- toytop-lab "), "{message}");
    }
    assert_eq!(run(&["study", "--docs", page]).status.code(), Some(2));
}

/// Cells of the line that starts with this text.
fn cells(text: &str, start: &str) -> Vec<String> {
    let line = text.lines().find(|line| line.trim_start().starts_with(start));
    let line = line.unwrap_or_else(|| panic!("no line {start:?} in {text}"));
    line.trim_start()[start.len()..].split_whitespace().map(str::to_owned).collect()
}

#[test]
fn a_study_is_fixed_by_its_seed_and_adds_up() {
    let study = |seed: &str| {
        let output = run(&["study", "--motions", "150", "--seed", seed]);
        let text = stdout(&output).to_owned();
        let (head, rest) = text.split_once('\n').expect("lines");
        assert!(head.starts_with(&format!("150 motions, seed {seed}: ")), "{head}");
        assert_eq!(output.status.code(), Some(0), "{text}");
        assert_eq!(cells(&text, "BOUND VIOLATED"), ["0", "0"], "{text}");
        rest.to_owned()
    };
    let text = study("3");
    assert_eq!(text, study("3"));
    assert_ne!(text, study("4"));
    assert!(!text.contains("FAILURE"), "{text}");

    let count = |word: &str| word.parse::<u64>().expect("a count");
    let regimes = text.lines().next().expect("regimes").split("; ");
    let regimes: u64 = regimes.map(|part| count(part.split(' ').next().unwrap_or_default())).sum();
    assert_eq!(regimes, 150, "{text}");
    for side in [0, 1] {
        let fits = text
            .lines()
            .filter(|line| line.starts_with("fit "))
            .map(|line| line.split_whitespace().collect::<Vec<_>>());
        let fits: u64 = fits.map(|words| count(words[3 + side])).sum();
        assert_eq!(fits + count(&cells(&text, "do not fit")[side]), 150, "{text}");
    }
    // the errors are of the size of the scalar's rounding
    let number = |start: &str, side: usize| cells(&text, start)[side].parse::<f64>().expect("a number");
    for (side, rounding) in [(0, f64::EPSILON), (1, f64::from(f32::EPSILON))] {
        for kind in ["near", "far"] {
            let median = number(&format!("{kind}: error, median, rad"), side);
            assert!(median > 0.3 * rounding && median < 20.0 * rounding, "{kind} {side}: {median:e}");
            assert!(number(&format!("{kind}: bound / error, 10 %"), side) > 1.0);
        }
        let median = number("rates: error, median, of the greatest", side);
        assert!(median > 0.3 * rounding && median < 100.0 * rounding, "rates {side}: {median:e}");
        assert!(number("rates: bound / error, least", side) > 1.0);
    }
}

#[test]
fn tables_are_also_records() {
    let words = ["study", "--motions", "20"];
    let json = super::json(&[&words[..], &["--format", "json"]].concat());
    let records = json["rows"].as_array().expect("rows");
    assert!(records.len() >= 20, "{}", records.len());
    assert!(records.iter().all(|record| record["what"].is_string()));
    let csv = run(&[&words[..], &["--format", "csv"]].concat());
    assert_eq!(stdout(&csv).lines().count(), records.len() + 1);
}

#[test]
fn wrong_arguments_are_refused() {
    let svg = "/proc/toytop.svg";
    for (arguments, part) in [
        (&[][..], "see toytop-lab --help"),
        (&["study", "--motions", "0"], "1..=100000000"),
        (&["study", "--seed", "x"], "--seed"),
        (&["sines", "--every", "0"], "--every"),
        (&["overflow", "--ticks", "0"], "1..=1000000"),
        (&["report", "-o", "/proc/toytop"], "/proc/toytop"),
        (&["study", "--corners", "--docs", svg], svg),
        (&["longrun", "--docs", svg], svg),
    ] {
        let output = run(arguments);
        let message = stderr(&output);
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}: {message}");
        assert!(message.contains(part) && message.matches('\n').count() == 1, "{arguments:?}: {message}");
    }
}

//! Tests of `toytop bench`: its output, without the times.

use super::{run, stderr, stdout};

/// Cells of the line that starts with this text.
fn cells(text: &str, start: &str) -> Vec<String> {
    let line = text.lines().find(|line| line.trim_start().starts_with(start));
    let line = line.unwrap_or_else(|| panic!("no line {start:?} in {text}"));
    line.trim_start()[start.len()..].split_whitespace().map(str::to_owned).collect()
}

#[test]
fn bench_prints_time_and_error_of_each_method() {
    let output = run(&["bench"]);
    let text = stdout(&output);
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));
    // greatest and least error, rad
    let cases = [
        ("full solver, tolerance", 1e-9, 1e-13),
        ("Runge-Kutta of the full equations, 6400 steps a period:", 1e-9, 1e-11),
        ("ephemeris f64, 48x11, at any time: the same", 1e-11, 1e-16),
        ("ephemeris f64, 48x11, at any tick: orientation", 1e-11, 1e-16),
    ];
    for (start, most, least) in cases {
        let cells = cells(text, start);
        let [.., error, ratio] = &cells[..] else { panic!("{cells:?}") };
        let error: f64 = error.parse().expect("an error");
        assert!(error < most && error > least, "{start}: {error}");
        assert!(ratio.parse::<f64>().is_ok_and(|ratio| ratio > 0.0), "{start}: {ratio}");
    }
    for name in ["f32, 25x5", "f64, 48x11"] {
        for way in ["in a batch", "the next tick", "any tick"] {
            assert_eq!(cells(text, &format!("ephemeris {name}: {way}")).len(), 3);
        }
    }
    let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
    assert!(text.contains(" on one core of ") && text.contains(build));
}

#[test]
fn tables_are_also_records() {
    let json = super::json(&["bench", "--format", "json"]);
    let records = json["rows"].as_array().expect("rows");
    assert!(records.len() >= 14, "{}", records.len());
    assert!(records.iter().all(|record| record["what"].is_string()));
    let csv = run(&["bench", "--format", "csv"]);
    assert_eq!(stdout(&csv).lines().count(), records.len() + 1);
}

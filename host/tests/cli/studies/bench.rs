//! `toytop bench`: its output, without the times.

use crate::command::{json, list, toytop};

/// Cells of the line that starts with this text.
fn cells<'a>(text: &'a str, start: &str) -> Vec<&'a str> {
    let rest = text.lines().find_map(|line| line.trim_start().strip_prefix(start));
    rest.unwrap_or_else(|| panic!("no line {start:?} in {text}")).split_whitespace().collect()
}

#[test]
fn bench_prints_time_and_error_of_each_method() {
    let run = toytop("bench");
    assert_eq!(run.err, "");
    let text = run.ok();
    // greatest and least error, rad
    for (start, most, least) in [
        ("full solver, tolerance", 1e-9, 1e-13),
        ("Runge-Kutta of the full equations, 6400 steps a period:", 1e-9, 1e-11),
        ("ephemeris f64, 48x11, at any time: the same", 1e-11, 1e-16),
        ("ephemeris f64, 48x11, at any tick: orientation", 1e-11, 1e-16),
    ] {
        let [.., error, rate] = cells(&text, start)[..] else { panic!("{start}: {text}") };
        assert!(error.parse::<f64>().is_ok_and(|error| error < most && error > least), "{start}: {error}");
        assert!(rate.parse::<f64>().is_ok_and(|rate| rate > 0.0), "{start}: {rate}");
    }
    for name in ["f32, 25x5", "f64, 48x11"] {
        for way in ["in a batch", "the next tick", "any tick"] {
            assert_eq!(cells(&text, &format!("ephemeris {name}: {way}")).len(), 4);
        }
    }
    let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
    assert!(text.contains(" on one core of ") && text.contains(build));
    // tables are also records
    let json = json("bench");
    let records = list(&json["rows"]);
    assert!(records.len() >= 14 && records.iter().all(|record| record["what"].is_string()), "{json}");
    assert_eq!(toytop("bench --format csv").ok().lines().count(), records.len() + 1);
}

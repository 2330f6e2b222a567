//! `toytop timings`: its output, without the times.

use crate::command::{json, list, number, toytop};

#[test]
fn the_time_of_each_method_is_printed() {
    let run = toytop("timings");
    assert_eq!(run.err, "");
    let text = run.ok();
    let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
    assert!(text.contains(" on one core of ") && text.contains(build), "{text}");
    // tables are also records
    let json = json("timings");
    let records = list(&json["rows"]);
    assert_eq!(records.len(), 10);
    for record in records {
        let what = record["what"].as_str().expect("a text");
        assert!(text.contains(what) && number(&record["seconds"]) > 0.0, "{record}");
    }
    assert_eq!(toytop("bench --format csv").ok().lines().count(), records.len() + 1);
}

//! `toytop compare`: errors within their bounds, one screen, and missed bounds.

use crate::command::{
    RELEASE, TOP, branch_points, json, list, motion_without_table, number, scenario, slender, toytop,
};
use serde_json::Value;

fn rows(line: &str) -> Vec<Value> {
    list(&json(format!("compare {line}"))["rows"]).to_vec()
}

/// Motions near the separatrix: name, range of the error in `f64`, which is that of the full solver, and of the stepper in `f32`, rad. Their
/// bounds hold for all such motions, and are far above.
const NEAR_SEPARATRIX: [(&str, [f64; 2], [f64; 2]); 2] = [
    ("near separatrix 1e-3", [5e-12, 5e-11], [2e-6, 1e-5]),
    ("near separatrix 1e-6", [1e-9, 1e-8], [5e-6, 5e-5]),
];

#[test]
fn compare_holds_its_bounds() {
    let rows = rows("");
    assert_eq!(rows.len(), 18 * 6);
    for row in rows {
        let [error, bound] = ["max_orientation_error_rad", "bound_rad"].map(|key| number(&row[key]));
        assert!(row["verdict"] == "ok" && error > 0.0 && error <= bound, "{row}");
        // the derivatives of fixed point are in f32
        let drift_limit = match row["scalar"].as_str().expect("a name") {
            "f64" => 1e-14,
            "f32" | "q31" => 3e-6,
            _ => 3e-3,
        };
        // a pendulum has no spin, so that all its energy is in the motion of the axis, which is fast at the lowest point
        let drift_limit = if row["motion"] == "pendulum" { 20.0 * drift_limit } else { drift_limit };
        for key in ["h_drift", "l_drift", "n_drift"] {
            assert!(number(&row[key]) < drift_limit, "{key}: {row}");
        }
        let is_table = row["method"] == "ephemeris";
        assert_eq!(["steps", "table"].map(|key| row[key].is_null()), [is_table, !is_table], "{row}");
        assert!(!is_table || row["scalar"] != "f32" || bound < 5.11e-7, "{row}");
        let near = NEAR_SEPARATRIX.iter().find(|(name, ..)| row["motion"] == *name);
        match (near, row["scalar"].as_str(), is_table) {
            (Some((_, [least, most], _)), Some("f64"), _)
            | (Some((_, _, [least, most])), Some("f32"), false) => {
                assert!(error > *least && error < *most, "{row}");
            }
            // the bound of a table is not far above its error; in f64 the bound of the reference dominates
            (None, Some(scalar), true) => assert!(scalar == "f64" || error > 0.2 * bound, "{row}"),
            _ => {}
        }
        assert!(row["scalar"] != "q31" || error < 2e-8 && error > 1e-9, "{row}");
        assert!(row["scalar"] != "q15" || error < 5e-4, "{row}");
    }
}

/// Over 100 periods no error of an orientation exceeds the bound of the reference; an error without a bound is not checked.
#[test]
fn a_row_without_a_bound_is_not_missed() {
    toytop("compare @toy_top --periods 100 --format csv").ok();
    let gap = 5e-11;
    let file = scenario("steep", &branch_points([0.2, 1.0 - gap, 1.0 + gap], 1));
    for row in rows(&format!("{file} --periods 1000 --scalar q15")) {
        assert!(row["bound_rad"].is_null() && row["verdict"] == "no bound", "{row}");
    }
}

/// Without arguments there is one row for each motion, and the output fits one screen.
#[test]
fn compare_fits_one_screen() {
    let run = toytop("compare");
    assert!(run.err.contains("figure 2 e3=100 (-15.65"), "the warning is on stderr: {}", run.err);
    let text = run.ok();
    assert!(text.lines().count() <= 24 && text.lines().all(|line| line.chars().count() <= 100), "{text}");
    assert_eq!(text.matches(" ok\n").count(), 18, "{text}");
}

#[test]
fn compare_reads_scenarios_and_reports_a_missed_bound() {
    let names = |row: &Value| {
        ["motion", "scalar", "method"].map(|key| row[key].as_str().expect("a name").to_owned()).join(" ")
    };
    let found: Vec<_> = rows("@toy_top --scalar all --periods 2").iter().map(names).collect();
    let expected =
        ["f64 stepper", "f32 stepper", "f64 ephemeris", "f32 ephemeris", "q31 ephemeris", "q15 ephemeris"];
    assert_eq!(found, expected.map(|row| format!("toy_top {row}")));

    // A/(ps) = 1e-4 near the vertical is too steep for 4096 steps a period.
    let file = scenario("slender", &slender([-0.9, 0.99, 1.18], ["5.4e-5", "5e-5"]));
    let line = format!("{file} --scalar f64,f32");
    let run = toytop(format!("compare {line}"));
    assert_eq!((run.code, run.out.matches(" MISS\n").count()), (Some(1), 1), "{}", run.out);
    let run = toytop(format!("compare {line} --format json"));
    let rows: Value = serde_json::from_str(&run.out).expect("JSON");
    for row in list(&rows["rows"]) {
        let expected = if row["method"] == "stepper" { "MISS" } else { "ok" };
        assert_eq!((run.code, &row["verdict"]), (Some(1), &Value::from(expected)), "{row}");
    }

    // at 1e-6 no table is large enough; this is stated, and is no missed bound
    let run = toytop(format!(
        "compare {} --scalar f32 --periods 1 --format csv",
        motion_without_table("needle_compared")
    ));
    assert!(run.err.contains("needle_compared f32: no table"), "{}", run.err);
    assert!(run.out.contains(",ephemeris,,,") && run.out.ends_with(",no table\n"), "{}", run.out);
}

/// The full solver finds no step for a body of almost no inertia about its axis; the other motion is compared all the same.
#[test]
fn a_motion_that_the_full_solver_cannot_follow_is_named() {
    let steep = RELEASE.replace("spin = 3.5", "spin = 1e11");
    let file =
        scenario("unfollowed", &(TOP.replace("axial_inertia = 0.8", "axial_inertia = 1e-59") + &steep));
    let run = toytop(format!("compare {file} @toy_top --periods 1 --scalar f64 --format csv"));
    assert_eq!((run.code, run.out.lines().count()), (Some(1), 3), "{}", run.err);
    assert!(run.err.contains("unfollowed: full solver: no step"), "{}", run.err);
    let none = toytop(format!("compare {file} {file} --scalar f64"));
    none.refused(3, "unfollowed: full solver: no step ... ; unfollowed: full solver");
}

//! `toytop accuracy`: the errors of every scalar, and its page.

use crate::command::{json, list, number, path, read, repository, write};
use serde_json::Value;

/// Greatest error among rows, by the key of the error.
fn greatest<'a>(rows: impl IntoIterator<Item = &'a Value>, key: &str) -> f64 {
    rows.into_iter().map(|row| number(&row[key])).fold(0.0, f64::max)
}

#[test]
fn each_scalar_is_as_exact_as_it_says_at_every_tick() {
    const PAGE: &str = "host/docs/accuracy.md";
    let page = read(&repository(PAGE));
    std::fs::create_dir_all(path("host/docs")).expect("a folder");
    write(PAGE, &page);
    let object = json("accuracy --accept");
    let rows = list(&object["rows"]);
    assert_eq!(rows.len(), 4 * 41);
    assert!(rows.iter().any(|row| row["last_tick"] == 1_u64 << 40));
    // limits of the errors of orientation, tip and norm
    for (scalar, [least, most]) in
        [("q15", [3e-5, 3e-4]), ("q31", [1e-9, 1e-8]), ("f32", [2e-8, 5e-7]), ("f64", [1e-16, 1e-13])]
    {
        let rows: Vec<_> = rows.iter().filter(|row| row["scalar"] == scalar).collect();
        let of = |key: &str| greatest(rows.iter().copied(), key);
        for key in ["max_orientation_error_rad", "max_tip_error_per_s", "max_norm_defect"] {
            // in fixed point u and the tip have one more rounding
            let most = if key.contains("orientation") { most } else { 2.5 * most };
            assert!(of(key) > 0.2 * least && of(key) < most, "{scalar}, {key}: {:e}", of(key));
        }
        // the error after 10^9 periods is not larger than after one
        let [early, late] = [false, true].map(|is_late| {
            let half = rows.iter().filter(|row| (row["first_tick"].as_u64() >= Some(1 << 20)) == is_late);
            greatest(half.copied(), "max_orientation_error_rad")
        });
        assert!(late < 2.0 * early, "{scalar}");
    }
    assert!(read(PAGE) == page, "stale: toytop accuracy --accept");
}

//! Tests of `toytop accuracy`.

use super::{json, run, stderr, stdout};
use serde_json::Value;
use std::path::Path;

/// Greatest error of a scalar over all ticks, by the key of the error.
fn greatest(rows: &[Value], scalar: &str, key: &str) -> f64 {
    let of_scalar = rows.iter().filter(|row| row["scalar"] == scalar);
    of_scalar.map(|row| row[key].as_f64().expect("a number")).fold(0.0, f64::max)
}

#[test]
fn each_scalar_is_as_exact_as_it_says_at_every_tick() {
    let picture = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accuracy.svg");
    let object = json(&["accuracy", "--format", "json", "--plot", picture.to_str().expect("UTF-8")]);
    let rows = object["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 5 * 41);
    assert!(rows.iter().any(|row| row["last_tick"] == 1_u64 << 40));
    // limits of the errors of orientation, tip and norm
    for (scalar, [least, most]) in [
        ("f64", [1e-16, 1e-13]),
        ("f32", [2e-8, 5e-7]),
        ("q31", [1e-9, 1e-8]),
        ("q15", [3e-5, 3e-4]),
        ("micromath", [5e-4, 4e-3]),
    ] {
        for key in ["max_orientation_error_rad", "max_tip_error_per_s", "max_norm_defect"] {
            let error = greatest(rows, scalar, key);
            // in fixed point u and the tip have one more rounding
            let most = if key.contains("orientation") { most } else { 2.5 * most };
            assert!(error > 0.2 * least && error < most, "{scalar}, {key}: {error:e}");
        }
        let [rms, most] =
            ["rms_orientation_error_rad", "max_orientation_error_rad"].map(|key| greatest(rows, scalar, key));
        assert!(rms > 0.1 * most && rms < most, "{scalar}: {rms:e} {most:e}");
        // the error after 10^9 periods is not larger than after one
        let of_half = |late: bool| {
            let half = rows.iter().filter(|row| (row["first_tick"].as_u64() >= Some(1 << 20)) == late);
            greatest(&half.cloned().collect::<Vec<_>>(), scalar, "max_orientation_error_rad")
        };
        assert!(of_half(true) < 2.0 * of_half(false), "{scalar}");
    }
    let cost = |scalar: &str| greatest(rows, scalar, "m0plus_cycles");
    assert!(cost("q15") < cost("q31") && cost("q31") < cost("f32") && cost("f32") < cost("f64"));

    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/accuracy.svg");
    let [fresh, committed] = [&picture, &committed].map(|path| std::fs::read_to_string(path).expect("SVG"));
    assert!(fresh == committed, "stale: toytop accuracy --plot host/docs/accuracy.svg");
    for name in ["q31, 32-bit integers: 9e-9 rad", "Cortex-M0+, cycles", "RISC-V"] {
        assert!(fresh.contains(name), "{name}");
    }
}

#[test]
fn wrong_arguments_are_refused() {
    for (arguments, part) in [
        (&["accuracy", "--plot", "top.gif"][..], "--plot: top.gif: must end in one of .svg, .png, .pdf"),
        (&["accuracy", "--scalar", "q7"], "q31, q15, micromath, all"),
        (&["accuracy", "--scalar", "q15", "--plot", "no/such/folder/a.svg"], "no/such/folder/a.svg"),
    ] {
        let output = run(arguments);
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}");
        assert!(
            stderr(&output).contains(part) && stderr(&output).matches('\n').count() == 1,
            "{arguments:?}"
        );
    }
}

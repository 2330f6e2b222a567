//! `toytop-lab sines` and `toytop-lab overflow`.

use super::{json, run, stderr, stdout};

#[test]
fn sines_are_as_exact_as_their_documentation_says() {
    let object = json(&["sines", "--every", "997", "--format", "json"]);
    let rows = object["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 12);
    for row in rows {
        let error = row["max_error"].as_f64().expect("a number");
        let most = match row["table"].as_str().expect("a name") {
            "q31" => 1.2e-9,
            "q26" => 1.2e-8,
            "f32" => 3.2e-8,
            "I2F30" => 1.6e-9,
            "q15" => 2.2e-5,
            _ => 3.2e-5,
        };
        assert!(error > 0.3 * most && error < most, "{row}");
        let bits = row["bits"].as_f64().expect("a number");
        assert!((-error.log2() - bits).abs() < 1e-12 && row["phase"].as_u64() < Some(1 << 32), "{row}");
    }
    let table = run(&["sines", "--every", "65537"]);
    assert!(stdout(&table).contains("over 65536 phases"), "{}", stdout(&table));
}

/// A build without overflow checks is refused, and one with them finds no overflow.
#[test]
fn nothing_overflows() {
    let output = run(&["overflow", "--motions", "40", "--ticks", "200"]);
    if cfg!(debug_assertions) {
        assert_eq!(output.status.code(), Some(0), "{}{}", stdout(&output), stderr(&output));
        assert!(stdout(&output).contains("40 motions") && stdout(&output).contains("bounds: 0\n"));
    } else {
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""));
        assert!(stderr(&output).contains("does not check for overflow"));
    }
}

/// The test build checks sums, so that an overflow would panic, as in `toytop-lab overflow` with more motions. A bit lost in a conversion
/// would be an error beyond its bound.
#[test]
fn random_motions_stay_in_range() {
    let tally = (0..150)
        .map(|stream| toytop_lab::overflow::tried(7, stream, 200))
        .fold(toytop_lab::overflow::Tally::default(), toytop_lab::overflow::Tally::and);
    assert_eq!(tally.failures, [""; 0]);
    assert!(tally.ticks > 50_000, "{tally:?}");
    assert!(tally.of_bound.iter().all(|of_bound| (0.3..1.0).contains(of_bound)), "{tally:?}");
    assert!(toytop_lab::overflow::is_checked() == cfg!(debug_assertions));
}

//! Tests of `toytop constants`: rates that are exactly 0.

use super::{json, sample, scenario};

/// A pendulum that is released at rest stays in a plane, so that nothing turns about the vertical; its precession does not consist of rounding
/// errors. With the least momentum about the vertical it precesses.
#[test]
fn a_plane_pendulum_does_not_precess() {
    let keys =
        ["alpha_turns", "beta_turns", "phi_per_period", "mean_precession_deg_per_s", "mean_precession_rpm"];
    let constants = json(&["constants", &sample("pendulum"), "--format", "json"]);
    for key in keys {
        assert_eq!(constants[key].as_f64(), Some(0.0), "{key}: {constants}");
    }
    assert!(constants["period"].as_f64().is_some_and(|period| period > 1.0), "{constants}");
    let text = std::fs::read_to_string(sample("pendulum")).expect("a scenario");
    let pushed = scenario("pendulum_pushed", &text.replace("spin = 0", "spin = 0\nprecession = 1e-9"));
    let constants = json(&["constants", &pushed, "--format", "json"]);
    for key in keys {
        assert!(constants[key].as_f64().is_some_and(|x| x != 0.0), "{key}: {constants}");
    }
}

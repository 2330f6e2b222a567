//! Branch points near every degenerate case, from states rounded to f64, are compared with the exact branch points of
//! the rounded states.
//!
//! Every difference must be correct to two units in the last place. Solving the cubic in f64 by its coefficients
//! loses up to all digits of a small difference (all digits of e₂ - e₁ = 1e-8 upright, all but three of e₃ - e₂ =
//! 1e-6).

use toytop::{Motion, State};
use toytop_tests::vectors::{self, entries, number, orientation, triple};

#[test]
fn every_small_difference_keeps_its_digits() {
    let json = vectors::json("conditioning.json");
    let top = vectors::top(&json["top"]);
    let cases = entries(&json["cases"]);
    for case in cases {
        let state = State::new(orientation(case), triple(&case["omega"])).unwrap();
        let e = Motion::launch(&top, &state).unwrap().branch_points();
        for (key, value) in [
            ("one_plus_e1", e.one_plus_e1),
            ("one_minus_e2", e.one_minus_e2),
            ("e2_minus_e1", e.e2_minus_e1),
            ("e3_minus_e2", e.e3_minus_e2),
            ("e3_minus_one", e.e3_minus_one),
        ] {
            let truth = number(&case[key]);
            let error = (value / truth - 1.0).abs();
            assert!(error <= f64::EPSILON, "{}: {key} {value:e} against {truth:e}", case["corner"]);
        }
    }
    assert!(cases.len() >= 48);
}

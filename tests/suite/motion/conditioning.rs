//! Branch points near every degenerate case, from states rounded to f64, against the exact branch points of the
//! rounded states.
//!
//! Every difference must be correct to two units in the last place. Solving the cubic in f64 by its coefficients
//! loses up to all digits of a small difference (all digits of e₂ - e₁ = 1e-8 upright, all but three of e₃ - e₂ =
//! 1e-6).

use toytop::{BranchPoints, Complex, Orientation, State};
use toytop_tests::{top_of, vectors};

#[test]
fn every_small_difference_keeps_its_digits() {
    let json = vectors::json("conditioning.json");
    let number = |value: &serde_json::Value| vectors::number(value).unwrap();
    let [a, c, s, p] = ["A", "C", "s", "p"].map(|key| number(&json["top"][key]));
    let top = top_of([a, c, s, p], 1.0);
    let mut cases = 0;
    for case in json["cases"].as_array().unwrap() {
        let complex = |key: &str| Complex::new(number(&case[key][0]), number(&case[key][1]));
        let omega = [0, 1, 2].map(|i| number(&case["omega"][i]));
        let state =
            State::new(Orientation { alpha: complex("alpha"), beta: complex("beta") }, omega).unwrap();
        let e = BranchPoints::from_state(&top, &state).unwrap();
        let ours = [
            ("one_plus_e1", e.one_plus_e1),
            ("one_minus_e2", e.one_minus_e2),
            ("e2_minus_e1", e.e2_minus_e1),
            ("e3_minus_e2", e.e3_minus_e2),
            ("e3_minus_one", e.e3_minus_one),
        ];
        for (key, value) in ours {
            let truth = number(&case[key]);
            let error = (value / truth - 1.0).abs();
            assert!(error <= f64::EPSILON, "{}: {key} {value:e} against {truth:e}", case["corner"]);
        }
        cases += 1;
    }
    assert_eq!(cases, 48);
}

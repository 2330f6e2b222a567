//! Branch points near every degenerate corner, from states rounded to f64, against the roots of exactly those states.
//!
//! Every difference must come out to the last bit but one. Solving the cubic in f64 by its coefficients loses up to all
//! digits of a small difference here (of e₂ - e₁ = 1e-8 upright, every one; of e₃ - e₂ = 1e-6, all but three).

use toytop::{BranchPoints, Complex, Heaviness, Phi, State, Top};
use toytop_tests::vectors;

#[test]
fn every_small_difference_keeps_its_digits() {
    let json = vectors::json("conditioning.json");
    let number = |value: &serde_json::Value| vectors::number(value).unwrap();
    let [a, c, s, p] = ["A", "C", "s", "p"].map(|key| number(&json["top"][key]));
    let top = Top::sliding(a, c, s, Heaviness::MassMoment(p), 1.0).unwrap();
    let mut cases = 0;
    for case in json["cases"].as_array().unwrap() {
        let complex = |key: &str| Complex::new(number(&case[key][0]), number(&case[key][1]));
        let omega = [0, 1, 2].map(|i| number(&case["omega"][i]));
        let state = State::new(Phi { alpha: complex("alpha"), beta: complex("beta") }, omega).unwrap();
        let e = BranchPoints::of(&top, &state).unwrap();
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

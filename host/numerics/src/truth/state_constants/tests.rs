//! Tests of the truth of states against motions known to 30 digits.

use super::*;
use crate::truth::exact::Exact;
use crate::truth::vectors::{self, digits, error, number, relative, samples};
use serde_json::Value;

/// Reference vector that is given by a state, all exact in f64.
fn vector(name: &str) -> (StateNumbers, Value) {
    let json = vectors::read(name);
    let params = &json["params"];
    let top = ["A", "C", "s", "p"].map(|key| number(&params[key]));
    let [a, c, s, p] = top;
    let z = |key: &str| [0, 1].map(|i| number(&params[key][i]));
    let omega = [0, 1, 2].map(|i| number(&params["omega0"][i]));
    (StateNumbers { top: [a, c, s, p, 1.0, 0.0], phi: [z("alpha0"), z("beta0")], omega }, json)
}

#[test]
fn states_known_to_thirty_digits() {
    let mut checked = 0;
    for name in ["generic", "off_norm", "vertical", "vertical_spin", "downward"] {
        let (numbers, json) = vector(&format!("exact_state_{name}"));
        let exact = Exact::launched(&Launched::new(&numbers));
        let off = relative(&exact.period().expect("a period"), &json["period"]["T"]);
        assert!(off < 1e-29, "{name}: period off by {off:e}");
        for sample in samples(&json) {
            let error = error(&exact.at(&digits(&sample["t"])), sample);
            assert!(error < 1e-28, "{name} at {}: {error:e}", sample["t"]);
            checked += 1;
        }
    }
    assert!(checked > 60);
}

/// Difference e₂ - e₁ of a state that is close to a regular precession: half of its digits cancel in a cubic, so that of 512 bits more than
/// 57 digits must remain. u - e₁ and e₂ - u add up to it.
#[test]
fn a_swing_of_the_last_place_is_known_to_all_digits() {
    // tilt 60°, precession 1, spin 3/2 would be steady; ω₃ is one unit in the last place too large
    let root = 0.75_f64.sqrt();
    let numbers = StateNumbers {
        top: [1.0, 1.0, 1.0, 1.0, 1.0, 0.0],
        phi: [[root, 0.0], [-0.5, 0.0]],
        omega: [root, 0.0, 1.5_f64.next_up()],
    };
    let Launched { law, half_phase, .. } = Launched::new(&numbers);
    assert!(to_f64(&(norm_squared(&half_phase) - of_512_bits(1.0))).abs() < 1e-55);
    let sum = &law.one_plus_e1 + &law.e2_minus_e1 + &law.one_minus_e2;
    assert!(to_f64(&(sum - of_512_bits(2.0))).abs() < 1e-55);
    let swing = to_f64(&law.e2_minus_e1);
    assert!(swing > 1e-18 && swing < 1e-14, "{swing:e}");
}

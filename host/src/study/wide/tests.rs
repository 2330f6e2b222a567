//! The truth of states against motions known to 30 digits.

use super::*;
use crate::study::exact::{Exact, Point};
use crate::study::gauss::Rule;
use crate::study::vectors::{self, number, periods};
use serde_json::Value;
use toytop::real::Float;

/// A vector that is given by a state, all exact in f64.
fn vector(name: &str) -> (StateNumbers, Value) {
    let json = vectors::read(name);
    let params = &json["params"];
    let top = ["A", "C", "s", "p"].map(|key| number(&params[key]));
    let [a, c, s, p] = top;
    let z = |key: &str| [0, 1].map(|i| number(&params[key][i]));
    let omega = [0, 1, 2].map(|i| number(&params["omega0"][i]));
    (StateNumbers { top: [a, c, s, p, 1.0], phi: [z("alpha0"), z("beta0")], omega }, json)
}

/// After whole periods as many as the vector says, and the rest by way of time.
fn point(exact: &Exact<'_>, t: f64, periods: f64) -> Point {
    let period = exact.period();
    let rest = t - periods * period.t.to_f64();
    let start = exact.start();
    let chi = start.chi.to_f64();
    let there = exact.seek(&start, rest, [chi - 12.0, chi + 12.0]);
    exact.at_time(&exact.later(&there, &period, periods), there.chi, t)
}

#[test]
fn states_known_to_thirty_digits() {
    let rule = Rule::new();
    let mut checked = 0;
    for name in ["generic", "off_norm", "vertical", "vertical_spin", "downward"] {
        let (numbers, json) = vector(&format!("exact_state_{name}"));
        let launched = Launched::new(&numbers);
        let exact = Exact::launched(&launched, &rule);
        let relative = (exact.period().t.to_f64() / number(&json["period"]["T"]) - 1.0).abs();
        assert!(relative < 3e-16, "{name}: period off by {relative:e}");
        let samples = json["samples"].as_array().expect("samples").iter();
        for sample in samples.chain(json["huge_samples"].as_array().expect("samples")) {
            let t = number(&sample["t"]);
            let phi = exact.phi(&point(&exact, t, periods(sample)), t);
            let off = |z: Complex<DoubleDouble>, key: &str| {
                (z.re.to_f64() - number(&sample[key][0])).hypot(z.im.to_f64() - number(&sample[key][1]))
            };
            let error = 2.0 * off(phi.alpha, "alpha").hypot(off(phi.beta, "beta"));
            assert!(error < 6e-16, "{name} at {t}: {error:e}");
            checked += 1;
        }
    }
    assert!(checked > 60);
}

/// e₂ - e₁ of a state that all but precesses steadily: half its digits are cancelled in a cubic, so 512 bits must leave more
/// than 32 digits. u - e₁ and e₂ - u make up the whole.
#[test]
fn a_swing_of_the_last_place_is_known_to_all_digits() {
    // tilt 60°, precession 1, spin 3/2 would be steady; ω₃ is one unit in the last place too large
    let root = 0.75_f64.sqrt();
    let numbers = StateNumbers {
        top: [1.0, 1.0, 1.0, 1.0, 1.0],
        phi: [[root, 0.0], [-0.5, 0.0]],
        omega: [root, 0.0, 1.5_f64.next_up()],
    };
    let Launched { e2_minus_e1, half_phase, one_plus_e1, one_minus_e2, .. } = Launched::new(&numbers);
    let Complex { re, im } = half_phase;
    assert!((re.squared() + im.squared() - DoubleDouble::ONE).to_f64().abs() < 1e-30);
    let sum = one_plus_e1 + e2_minus_e1 + one_minus_e2;
    assert!((sum - DoubleDouble::from(2.0)).to_f64().abs() < 1e-30);
    assert!(e2_minus_e1.to_f64() > 1e-18 && e2_minus_e1.to_f64() < 1e-14, "{e2_minus_e1:?}");
}

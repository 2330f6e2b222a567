//! Closed forms where several differences of the branch points are small together, against 30 digits
//! (`tests/reference/closed_forms.py`, which uses no elliptic function) and against the ephemeris.

use serde_json::Value;
use toytop::{Complex, Ephemeris, InitialPhases, Motion, Orientation, Sign, Signs, Tick};
use toytop_closed_forms::{ClosedForm, E3EqualsE4};
use toytop_tests::{greater, tolerance, top_of, vectors};

fn number(json: &Value) -> f64 {
    vectors::number(json).unwrap()
}

fn sign(positive: bool) -> Sign {
    if positive { Sign::Plus } else { Sign::Minus }
}

fn motion(case: &Value) -> Motion {
    let top = top_of(["A", "C", "s", "p"].map(|key| number(&case[key])), 1.0);
    let [e1, e2, e3] = [0, 1, 2].map(|i| number(&case["e"][i]));
    let [l_plus_n, l_minus_n] = [0, 1].map(|i| sign(number(&case["signs"][i]) > 0.0));
    let [theta, arg_alpha, arg_beta] = ["theta", "arg_alpha", "arg_beta"].map(|key| number(&case[key]));
    let start = InitialPhases { theta, arg_alpha, arg_beta };
    Motion::from_branch_points(&top, [e1, e2, e3], Signs { l_plus_n, l_minus_n }, &start).unwrap()
}

/// At every time of the reference, up to 1e7 s, the orientation has an error of a few roundings, for any small
/// differences.
#[test]
fn nothing_is_lost_where_several_differences_are_small() {
    let json = vectors::json("closed_forms.json");
    let (mut worst, mut refused) = (0.0_f64, 0);
    for case in json["cases"].as_array().unwrap() {
        let motion = motion(case);
        let form = ClosedForm::of(&motion);
        if case["refused"].as_bool().unwrap() {
            assert!(form.is_err(), "{}", case["name"]);
            refused += 1;
            continue;
        }
        for sample in case["samples"].as_array().unwrap() {
            let complex = |key: &str| Complex::new(number(&sample[key][0]), number(&sample[key][1]));
            let truth = Orientation { alpha: complex("alpha"), beta: complex("beta") };
            let t = number(&sample["t"]);
            let error = form.unwrap().at(t).orientation.distance(&truth);
            worst = greater(worst, error);
        }
    }
    assert_eq!(refused, 1);
    tolerance::CLOSED_FORM_SMALL_TOGETHER.check("several differences small together", worst);
}

/// e₃ counts as e₄ only if the difference is small compared with e₃ - 1 and e₃ - e₂, not only compared with e₄.
#[test]
fn e3_that_is_e4_only_beside_one_is_refused() {
    let json = vectors::json("closed_forms.json");
    let case = &json["cases"][0];
    let refusal = ClosedForm::of(&motion(case)).unwrap_err();
    assert!(refusal.e3_minus_e4.abs() < 1e-16 && refusal.e3_minus_e4 != 0.0, "{refusal}");
    let text = refusal.to_string();
    assert!(text.contains("e3 = e4") && text.contains("e-17") && !text.contains('\n'), "{text}");
}

/// Where e₃ and e₄ differ within the tolerance, the error per period is within the stated one.
#[test]
fn the_error_of_nearly_equal_e3_and_e4_is_bounded() {
    let mut worst = 0.0_f64;
    for e4 in [1.0 + 2_f64.powi(-10), 1.125, 1.5, 3.0, 64.0] {
        let spread = (e4 - 1.0) * (e4 + 1.0);
        for (units, pair) in [-3, -2, -1, 1, 2, 3].into_iter().flat_map(|units| {
            [[-0.4, 0.6], [-0.99, 0.99], [-0.3, 1.0], [0.9, 0.999], [-0.999, -0.99]].map(|pair| (units, pair))
        }) {
            // changes of A by units in the last place of A/(ps)
            let a = f64::from_bits((spread.to_bits() as i64 + units) as u64);
            let top = top_of([a, 0.8 * a, 1.0, 1.0], 1.0);
            for l_minus_n in [Sign::Plus, Sign::Minus] {
                let signs = Signs { l_plus_n: Sign::Plus, l_minus_n };
                let start = InitialPhases { theta: 0.9, arg_alpha: 0.7, arg_beta: -2.1 };
                let motion = Motion::from_branch_points(&top, [pair[0], pair[1], e4], signs, &start).unwrap();
                let form = E3EqualsE4::new(&motion).unwrap();
                let table = Ephemeris::<f64, 1024>::new(&motion, Tick::hertz(1 << 20).unwrap()).unwrap();
                for periods in [1e3, 1e6] {
                    let t = periods * form.period();
                    let error = form.at(t).orientation.distance(&table.at(t).orientation());
                    worst = greater(worst, error / periods);
                }
            }
        }
    }
    tolerance::CLOSED_FORM_NEARLY_EQUAL.check("per period", worst);
}

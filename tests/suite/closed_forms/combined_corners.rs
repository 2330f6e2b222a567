//! Closed forms where several differences of the branch points are small together, against 30 digits
//! (`tests/reference/closed_forms.py`, which uses no elliptic function) and against the ephemeris.

use toytop::{InitialPhases, Motion, Sign, Signs, Tick};
use toytop_closed_forms::{ClosedForm, E3EqualsE4};
use toytop_tests::vectors::{self, entries, number, orientation, triple};
use toytop_tests::{DIFFERENT, SAME, boxed, check, greater, top_of};

/// At every time of the reference, up to 1e7 s, the orientation has an error of a few roundings, for any small
/// differences. e₃ counts as e₄ only if the difference is small compared with e₃ - 1 and e₃ - e₂, not only compared with e₄.
#[test]
fn nothing_is_lost_where_several_differences_are_small() {
    let (mut worst, mut refused) = (0.0_f64, 0);
    for case in entries(&vectors::json("closed_forms.json")["cases"]) {
        let [l_plus_n, l_minus_n] =
            [0, 1].map(|i| if number(&case["signs"][i]) > 0.0 { Sign::Plus } else { Sign::Minus });
        let [theta, arg_alpha, arg_beta] = ["theta", "arg_alpha", "arg_beta"].map(|key| number(&case[key]));
        let (signs, start) = (Signs { l_plus_n, l_minus_n }, InitialPhases { theta, arg_alpha, arg_beta });
        let top = vectors::top(case);
        let motion = Motion::from_branch_points(&top, triple(&case["e"]), signs, &start).unwrap();
        let form = ClosedForm::of(&motion);
        if case["refused"] == true {
            let refusal = form.unwrap_err();
            assert_eq!((refusal.e3, Some(refusal.e4)), (motion.branch_points().e3, top.e4()));
            assert!(refusal.e3_minus_e4.abs() < 1e-16 && refusal.e3_minus_e4 != 0.0, "{refusal}");
            let text = refusal.to_string();
            assert!(text.contains("e3 = e4") && text.contains("e-17") && !text.contains('\n'), "{text}");
            refused += 1;
            continue;
        }
        for sample in entries(&case["samples"]) {
            let ours = form.unwrap().at(number(&sample["t"])).orientation;
            worst = greater(worst, ours.distance(&orientation(sample)));
        }
    }
    assert_eq!(refused, 1);
    check("several differences small together", worst, 1e-15);
}

/// Where e₃ and e₄ differ within the tolerance, the error per period is within the stated one.
#[test]
fn the_error_of_nearly_equal_e3_and_e4_is_bounded() {
    let mut worst = 0.0_f64;
    let pairs = [[-0.4, 0.6], [-0.99, 0.99], [-0.3, 1.0], [0.9, 0.999], [-0.999, -0.99]];
    for (e4, [e1, e2]) in
        [1.0 + 2_f64.powi(-10), 1.125, 1.5, 3.0, 64.0].into_iter().flat_map(|e4| pairs.map(|pair| (e4, pair)))
    {
        // changes of A by units in the last place of A/(ps)
        let spread = ((e4 - 1.0) * (e4 + 1.0)).to_bits() as i64;
        for (a, signs) in [-3, -2, -1, 1, 2, 3]
            .into_iter()
            .flat_map(|units| [SAME, DIFFERENT].map(|signs| (f64::from_bits((spread + units) as u64), signs)))
        {
            let start = InitialPhases { theta: 0.9, arg_alpha: 0.7, arg_beta: -2.1 };
            let top = top_of([a, 0.8 * a, 1.0, 1.0], 1.0);
            let motion = Motion::from_branch_points(&top, [e1, e2, e4], signs, &start).unwrap();
            let form = E3EqualsE4::new(&motion).unwrap();
            let table = boxed::<f64, 1024>(&motion, Tick::hertz(1 << 20).unwrap());
            for periods in [1e3, 1e6] {
                let t = periods * form.period();
                let error = form.at(t).orientation.distance(&table.at(t).orientation());
                worst = greater(worst, error / periods);
            }
        }
    }
    check("per period", worst, 5e-14);
}

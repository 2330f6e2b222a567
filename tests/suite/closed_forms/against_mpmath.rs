//! Closed forms are compared with references that use no code of core, and the difference of e₃ and e₄ that they allow with its stated error.

use serde_json::Value;
use toytop::{InitialAngles, Motion, Sign, Signs, Tick};
use toytop_closed_forms::{ClosedForm, EllipticNutation};
use toytop_tests::vectors::{self, entries, number, orientation, triple};
use toytop_tests::{DIFFERENT, SAME, check, greater, table_of, tolerance, top_of};

/// Motion of a case of a reference file.
fn motion(case: &Value) -> Motion {
    let [l_plus_n, l_minus_n] =
        [0, 1].map(|i| if number(&case["signs"][i]) > 0.0 { Sign::Plus } else { Sign::Minus });
    let [theta, arg_alpha, arg_beta] = ["theta", "arg_alpha", "arg_beta"].map(|key| number(&case[key]));
    let (signs, start) = (Signs { l_plus_n, l_minus_n }, InitialAngles { theta, arg_alpha, arg_beta });
    Motion::from_branch_points(&vectors::top(case), triple(&case["e"]), signs, &start).unwrap()
}

/// Greatest orientation error of the closed forms of a file, and its cases without a closed form.
fn compared(json: &Value) -> (f64, Vec<&Value>) {
    let (mut worst, mut refused) = (0.0_f64, Vec::new());
    for case in entries(&json["cases"]) {
        let Ok(form) = ClosedForm::from_motion(&motion(case)) else {
            refused.push(case);
            continue;
        };
        for sample in entries(&case["samples"]) {
            let ours = form.at(number(&sample["t"])).orientation;
            worst = greater(worst, ours.distance(&orientation(sample)));
        }
    }
    (worst, refused)
}

/// Sections 5.1 and 5.3: t, α and β are those of the paper's formulas with the printed errors corrected, at 50 digits
/// (`tests/reference/paper_formulas.py`).
#[test]
fn closed_forms_follow_the_papers_formulas() {
    let json = vectors::json("paper_formulas.json");
    let (worst, refused) = compared(&json);
    assert!(refused.is_empty());
    check("the paper's formulas", worst, tolerance::AGAINST_MPMATH_FORMULAS);
}

/// Where several differences of the branch points are small together (`tests/reference/closed_forms.py`, which uses no elliptic function),
/// up to 1e7 s, the orientation has an error of a few roundings. e₃ counts as e₄ only if the difference is small compared with e₃ - 1 and
/// e₃ - e₂, not only compared with e₄.
#[test]
fn nothing_is_lost_where_several_differences_are_small() {
    let json = vectors::json("closed_forms.json");
    let (worst, refused) = compared(&json);
    check(
        "several differences small together",
        worst,
        tolerance::AGAINST_MPMATH_SEVERAL_DIFFERENCES_SMALL_TOGETHER,
    );
    assert!(refused.len() == 1 && refused[0]["refused"] == true, "{refused:?}");
    let motion = motion(refused[0]);
    let refusal = ClosedForm::from_motion(&motion).unwrap_err();
    assert_eq!((refusal.e3, Some(refusal.e4)), (motion.branch_points().e3, motion.top().e4()));
    assert!(refusal.e3_minus_e4.abs() < 1e-16 && refusal.e3_minus_e4 != 0.0, "{refusal}");
    let text = refusal.to_string();
    assert!(text.contains("e3 = e4") && text.contains("e-17") && !text.contains('\n'), "{text}");
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
            let start = InitialAngles { theta: 0.9, arg_alpha: 0.7, arg_beta: -2.1 };
            let top = top_of([a, 0.8 * a, 1.0, 1.0], 1.0);
            let motion = Motion::from_branch_points(&top, [e1, e2, e4], signs, &start).unwrap();
            let form = EllipticNutation::new(&motion).unwrap();
            let table = table_of::<f64, 1024>(&motion, Tick::hertz(1 << 20).unwrap());
            for periods in [1e3, 1e6] {
                let t = periods * form.period();
                let error = form.at(t).orientation.distance(&table.at(t).orientation());
                worst = greater(worst, error / periods);
            }
        }
    }
    check("per period", worst, tolerance::AGAINST_MPMATH_PER_PERIOD);
}

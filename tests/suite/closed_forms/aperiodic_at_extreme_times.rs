//! Section 5.3, e₂ = e₃ = 1: the closed form is compared with its limit at extreme times, and the angle of its tip with the stepper.

use toytop::{Complex, InitialAngles, Motion, Sign, Signs, Stepper};
use toytop_closed_forms::Aperiodic;
use toytop_tests::{by_branch_points, top_of};

/// Where 1 - u has no correct digits, the axis is upright, the norm is 1, and α rotates at its final rate, (l/A +
/// τ)/2 = n/(2C).
#[test]
fn the_axis_is_upright_to_rounding_at_extreme_times() {
    let slid = top_of([1.25, 0.75, 0.5, 1.5], 3.0);
    for top in [top_of([1.25, 0.75, 0.0, 1.5], 3.0), slid, top_of([1.25, 1.25, 1.0, 1.0], 1.0)] {
        for (e1, sign) in [(-0.4, Sign::Plus), (0.8, Sign::Minus), (-1.0, Sign::Plus)] {
            let signs = Signs { l_plus_n: sign, l_minus_n: Sign::Plus };
            let motion = by_branch_points(&top, [e1, 1.0, 1.0], signs);
            let form = Aperiodic::new(&motion).unwrap();
            let rate = 0.5 * motion.first_integrals().n / top.axial_inertia();
            for sense in [1.0, -1.0] {
                for t in [60.0, 1e3, 1e6, 1e12, 1e15, 1e300].map(|t| sense * t) {
                    let attitude = form.at(t);
                    assert!((attitude.orientation.norm_squared() - 1.0).abs() < 1e-13, "{e1} {t}");
                    assert!(
                        (attitude.orientation.u() - 1.0).abs() < 1e-13 && attitude.udot().abs() < 1e-13,
                        "{e1} {t}"
                    );
                    assert!(attitude.omega().iter().all(|w| w.is_finite()), "{e1} {t}");
                }
                let turned = form.at(sense * 400.0).orientation.alpha
                    * form.at(sense * 300.0).orientation.alpha.conj();
                let (sine, cosine) = (sense * 100.0 * rate).sin_cos();
                assert!(
                    (turned - Complex::new(cosine, sine)).norm_squared() < 1e-24,
                    "{e1} {turned:?} {rate}"
                );
            }
        }
    }
}

/// The tip angle counts whole turns as the stepper does with its step of 0.01 s, and is the argument of αβ; the tip and its angle change together.
#[test]
fn the_tip_angle_counts_whole_turns() {
    let mut turns = 0.0_f64;
    for com_height in [0.0, 0.5, 30.0] {
        let top = top_of([1.25, 0.75, com_height, 1.5], 3.0);
        for (e1, sign, theta) in [
            (-0.4, Sign::Plus, 0.0),
            (-0.999, Sign::Minus, 1.0),
            (0.9, Sign::Plus, -3.0),
            (-1.0, Sign::Plus, 0.5),
        ] {
            let signs = Signs { l_plus_n: sign, l_minus_n: Sign::Plus };
            let start = InitialAngles { theta, arg_alpha: 0.3, arg_beta: 1.0 };
            let motion = Motion::from_branch_points(&top, [e1, 1.0, 1.0], signs, &start).unwrap();
            let form = Aperiodic::new(&motion).unwrap();
            assert!((2e-15..1e-13).contains(&form.error_bound()));
            for sense in [-1.0, 1.0] {
                let mut stepper = Stepper::<f64>::new(&motion);
                for step in 1..=3000 {
                    stepper.step(sense * 0.01);
                    if step % 30 > 0 {
                        continue;
                    }
                    let t = sense * 0.01 * f64::from(step);
                    let (angle, tip) = (form.tip_angle(t), form.tip(t));
                    let apart = (angle - stepper.tip_angle().unwrap()).to_radians();
                    assert!(apart.abs() < 1e-4, "{com_height} {e1} {t}: {apart:e}");
                    let direction = Complex::<f64>::cis(angle);
                    let across = tip.im * direction.re - tip.re * direction.im;
                    assert!(across.abs() < 1e-13 * (1.0 + com_height), "{com_height} {e1} {t}: {across:e}");
                    turns = turns.max(angle.to_turns().abs());
                }
            }
        }
    }
    assert!(turns > 3.0, "{turns}");
}

//! Motions with a vertical axis, and those that rise to the vertical or leave it, are compared with their exact borders and limits.

use toytop::{
    BranchPoints, Complex, InitialAngles, Motion, Orientation, Regime, State, Stepper, Top, TopParameters,
};
use toytop_tests::random::Random;
use toytop_tests::{SAME, by_branch_points, released_from_rest, top_of, vectors};

/// Regime and branch points of an upright axis that spins at this rate.
fn asleep(top: &Top, spin: f64) -> (Regime, BranchPoints) {
    let motion = released_from_rest(top, 0.0, spin);
    (motion.regime(), motion.branch_points())
}

/// On the border n² = 4 A p g all three branch points are 1, their differences are 0 (and not -0), and the top sleeps
/// stably. One unit in the last place of the spin below, it is unstable; one unit above, e3 is above 1.
fn has_its_border_at(top: &Top, spin: f64) {
    let (regime, e) = asleep(top, spin);
    assert_eq!(regime, Regime::SleepingStable, "{top:?}, {spin}");
    assert_eq!([e.e1, e.e2, e.e3, e.one_plus_e1], [1.0, 1.0, 1.0, 2.0], "{top:?}, {spin}: {e:?}");
    let differences = [e.one_minus_e2, e.e2_minus_e1, e.e3_minus_e2, e.e3_minus_one];
    assert_eq!(differences.map(f64::to_bits), [0; 4], "{top:?}, {spin}: {e:?}");

    let unit = spin.next_up() - spin;
    let (regime, e) = asleep(top, spin + unit);
    // n²/(2Apg) - 1 = 1 + 4 δ, with δ = unit/spin, to first order
    let gap = 4.0 * unit / spin;
    assert_eq!((regime, e.e1, e.e2_minus_e1), (Regime::SleepingStable, 1.0, 0.0), "{top:?}, {spin}");
    assert!((e.e3_minus_one / gap - 1.0).abs() < 1e-15 && e.e3 > 1.0, "{:e} {gap:e}", e.e3_minus_one);
    let below = spin.next_down();
    let (regime, e) = asleep(top, below);
    let gap = 4.0 * (spin - below) / spin;
    assert_eq!((regime, e.e3, e.e3_minus_one), (Regime::SleepingUnstable, 1.0, 0.0), "{top:?}, {spin}");
    assert!((e.e2_minus_e1 / gap - 1.0).abs() < 1e-15 && e.e1 < 1.0, "{:e} {gap:e}", e.e2_minus_e1);
}

/// Borders whose numbers have 53 significant bits, and n² and 4 A p g two or four times as many: A = m 2^i, C = m, g
/// = s 2^j and p = m s, so that ω = s 2^(1 + (i + j)/2) is exactly on the border.
#[test]
fn the_border_of_sleep_is_exact_in_long_numbers() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut draw = || {
        let bits = random.bits();
        f64::from_bits((1023 << 52) | (bits >> 12)) * 2_f64.powi((bits >> 3) as i32 % 9 - 4)
    };
    for k in 0..4000_i32 {
        let (mass, s) = (draw(), draw());
        let (i, j) = (k % 5, (k % 5) + 2 * (k / 5 % 4) - 2);
        let [a, g] = [mass * 2_f64.powi(i), s * 2_f64.powi(j)];
        let top = Top::sliding(&TopParameters {
            transverse_inertia: a,
            axial_inertia: mass,
            com_height: s,
            mass,
            gravity: g,
            ..TopParameters::default()
        })
        .unwrap();
        has_its_border_at(&top, s * 2_f64.powi(1 + (i + j) / 2));
    }
}

#[test]
fn the_border_of_sleep_has_no_period() {
    let border = by_branch_points(&top_of([1.1, 0.8, 0.6, 0.9], 1.0), [1.0; 3], SAME);
    assert_eq!((border.regime(), border.period_advance()), (Regime::SleepingStable, None));
}

/// Sections 3.2 and 5.2: at e₂ = e₃ = 1 two motions have the same l, n and h, and u' = 0 at u = 1 for both. One stays there, asleep; the
/// other descends to e₁ and returns in infinite time. θ = π, in several forms of the angle, tells them apart.
#[test]
fn at_a_double_root_u_may_stay_or_leave() {
    let motion = |theta: f64| {
        let start = InitialAngles { theta, arg_alpha: 0.3, ..InitialAngles::default() };
        let top = top_of([1.1, 0.8, 0.6, 0.9], 1.0);
        Motion::from_branch_points(&top, [-0.2, 1.0, 1.0], SAME, &start).unwrap()
    };
    let pi = std::f64::consts::PI;
    // the last is the f64 nearest to 11 π, and not 11 times the f64 nearest to π
    for theta in [pi, -pi, 3.0 * pi, 34.55751918948773] {
        let sleeping = motion(theta);
        assert_eq!(sleeping.regime(), Regime::SleepingUnstable, "{theta}");
        assert_eq!(Stepper::<f64>::new(&sleeping).attitude_state().orientation.u(), 1.0);
        for theta in [0.0, 1.0, pi - 1e-12, -3.0] {
            let falling = motion(theta);
            assert_eq!(falling.regime(), Regime::Aperiodic, "{theta}");
            assert_eq!(falling.first_integrals(), sleeping.first_integrals());
            assert_eq!(falling.branch_points(), sleeping.branch_points());
        }
    }
}

/// The aperiodic motion comes from the vertical and rises to it, at any time.
#[test]
fn an_aperiodic_motion_rises_to_the_vertical_and_returns() {
    let motion = vectors::motion("aperiodic_AneC");
    let mut stepper = Stepper::<f64>::new(&motion);
    (0..40_000).for_each(|_| stepper.step(0.01));
    assert!(stepper.attitude_state().orientation.u() > 1.0 - 4e-16);
    (0..40_000).for_each(|_| stepper.step(-0.01));
    assert!(
        (stepper.attitude_state().orientation.u() - motion.branch_points().e1).abs() < 1e-10,
        "back at e1"
    );
}

/// A motion in a plane, from the horizontal, with exactly the energy to reach the vertical: it rises at once, or falls
/// first and rises on the other side.
#[test]
fn a_horizontal_aperiodic_launch_reaches_the_vertical() {
    let top = top_of([1.0, 0.5, 1.0, 1.0], 1.0);
    let half = Complex::new(std::f64::consts::FRAC_1_SQRT_2, 0.0);
    for rising in [1.0, -1.0] {
        let state = State::new(Orientation { alpha: half, beta: -half }, [0.0, -rising, 0.0]).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        assert_eq!(motion.regime(), Regime::Aperiodic);
        let mut stepper = Stepper::<f64>::new(&motion);
        assert!(
            stepper.attitude_state().orientation.u().abs() < 1e-15
                && (stepper.attitude_state().udot() - rising).abs() < 1e-15,
            "{stepper:?}"
        );
        (0..1000).for_each(|_| stepper.step(0.02));
        assert!(
            1.0 - stepper.attitude_state().orientation.u() < 1e-3,
            "{}",
            stepper.attitude_state().orientation.u()
        );
    }
}

/// Pendulum on its separatrix, which does not rotate about the vertical: α changes sign between the distant past and
/// the distant future.
#[test]
fn alpha_changes_sign_between_past_and_future_of_a_separatrix() {
    let motion = by_branch_points(&top_of([1.25, 0.75, 0.5, 1.5], 3.0), [-1.0, 1.0, 1.0], SAME);
    let mut stepper = Stepper::<f64>::new(&motion);
    stepper.step(-1e300);
    let before = stepper.orientation();
    stepper.step(1e301);
    let after = stepper.orientation();
    assert!(after.alpha.re * before.alpha.re < -0.999, "{before:?} {after:?}");
    assert!(after.u() > 0.999 && before.u() > 0.999);
}

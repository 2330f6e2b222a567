//! An axis that is vertical, and one that rises to it or leaves it: asleep, ready to fall, through it, on its way for ever.

use super::{downward, stays_finite, top, upright};
use toytop::{
    BranchPoints, Complex, Ephemeris, Heaviness, Motion, Phi, Regime, Signs, Start, State, Stepper, Tick,
    TipClass, Top,
};
use toytop_tests::{greater, orientation_error, tolerance, vectors};

/// Upright: asleep above the border n² = 4 A p g, and ready to fall below it.
#[test]
fn sleep_has_its_border_where_the_paper_has_it() {
    let border = (4.0 * 1.1 * 0.9_f64).sqrt() / 0.8;
    assert_eq!(upright([0.0, 0.0, 1.0001 * border]).regime(), Regime::SleepingStable);
    assert_eq!(upright([0.0, 0.0, 0.9999 * border]).regime(), Regime::SleepingUnstable);
    assert_eq!(upright([0.0, 0.0, 0.0]).regime(), Regime::SleepingUnstable);
    assert_eq!(downward([0.0, 0.0, 7.0]).regime(), Regime::Hanging);
    // a sleeping top just spins: α = e^{iωt/2}
    for spin in [3.0, 0.5] {
        let mut stepper = Stepper::<f64>::new(&upright([0.0, 0.0, spin]));
        stepper.step(2.0);
        let truth = Phi { alpha: Complex::new(spin.cos(), spin.sin()), beta: Complex::ZERO };
        assert!(orientation_error(stepper.phi(), truth) < 4e-16);
    }
}

/// Exactly vertical and moving: through the vertical in the direction of ω × k, and no other.
#[test]
fn a_vertical_start_leaves_in_the_direction_it_moves() {
    for motion in [upright([0.0, 0.5, 3.0]), downward([0.0, 0.5, 3.0])] {
        assert_eq!((motion.regime(), motion.tip_class()), (Regime::Nutating, TipClass::ThroughOrigin));
        let mut stepper = Stepper::<f64>::new(&motion);
        let pose = stepper.pose();
        assert!(pose.u().abs() == 1.0);
        for (ours, given) in pose.omega().iter().zip([0.0, 0.5, 3.0]) {
            assert!((ours - given).abs() < 1e-15);
        }
        // r' = ω × r = ±(0.5, 0, 0); the tip is at -s r
        let small = 1e-6;
        stepper.step(small);
        let [r1, r2, u] = stepper.phi().axis();
        assert!((r1 / (0.5 * small * u) - 1.0).abs() < 1e-5 && (r2 / r1).abs() < 1e-5, "{r1} {r2} {u}");
    }
}

/// e2 = e3 = 1 at θ = π, in any of the forms that an angle has: asleep, and ready to fall.
#[test]
fn the_sleeping_top_by_branch_points() {
    let pi = std::f64::consts::PI;
    for theta in [pi, -pi, 3.0 * pi] {
        let start = Start { theta, arg_alpha: 0.3, ..Start::default() };
        let motion = Motion::from_branch_points(&top(), [-0.2, 1.0, 1.0], Signs::default(), &start).unwrap();
        assert_eq!(motion.regime(), Regime::SleepingUnstable, "{theta}");
    }
    let mut worst = 0.0_f64;
    for theta in [0.0, 1.0, pi - 1e-12, -3.0] {
        let start = Start { theta, ..Start::default() };
        let motion = Motion::from_branch_points(&top(), [-0.2, 1.0, 1.0], Signs::default(), &start).unwrap();
        assert_eq!(motion.regime(), Regime::Aperiodic, "{theta}");
        stays_finite::<f64>(&motion);
        // at the far end of the rise the table has nothing left to say: it and the stepper agree before and after
        let ephemeris = Ephemeris::<f64, 1024, 12>::new(&motion, Tick::hertz(100).unwrap()).unwrap();
        for direction in [1.0, -1.0] {
            let mut stepper = Stepper::<f64>::new(&motion);
            for n in 1..=6000_i64 {
                stepper.step(0.01 * direction);
                if n % 500 == 0 {
                    let phi = ephemeris.at_tick(n * direction as i64).phi();
                    worst = greater(worst, orientation_error(phi, stepper.phi()));
                }
            }
        }
    }
    tolerance::RISE_STEPPER.check("table against stepper", worst);
}

/// The aperiodic motion rises to the vertical and comes from it, for however long.
#[test]
fn aperiodic_for_ever() {
    let motion = vectors::named("aperiodic_AneC").motion().unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    for _ in 0..40_000 {
        stepper.step(0.01);
    }
    assert!(stepper.pose().u() > 1.0 - 4e-16);
    for _ in 0..40_000 {
        stepper.step(-0.01);
    }
    assert!(
        (stepper.pose().u() - motion.branch_points().e1).abs() < 1e-10,
        "back at e1 after 400 time units each way"
    );
}

/// In a plane, from the horizontal, as fast as takes it to the vertical: it is on its way up, or was just so on its way down.
#[test]
fn an_aperiodic_launch_from_half_way() {
    let top = Top::sliding(1.0, 0.5, 1.0, Heaviness::MassMoment(1.0), 1.0).unwrap();
    let half = Complex::new(std::f64::consts::FRAC_1_SQRT_2, 0.0);
    for rising in [1.0, -1.0] {
        let state = State::new(Phi { alpha: half, beta: -half }, [0.0, -rising, 0.0]).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        assert_eq!(motion.regime(), Regime::Aperiodic);
        let mut stepper = Stepper::<f64>::new(&motion);
        let pose = stepper.pose();
        assert!(
            pose.u().abs() < 1e-15 && (pose.udot() - rising).abs() < 1e-15,
            "{} {}",
            pose.u(),
            pose.udot()
        );
        (0..1000).for_each(|_| stepper.step(0.02));
        assert!(1.0 - stepper.pose().u() < 1e-3, "{}", stepper.pose().u());
    }
}

/// The differences at rest upright, where two branch points are 1 whatever the spin.
#[test]
fn the_branch_points_of_an_upright_axis() {
    for spin in [5.0, 0.5] {
        let state = State::new(Phi::IDENTITY, [0.0, 0.0, spin]).unwrap();
        let e = BranchPoints::of(&top(), &state).unwrap();
        let sleeps = spin > 1.0;
        assert_eq!([e.e1 == 1.0, e.e2 == 1.0, e.e3 == 1.0], [sleeps, true, !sleeps]);
        let differences = [e.e2_minus_e1, e.one_minus_e2, e.e3_minus_one, e.one_plus_e1, e.e3_minus_e2];
        let expected = [1.0 - e.e1, 0.0, e.e3 - 1.0, 1.0 + e.e1, e.e3 - 1.0];
        let close =
            differences.iter().zip(expected).all(|(ours, theirs)| (ours - theirs).abs() < 1e-15 * e.e3);
        assert!(close, "{e:?}");
    }
}

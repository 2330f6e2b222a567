//! Every kind of motion is recognised and computed without NaN.

use toytop::scalar::Real;
use toytop::{
    Complex, InitialPhases, Motion, Orientation, Regime, Release, Sign, Signs, State, Stepper, TipClass, Top,
    TopParameters,
};
use toytop_tests::{by_branch_points, top_of, vectors};

pub(super) fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 1.0)
}

pub(super) fn upright(omega: [f64; 3]) -> Motion {
    Motion::launch(&top(), &State::new(Orientation::IDENTITY, omega).unwrap()).unwrap()
}

pub(super) fn downward(omega: [f64; 3]) -> Motion {
    let phi = Orientation { alpha: Complex::ZERO, beta: Complex::new(0.0, 1.0) };
    Motion::launch(&top(), &State::new(phi, omega).unwrap()).unwrap()
}

pub(super) fn stays_finite<R: Real>(motion: &Motion) {
    let mut stepper = Stepper::<R>::new(motion);
    for dt in [1e-3, 0.1, -0.3, 2.0, 50.0, -1e4, 1e9, -1e9, 0.0] {
        for _ in 0..20 {
            stepper.step(R::from_f64(dt));
            let (attitude, tip) = (stepper.attitude_state(), stepper.tip());
            let norm = attitude.orientation.norm_squared().to_f64();
            assert!((norm - 1.0).abs() < 1e-6, "{:?}: norm {norm}", motion.regime());
            assert!(attitude.omega().iter().all(|w| w.to_f64().is_finite()), "{:?}", motion.regime());
            let speed = stepper.tip_velocity().modulus();
            assert!(speed.to_f64().is_finite() && tip.modulus().to_f64().is_finite());
            assert!(stepper.tip_angle_rate().to_f64().is_finite());
        }
    }
}

#[test]
fn every_regime_is_recognised() {
    let expected = [
        ("generic_AneC", Regime::Nutating, TipClass::Loops),
        ("regular_precession", Regime::SlowPrecession, TipClass::Circle),
        ("regular_precession_fast", Regime::FastPrecession, TipClass::Circle),
        ("sleeping_stable", Regime::SleepingStable, TipClass::Point),
        ("sleeping_unstable", Regime::SleepingUnstable, TipClass::Point),
        ("hanging", Regime::Hanging, TipClass::Point),
        ("aperiodic", Regime::Aperiodic, TipClass::Spiral),
    ];
    for (name, regime, class) in expected {
        let motion = vectors::motion(name);
        assert_eq!((motion.regime(), motion.tip_class()), (regime, class), "{name}");
    }
}

#[test]
fn no_regime_gives_anything_but_numbers() {
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        stays_finite::<f64>(&motion);
        stays_finite::<f32>(&motion);
    }
    for omega in
        [[0.0; 3], [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], [0.3, 0.0, 0.0], [1e-9, -2e-9, 3.0], [2.0, 1.0, -4.0]]
    {
        for motion in [upright(omega), downward(omega)] {
            stays_finite::<f64>(&motion);
            stays_finite::<f32>(&motion);
        }
    }
    // border of sleep, n² = 4 A p g: all three branch points are 1
    let (scale, border) = (top(), [1.0, 1.0, 1.0]);
    let motion = by_branch_points(&scale, border, Signs::default());
    assert_eq!(motion.regime(), Regime::SleepingStable);
    assert_eq!(motion.period_advance(), None);
    stays_finite::<f64>(&motion);
}

/// Whether an oscillation counts depends on the tilt; an oscillation through the vertical always counts.
#[test]
fn a_small_swing_is_seen_where_the_tilt_is_small() {
    let between = |e1: f64, e2: f64| {
        let motion =
            Motion::from_branch_points(&top(), [e1, e2, 3.0], Signs::default(), &InitialPhases::default());
        motion.unwrap().regime()
    };
    let unit = 0.5 * f64::EPSILON;
    // sine of the tilt 1.4e-5, then 1: the tilt oscillates by 8e-12 rad and by 1e-16 rad
    assert_eq!(between(1.0 - 1e-10, 1.0 - 1e-10 + unit), Regime::Nutating);
    assert!(between(0.0, unit).is_regular_precession());
    // the tilt oscillates by about 1e-20 rad
    assert_eq!(upright([1e-20, 0.0, 5.0]).regime(), Regime::Nutating);
    assert_eq!(upright([0.0, 0.0, 5.0]).regime(), Regime::SleepingStable);
}

#[test]
fn steps_that_are_no_numbers_do_nothing() {
    for name in ["generic_AneC", "aperiodic", "regular_precession"] {
        let mut stepper = Stepper::<f64>::new(&vectors::motion(name));
        stepper.step(0.1);
        let before = stepper;
        for dt in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            stepper.step(dt);
            assert_eq!(stepper, before, "{name}, dt = {dt}");
        }
    }
}

/// A state of a regular precession, rounded to f64, is recognised as one; a visible nutation is not.
#[test]
fn regular_precession_is_recognised_from_a_rounded_state() {
    for name in ["regular_precession", "regular_precession_fast"] {
        let vector = vectors::named(name);
        let motion = Motion::launch(&vector.top(), &vector.state()).unwrap();
        assert_eq!(motion.regime(), vector.motion().unwrap().regime());
    }
    let vector = vectors::named("tiny_nutation");
    assert_eq!(Motion::launch(&vector.top(), &vector.state()).unwrap().regime(), Regime::Nutating);
}

/// The integrals of steady and of vertical motions are accepted with any rounding, although they are on the border of
/// the possible ones.
#[test]
fn the_integrals_of_degenerate_motions_are_accepted() {
    for e in [
        [0.3, 0.3, 2.0],
        [-0.7, -0.7, 1.01],
        [-1.0, -1.0, 2.0],
        [1.0, 1.0, 3.0],
        [0.5, 1.0, 1.0],
        [-1.0, 0.5, 2.0],
        [-0.5, 1.0, 2.0],
        [-1.0, 1.0, 2.0],
    ] {
        let given = toytop::BranchPoints::new(e[0], e[1], e[2]).unwrap();
        for l_minus_n in [Sign::Plus, Sign::Minus] {
            for mass_moment in [0.9, 0.1, 12.345] {
                let top = top_of([1.1, 0.8, 0.6, mass_moment], 1.0);
                let integrals = given.integrals(&top, Signs { l_minus_n, ..Signs::default() });
                let toytop::FirstIntegrals { l, n, h, .. } = integrals;
                let again = toytop::BranchPoints::from_integrals(&top, l, n, h).unwrap();
                // half of the digits of a double root are correct
                for (x, y) in [again.e1, again.e2, again.e3].into_iter().zip(e) {
                    assert!((x - y).abs() < 1e-7, "{x} {y}");
                }
            }
        }
    }
}

/// A θ that is the `f64` nearest to a multiple of π counts as that multiple: u' at a turning point is 0 and not
/// 1e-16.
#[test]
fn rounded_multiples_of_pi_are_turning_points() {
    for k in -4..5 {
        let start = InitialPhases { theta: f64::from(k) * std::f64::consts::PI, ..InitialPhases::default() };
        let motion = Motion::from_branch_points(&top(), [-0.25, 0.5, 2.0], Signs::default(), &start).unwrap();
        let attitude = Stepper::<f64>::new(&motion).attitude_state();
        let end = if k % 2 == 0 { -0.25 } else { 0.5 };
        assert!(
            attitude.udot() == 0.0 && (attitude.u() - end).abs() < 1e-15,
            "{k}: {} {}",
            attitude.u(),
            attitude.udot()
        );
    }
}

/// A top released from rest has cusps, at any tilt and spin, in SI units, with any rounding of its state.
#[test]
fn a_top_let_go_has_cusps() {
    let top = Top::sliding(&TopParameters {
        transverse_inertia: 3e-5,
        axial_inertia: 2e-5,
        com_height: 0.03,
        mass: 0.05,
        gravity: 9.81,
        ..TopParameters::default()
    })
    .unwrap();
    for i in 1..200 {
        let x = f64::from(i);
        let release =
            Release { tilt: 0.015 * x, spin: 3.0 * x, azimuth: x, roll: 2.0 * x, ..Release::default() };
        let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
        assert_eq!(motion.tip_class(), TipClass::Cusp, "tilt {} spin {}", release.tilt, release.spin);
    }
}

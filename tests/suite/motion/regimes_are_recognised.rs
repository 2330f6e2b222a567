//! Regimes are compared with those that motions of every kind must have, and no motion gives NaN.

use toytop::{
    BranchPoints, Complex, FirstIntegrals, InitialAngles, Motion, Orientation, Regime, Release, State,
    Stepper, TipClass, Top,
};
use toytop_closed_forms::RegularPrecession;
use toytop_tests::fuzz_targets::invariants;
use toytop_tests::{DIFFERENT, SAME, SIGNS, by_branch_points, released, top_of, toy, vectors};

fn top() -> Top {
    top_of([1.1, 0.8, 0.6, 0.9], 1.0)
}

fn upright(omega: [f64; 3]) -> Motion {
    Motion::launch(&top(), &State::new(Orientation::IDENTITY, omega).unwrap()).unwrap()
}

#[test]
fn every_regime_is_recognised() {
    let expected = [
        ("generic_AneC", Regime::Nutating),
        ("regular_precession", Regime::SlowPrecession),
        ("regular_precession_fast", Regime::FastPrecession),
        ("sleeping_stable", Regime::SleepingStable),
        ("sleeping_unstable", Regime::SleepingUnstable),
        ("hanging", Regime::Hanging),
        ("aperiodic", Regime::Aperiodic),
    ];
    for (name, regime) in expected {
        assert_eq!(vectors::motion(name).regime(), regime, "{name}");
    }
}

/// With e₃ = 1 a regular precession has l = n, and the sign of l - n = 0 does not matter.
#[test]
fn a_regular_precession_with_equal_momenta_is_the_faster_one() {
    for signs in SIGNS {
        let motion = by_branch_points(&top(), [0.3, 0.3, 1.0], signs);
        let FirstIntegrals { l, n, .. } = motion.first_integrals();
        assert_eq!((l, motion.regime()), (n, Regime::FastPrecession));
    }
}

#[test]
fn every_regime_gives_finite_numbers() {
    let steps = [1e-3, 0.1, -0.3, 2.0, 50.0, -1e4, 1e9, -1e9, 0.0].map(|dt| [dt; 20]).concat();
    let mut motions: Vec<Motion> = vectors::all().iter().map(|vector| vector.motion().unwrap()).collect();
    let downward = Orientation { alpha: Complex::ZERO, beta: Complex::new(0.0, 1.0) };
    for omega in
        [[0.0; 3], [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], [0.3, 0.0, 0.0], [1e-9, -2e-9, 3.0], [2.0, 1.0, -4.0]]
    {
        let hanging = Motion::launch(&top(), &State::new(downward, omega).unwrap()).unwrap();
        motions.extend([upright(omega), hanging]);
    }
    // border of sleep: all three branch points are 1
    motions.push(by_branch_points(&top(), [1.0; 3], SAME));
    for motion in motions {
        invariants::stepper::<f64>(&motion, &steps, 1e-13);
        invariants::stepper::<f32>(&motion, &steps, 2e-6);
    }
}

/// Whether an oscillation counts depends on the tilt; an oscillation through the vertical always counts.
#[test]
fn a_small_oscillation_counts_where_the_tilt_is_small() {
    let between = |e1: f64, e2: f64| by_branch_points(&top(), [e1, e2, 3.0], SAME).regime();
    let unit = 0.5 * f64::EPSILON;
    // sine of the tilt 1.4e-5, then 1: the tilt oscillates by 8e-12 rad and by 1e-16 rad
    assert_eq!(between(1.0 - 1e-10, 1.0 - 1e-10 + unit), Regime::Nutating);
    assert!(between(0.0, unit).is_regular_precession());
    // the tilt oscillates by about 1e-20 rad
    assert_eq!(upright([1e-20, 0.0, 5.0]).regime(), Regime::Nutating);
    assert_eq!(upright([0.0, 0.0, 5.0]).regime(), Regime::SleepingStable);
}

#[test]
fn steps_that_are_not_finite_do_nothing() {
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
        assert!(RegularPrecession::new(&motion).is_some());
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
        for (signs, mass_moment) in
            [SAME, DIFFERENT].into_iter().flat_map(|signs| [0.9, 0.1, 12.345].map(|p| (signs, p)))
        {
            let top = top_of([1.1, 0.8, 0.6, mass_moment], 1.0);
            let FirstIntegrals { l, n, h, .. } = by_branch_points(&top, e, signs).first_integrals();
            let again = BranchPoints::from_integrals(&top, l, n, h).unwrap();
            // half of the digits of a double root are correct
            for (x, y) in [again.e1, again.e2, again.e3].into_iter().zip(e) {
                assert!((x - y).abs() < 1e-7, "{x} {y}");
            }
        }
    }
}

/// A rounded multiple of π counts as that multiple: u' at a turning point is 0 and not 1e-16.
#[test]
fn rounded_multiples_of_pi_are_turning_points() {
    for k in -4..5 {
        let start = InitialAngles { theta: f64::from(k) * std::f64::consts::PI, ..InitialAngles::default() };
        let motion = Motion::from_branch_points(&top(), [-0.25, 0.5, 2.0], SAME, &start).unwrap();
        let stepper = Stepper::<f64>::new(&motion);
        let (u, udot) = (stepper.attitude_state().orientation.u(), stepper.attitude_state().udot());
        let end = if k % 2 == 0 { -0.25 } else { 0.5 };
        assert!(udot == 0.0 && (u - end).abs() < 1e-15, "{k}: {u} {udot}");
    }
}

/// A top released from rest has cusps, at any tilt and spin, in SI units, with any rounding of its state.
#[test]
fn a_top_released_from_rest_has_cusps() {
    let top = toy();
    for x in (1..200).map(f64::from) {
        let release =
            Release { tilt: 0.015 * x, spin: 3.0 * x, azimuth: x, roll: 2.0 * x, ..Release::default() };
        assert_eq!(released(&top, &release).tip_class(), TipClass::Cusp, "{release:?}");
    }
}

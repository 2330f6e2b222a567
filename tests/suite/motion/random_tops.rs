//! Motions of random tops and states, with a fixed seed, are compared with the states and branch points that they were made of.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed};
use toytop::su2::{cross, dot};
use toytop::{
    BranchPoints, FirstIntegrals, InitialAngles, Motion, Orientation, Release, Signs, State, Stepper, Top,
};
use toytop_tests::{length, top_of};

pub(crate) fn config(cases: u32) -> Config {
    Config {
        cases,
        failure_persistence: None,
        rng_algorithm: RngAlgorithm::ChaCha,
        rng_seed: RngSeed::Fixed(0x0007_0770),
        ..Config::default()
    }
}

/// Numbers 10^x for x in a range.
fn decade(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|x| 10_f64.powf(x))
}

fn tops() -> impl Strategy<Value = Top> {
    (decade(-5.0..2.0), 0.01_f64..2.0, decade(-2.0..3.0), decade(-2.0..1.0), decade(-1.0..2.0)).prop_map(
        |(a, c_over_a, spread, s, g)| {
            // A/(ps) = spread
            top_of([a, a * c_over_a, s, a / (spread * s)], g)
        },
    )
}

/// Tops with releases whose rates are in units of √(p g/A).
fn releases() -> impl Strategy<Value = (Top, Release)> {
    let rate = || -4.0_f64..4.0;
    let angle = || -7.0_f64..7.0;
    (tops(), 0.0_f64..std::f64::consts::PI, angle(), angle(), rate(), rate(), rate()).prop_map(
        |(top, tilt, azimuth, roll, spin, precession, nutation)| {
            let unit = (top.mass_moment() * top.gravity() / top.transverse_inertia()).sqrt();
            let (spin, precession, nutation) = (spin * unit, precession * unit, nutation * unit);
            (top, Release { tilt, azimuth, roll, spin, precession, nutation })
        },
    )
}

proptest! {
    #![proptest_config(config(2000))]

    /// The orientation and rate of a launched motion at t = 0 are those of its state.
    #[test]
    fn a_launched_motion_starts_in_its_state((top, release) in releases()) {
        let state = State::from_release(&release).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let attitude = motion.attitude_at_launch();
        let error = attitude.orientation.distance(&state.orientation().normalised());
        prop_assert!(error < 1e-14, "orientation {error:e}");
        let size = state.omega().iter().fold(1e-300_f64, |size, w| size.max(w.abs()));
        for (ours, given) in attitude.omega().iter().zip(state.omega()) {
            prop_assert!((ours - given).abs() / size < 2e-14, "omega {ours} {given}");
        }
        let again = FirstIntegrals::from_state(&top, &State::new(attitude.orientation, attitude.omega()).unwrap());
        let first = motion.first_integrals();
        let scale = first.l.abs().max(first.n.abs()).max(1e-300);
        prop_assert!((again.l - first.l).abs() / scale < 2e-14);
        prop_assert!((again.n - first.n).abs() / scale < 2e-14);
    }

    /// A release is rolled, tilted and rotated by its azimuth; the axis moves at the given rates, and the rest of ω
    /// is along the axis.
    #[test]
    fn a_release_has_its_angles_and_rates((_, release) in releases()) {
        let state = State::from_release(&release).unwrap();
        let [roll, azimuth] = [release.roll, release.azimuth].map(|angle| Orientation::<f64>::exp([0.0, 0.0, angle]));
        let turned = azimuth.compose(&Orientation::exp([0.0, release.tilt, 0.0])).compose(&roll);
        prop_assert!(state.orientation().distance(&turned) < 1e-14);
        let ((sine, cosine), (y, x)) = (release.tilt.sin_cos(), release.azimuth.sin_cos());
        let axis = [sine * x, sine * y, cosine];
        let omega = state.omega();
        let size = length(omega) + release.nutation.abs() + release.precession.abs();
        prop_assert!((dot(omega, axis) - release.spin).abs() < 1e-14 * size);
        let turning = cross(omega, axis);
        let (tilting, going_round) = ([cosine * x, cosine * y, -sine], [-sine * y, sine * x, 0.0]);
        for i in 0..3 {
            prop_assert!((state.orientation().axis()[i] - axis[i]).abs() < 1e-15);
            let rate = release.nutation * tilting[i] + release.precession * going_round[i];
            prop_assert!((turning[i] - rate).abs() < 1e-14 * size, "{turning:?} {rate}");
        }
    }

    /// Branch points satisfy their definition: the products that equal those of l + n and l - n (equation (3.6)), and
    /// the sum. This holds for those of a state, and for those of its rounded integrals alone.
    #[test]
    fn branch_points_solve_their_equations((top, release) in releases()) {
        let state = State::from_release(&release).unwrap();
        let integrals = FirstIntegrals::from_state(&top, &state);
        let scale = integrals.l.abs().max(integrals.n.abs());
        let FirstIntegrals { l, n, h, .. } = integrals;
        let of_integrals = BranchPoints::from_integrals(&top, l, n, h).unwrap();
        for e in [Motion::launch(&top, &state).unwrap().branch_points(), of_integrals] {
            prop_assert!(-1.0 <= e.e1 && e.e1 <= e.e2 && e.e2 <= 1.0 && 1.0 <= e.e3);
            let again = e.integrals(&top, integrals.signs());
            prop_assert!((again.l_plus_n - integrals.l_plus_n).abs() < 1e-14 * scale);
            prop_assert!((again.l_minus_n - integrals.l_minus_n).abs() < 1e-14 * scale);
            prop_assert!((again.h - h).abs() < 1e-13 * h.abs().max(top.mass_moment() * top.gravity()));
        }
    }

    /// Near the vertical, up and down, with tilts and rates down to 1e-50, the motion starts in its state.
    #[test]
    fn a_motion_near_the_vertical_starts_in_its_state(
        top in tops(),
        tilt in decade(-50.0..-1.0),
        nudge in decade(-50.0..-1.0),
        (spin, angle, down) in (-4.0_f64..4.0, -3.0_f64..3.0, any::<bool>()),
    ) {
        let unit = (top.mass_moment() * top.gravity() / top.transverse_inertia()).sqrt();
        let near = toytop::Complex::new(0.5 * tilt * angle.cos(), 0.5 * tilt * angle.sin());
        let rest = (1.0 - 0.25 * tilt * tilt).sqrt();
        let far = toytop::Complex::new(rest * (2.0 * angle).cos(), rest * (2.0 * angle).sin());
        let (alpha, beta) = if down { (near, far) } else { (far, near) };
        let state = State::new(Orientation { alpha, beta }, [unit * nudge, 0.0, unit * spin]).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let e = motion.branch_points();
        prop_assert!(e.one_plus_e1 >= 0.0 && e.e2_minus_e1 >= 0.0 && e.one_minus_e2 >= 0.0 && e.e3_minus_e2 >= 0.0);
        prop_assert!((e.one_plus_e1 + e.e2_minus_e1 + e.one_minus_e2 - 2.0).abs() < 1e-15);
        prop_assert!(motion.period_advance().is_none_or(|advance| advance.period.is_finite()));
        let mut stepper = Stepper::<f64>::new(&motion);
        let attitude = stepper.attitude_state();
        prop_assert!(attitude.orientation.distance(&state.orientation().normalised()) < 1e-14);
        for (ours, given) in attitude.omega().iter().zip(state.omega()) {
            prop_assert!((ours - given).abs() < 1e-12 * unit * (1.0 + spin.abs()), "{ours:e} {given:e}");
        }
        for _ in 0..100 {
            stepper.step(0.01 / unit);
            prop_assert!((stepper.orientation().norm_squared() - 1.0).abs() < 2e-15);
        }
    }

    /// The documented coverage of the two predefined sizes holds.
    #[test]
    fn the_predefined_sizes_hold_their_motions((top, release) in releases()) {
        let motion = Motion::launch(&top, &State::from_release(&release).unwrap()).unwrap();
        let e = motion.branch_points();
        let spread = top.transverse_inertia() / (top.mass_moment() * top.com_height());
        prop_assume!(e.e3_minus_e2 >= 0.1 * e.e2_minus_e1 && spread >= 0.4);
        let unit = motion.period_advance().map_or(1.0, |advance| advance.period);
        let tick = toytop::Tick::hertz((1000.0 / unit).clamp(1.0, 1e9) as u32).unwrap();
        prop_assert!(toytop::TableF32::new(&motion, tick).is_ok());
        prop_assert!(toytop::TableF64::new(&motion, tick).is_ok());
        prop_assert!(spread < 1.0 || toytop::SizedTable::<f64, 32>::new(&motion, tick).is_ok());
    }

    /// Near every degenerate case a motion from branch points is finite, and its state gives the same branch points.
    #[test]
    fn a_state_has_the_branch_points_of_its_motion(
        top in tops(),
        (gap1, gap2, gap3, gap4) in (decade(-9.0..0.0), decade(-9.0..0.0), decade(-9.0..0.0), 0.0_f64..1.0),
        theta in -3.0_f64..3.0,
    ) {
        // 1 + e1, 1 - e2 and e3 - 1 are log-uniform; the remaining interval is divided at random
        let e1 = -1.0 + gap1 * (1.0 - gap4);
        let e2 = 1.0 - gap2 * gap4;
        let e3 = 1.0 + gap3;
        let start = InitialAngles { theta, ..InitialAngles::default() };
        let motion = Motion::from_branch_points(&top, [e1, e2, e3], Signs::default(), &start).unwrap();
        let attitude = motion.attitude_at_launch();
        prop_assert!(attitude.omega().iter().all(|w| w.is_finite()));
        let again = Motion::launch(&top, &State::new(attitude.orientation, attitude.omega()).unwrap()).unwrap().branch_points();
        let given = motion.branch_points();
        // a rounding of the state changes e3 - e2 by a rounding over e3 - e2
        let gap = given.e3_minus_e2;
        prop_assert!((again.e3_minus_e2 - gap).abs() * gap < 1e-12, "{gap:e} {:e}", again.e3_minus_e2);
        prop_assert!((again.e1 - given.e1).abs() < 1e-12 && (again.e2 - given.e2).abs() * gap < 1e-12);
    }
}

//! Random tops, states and steps, with a fixed seed.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, RngSeed};
use toytop::su2::dot;
use toytop::{
    BranchPoints, FirstIntegrals, Heaviness, Motion, Phi, Regime, Release, Signs, Start, State, Stepper, Top,
};
use toytop_tests::{orientation_error, tolerance};

pub(crate) fn config(cases: u32) -> Config {
    Config {
        cases,
        failure_persistence: None,
        rng_algorithm: RngAlgorithm::ChaCha,
        rng_seed: RngSeed::Fixed(0x0007_0770),
        ..Config::default()
    }
}

/// 10^x for x in a range.
fn decade(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|x| 10_f64.powf(x))
}

fn tops() -> impl Strategy<Value = Top> {
    (decade(-5.0..2.0), 0.01_f64..2.0, decade(-2.0..3.0), decade(-2.0..1.0), decade(-1.0..2.0)).prop_map(
        |(a, c_over_a, spread, s, g)| {
            // A/(ps) = spread
            Top::sliding(a, a * c_over_a, s, Heaviness::MassMoment(a / (spread * s)), g).unwrap()
        },
    )
}

/// Rates in units of √(p g/A).
fn releases() -> impl Strategy<Value = (Top, Release)> {
    let rate = || -4.0_f64..4.0;
    let angle = || -7.0_f64..7.0;
    (tops(), 0.0_f64..std::f64::consts::PI, angle(), angle(), rate(), rate(), rate()).prop_map(
        |(top, tilt, azimuth, roll, spin, precession, nutation)| {
            let unit = (top.p() * top.g() / top.a()).sqrt();
            let (spin, precession, nutation) = (spin * unit, precession * unit, nutation * unit);
            (top, Release { tilt, azimuth, roll, spin, precession, nutation })
        },
    )
}

proptest! {
    #![proptest_config(config(2000))]

    /// A launch reproduces the state it was launched from.
    #[test]
    fn state_to_constants_to_state((top, release) in releases()) {
        let state = State::release(&release).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let pose = Stepper::<f64>::new(&motion).pose();
        let error = orientation_error(pose.phi, state.phi().normalised());
        prop_assert!(error < 1e-14, "orientation {error:e}");
        let size = state.omega().iter().fold(1e-300_f64, |size, w| size.max(w.abs()));
        for (ours, given) in pose.omega().iter().zip(state.omega()) {
            prop_assert!((ours - given).abs() / size < tolerance::ROUND_TRIP.most, "omega {ours} {given}");
        }
        let again = FirstIntegrals::of(&top, &State::new(pose.phi, pose.omega()).unwrap());
        let first = motion.first_integrals();
        let scale = first.l.abs().max(first.n.abs()).max(1e-300);
        prop_assert!((again.l - first.l).abs() / scale < tolerance::ROUND_TRIP.most);
        prop_assert!((again.n - first.n).abs() / scale < tolerance::ROUND_TRIP.most);
    }

    /// A release is rolled, tilted, then turned; its axis turns as the rates say, and the rest of ω is along it.
    #[test]
    fn a_release_is_what_it_says((_, release) in releases()) {
        let state = State::release(&release).unwrap();
        let [roll, azimuth] = [release.roll, release.azimuth].map(|angle| Phi::<f64>::exp([0.0, 0.0, angle]));
        let turned = azimuth.compose(&Phi::exp([0.0, release.tilt, 0.0])).compose(&roll);
        prop_assert!(orientation_error(state.phi(), turned) < 1e-14);
        let ((sine, cosine), (y, x)) = (release.tilt.sin_cos(), release.azimuth.sin_cos());
        let axis = [sine * x, sine * y, cosine];
        let omega = state.omega();
        let size = dot(omega, omega).sqrt() + release.nutation.abs() + release.precession.abs();
        prop_assert!((dot(omega, axis) - release.spin).abs() < 1e-14 * size);
        let turning = [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            omega[j] * axis[k] - omega[k] * axis[j]
        });
        let (tilting, going_round) = ([cosine * x, cosine * y, -sine], [-sine * y, sine * x, 0.0]);
        for i in 0..3 {
            prop_assert!((state.phi().axis()[i] - axis[i]).abs() < 1e-15);
            let rate = release.nutation * tilting[i] + release.precession * going_round[i];
            prop_assert!((turning[i] - rate).abs() < 1e-14 * size, "{turning:?} {rate}");
        }
    }

    /// Branch points satisfy their definition: the products that are l + n and l - n (eqn:constants), and the sum; those of a
    /// state, and those of its rounded integrals, with which nothing else of the motion is known.
    #[test]
    fn branch_points_solve_their_equations((top, release) in releases()) {
        let state = State::release(&release).unwrap();
        let integrals = FirstIntegrals::of(&top, &state);
        let scale = integrals.l.abs().max(integrals.n.abs());
        let FirstIntegrals { l, n, h, .. } = integrals;
        let of_integrals = BranchPoints::from_integrals(&top, l, n, h).unwrap();
        for e in [BranchPoints::of(&top, &state).unwrap(), of_integrals] {
            prop_assert!(-1.0 <= e.e1 && e.e1 <= e.e2 && e.e2 <= 1.0 && 1.0 <= e.e3);
            let again = e.integrals(&top, integrals.signs());
            prop_assert!((again.l_plus_n - integrals.l_plus_n).abs() < 1e-14 * scale);
            prop_assert!((again.l_minus_n - integrals.l_minus_n).abs() < 1e-14 * scale);
            prop_assert!((again.h - h).abs() < 1e-13 * h.abs().max(top.p() * top.g()));
        }
    }

    /// Forward and back over steps of changing size, and unit norm all the way.
    #[test]
    fn there_and_back((top, release) in releases(), steps in prop::collection::vec(0.0_f64..1.0, 60)) {
        let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
        let unit = motion.averages().map_or(1.0, |averages| averages.period) / 4000.0;
        let mut stepper = Stepper::<f64>::new(&motion);
        let start = stepper.phi();
        for dt in &steps {
            stepper.step(dt * unit);
            prop_assert!((stepper.phi().norm_squared() - 1.0).abs() < 2e-15);
        }
        for dt in steps.iter().rev() {
            stepper.step(-dt * unit);
        }
        // the round trip of a fourth-order step is fifth order: it tells no error of the step itself
        prop_assert!(orientation_error(stepper.phi(), start) < 1e-9);
    }

    /// The period brings α and β back, up to the turns that `averages` says.
    #[test]
    fn one_period_brings_it_back((top, release) in releases()) {
        let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
        prop_assume!(motion.regime() == Regime::Nutating);
        let averages = motion.averages().unwrap();
        let mut stepper = Stepper::<f64>::new(&motion);
        let start = stepper.phi();
        let steps = 4096;
        (0..steps).for_each(|_| stepper.step(averages.period / f64::from(steps)));
        let turned = |turns: f64| toytop::Complex::<f64>::cis(toytop::Turns::new(turns));
        let expected = Phi {
            alpha: start.alpha * turned(averages.alpha_turns),
            beta: start.beta * turned(averages.beta_turns),
        };
        let gap = motion.branch_points().e3_minus_e2;
        let error = orientation_error(stepper.phi(), expected).min(orientation_error(stepper.phi(), Phi { alpha: -expected.alpha, beta: -expected.beta }));
        prop_assert!(error * gap.min(1.0) < 1e-6, "{error:e}, gap {gap:e}");
    }

    /// Near the vertical, both ways, by tilts and nudges down to 1e-50: the launch gives back its state.
    #[test]
    fn near_the_vertical(
        top in tops(),
        tilt in decade(-50.0..-1.0),
        nudge in decade(-50.0..-1.0),
        (spin, angle, down) in (-4.0_f64..4.0, -3.0_f64..3.0, any::<bool>()),
    ) {
        let unit = (top.p() * top.g() / top.a()).sqrt();
        let near = toytop::Complex::new(0.5 * tilt * angle.cos(), 0.5 * tilt * angle.sin());
        let rest = (1.0 - 0.25 * tilt * tilt).sqrt();
        let far = toytop::Complex::new(rest * (2.0 * angle).cos(), rest * (2.0 * angle).sin());
        let (alpha, beta) = if down { (near, far) } else { (far, near) };
        let state = State::new(Phi { alpha, beta }, [unit * nudge, 0.0, unit * spin]).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        let e = motion.branch_points();
        prop_assert!(e.one_plus_e1 >= 0.0 && e.e2_minus_e1 >= 0.0 && e.one_minus_e2 >= 0.0 && e.e3_minus_e2 >= 0.0);
        prop_assert!((e.one_plus_e1 + e.e2_minus_e1 + e.one_minus_e2 - 2.0).abs() < 1e-15);
        prop_assert!(motion.averages().is_none_or(|averages| averages.period.is_finite()));
        let mut stepper = Stepper::<f64>::new(&motion);
        let pose = stepper.pose();
        prop_assert!(orientation_error(pose.phi, state.phi().normalised()) < 1e-14);
        for (ours, given) in pose.omega().iter().zip(state.omega()) {
            prop_assert!((ours - given).abs() < 1e-12 * unit * (1.0 + spin.abs()), "{ours:e} {given:e}");
        }
        for _ in 0..100 {
            stepper.step(0.01 / unit);
            prop_assert!((stepper.phi().norm_squared() - 1.0).abs() < 2e-15);
        }
    }

    /// What the documentation of the two ready sizes says.
    #[test]
    fn ready_sizes_fit((top, release) in releases()) {
        let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
        let e = motion.branch_points();
        let spread = top.a() / (top.p() * top.s());
        prop_assume!(e.e3_minus_e2 >= 0.1 * e.e2_minus_e1 && spread >= 0.25);
        let unit = motion.averages().map_or(1.0, |averages| averages.period);
        let tick = toytop::Tick::hertz((1000.0 / unit).clamp(1.0, 1e9) as u32).unwrap();
        prop_assert!(toytop::EphemerisF32::new(&motion, tick).is_ok());
        prop_assert!(toytop::EphemerisF64::new(&motion, tick).is_ok());
        prop_assert!(spread < 1.0 || toytop::Ephemeris::<f64, 32, 11>::new(&motion, tick).is_ok());
    }

    /// Near every degenerate corner a launch from branch points is finite and its state leads back to them.
    #[test]
    fn branch_points_to_state_to_branch_points(
        top in tops(),
        (gap1, gap2, gap3, gap4) in (decade(-9.0..0.0), decade(-9.0..0.0), decade(-9.0..0.0), 0.0_f64..1.0),
        theta in -3.0_f64..3.0,
    ) {
        // 1 + e1, 1 - e2 and e3 - 1 log-uniform; the rest of [-1, 1] shared out
        let e1 = -1.0 + gap1 * (1.0 - gap4);
        let e2 = 1.0 - gap2 * gap4;
        let e3 = 1.0 + gap3;
        let start = Start { theta, ..Start::default() };
        let motion = Motion::from_branch_points(&top, [e1, e2, e3], Signs::default(), &start).unwrap();
        let pose = Stepper::<f64>::new(&motion).pose();
        prop_assert!(pose.omega().iter().all(|w| w.is_finite()));
        let again = BranchPoints::of(&top, &State::new(pose.phi, pose.omega()).unwrap()).unwrap();
        let given = motion.branch_points();
        // a rounding of the state moves e3 - e2 by a rounding over e3 - e2 itself
        let gap = given.e3_minus_e2;
        prop_assert!((again.e3_minus_e2 - gap).abs() * gap < 1e-12, "{gap:e} {:e}", again.e3_minus_e2);
        prop_assert!((again.e1 - given.e1).abs() < 1e-12 && (again.e2 - given.e2).abs() * gap < 1e-12);
    }
}

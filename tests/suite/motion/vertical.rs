//! Motions with a vertical axis, and motions that rise to the vertical, leave it, or pass through it.

use super::regimes::{downward, stays_finite, top, upright};
use toytop::{
    BranchPoints, Complex, InitialPhases, Motion, Orientation, Regime, Signs, State, Stepper, TipClass, Top,
    TopParameters,
};
use toytop_closed_forms::Aperiodic;
use toytop_tests::{greater, tolerance, top_of, vectors};

/// A sleeping top only spins: α = e^{iωt/2}.
#[test]
fn a_sleeping_top_spins() {
    for spin in [3.0, 0.5] {
        let mut stepper = Stepper::<f64>::new(&upright([0.0, 0.0, spin]));
        stepper.step(2.0);
        let truth = Orientation { alpha: Complex::new(spin.cos(), spin.sin()), beta: Complex::ZERO };
        assert!(stepper.orientation().distance(&truth) < 4e-16);
    }
}

/// Regime and branch points of an upright axis that spins at this rate.
fn asleep(top: &Top, spin: f64) -> (Regime, BranchPoints) {
    let motion = Motion::launch(top, &State::new(Orientation::IDENTITY, [0.0, 0.0, spin]).unwrap()).unwrap();
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
    let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = || {
        bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
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

/// A vertical axis that moves leaves the vertical in the direction of ω × k.
#[test]
fn a_vertical_start_leaves_in_the_direction_it_moves() {
    for motion in [upright([0.0, 0.5, 3.0]), downward([0.0, 0.5, 3.0])] {
        assert_eq!((motion.regime(), motion.tip_class()), (Regime::Nutating, TipClass::ThroughOrigin));
        let mut stepper = Stepper::<f64>::new(&motion);
        let attitude = stepper.attitude_state();
        assert!(attitude.u().abs() == 1.0);
        for (ours, given) in attitude.omega().iter().zip([0.0, 0.5, 3.0]) {
            assert!((ours - given).abs() < 1e-15);
        }
        // r' = ω × r = ±(0.5, 0, 0); the tip is at -s r
        let small = 1e-6;
        stepper.step(small);
        let [r1, r2, u] = stepper.orientation().axis();
        assert!((r1 / (0.5 * small * u) - 1.0).abs() < 1e-5 && (r2 / r1).abs() < 1e-5, "{r1} {r2} {u}");
    }
}

/// Motion with e2 = e3 = 1 at θ = π, in several forms of the angle: stable or unstable sleep.
#[test]
fn the_sleeping_top_by_branch_points() {
    let pi = std::f64::consts::PI;
    // the last is the f64 nearest to 11 π, and not 11 times the f64 nearest to π
    for theta in [pi, -pi, 3.0 * pi, 34.55751918948773] {
        let start = InitialPhases { theta, arg_alpha: 0.3, ..InitialPhases::default() };
        let motion = Motion::from_branch_points(&top(), [-0.2, 1.0, 1.0], Signs::default(), &start).unwrap();
        assert_eq!(motion.regime(), Regime::SleepingUnstable, "{theta}");
    }
    let mut worst = 0.0_f64;
    for theta in [0.0, 1.0, pi - 1e-12, -3.0] {
        let start = InitialPhases { theta, ..InitialPhases::default() };
        let motion = Motion::from_branch_points(&top(), [-0.2, 1.0, 1.0], Signs::default(), &start).unwrap();
        assert_eq!(motion.regime(), Regime::Aperiodic, "{theta}");
        stays_finite::<f64>(&motion);
        let form = Aperiodic::new(&motion).unwrap();
        for direction in [1.0, -1.0] {
            let mut stepper = Stepper::<f64>::new(&motion);
            for n in 1..=6000_i32 {
                stepper.step(0.01 * direction);
                if n % 500 == 0 {
                    let phi = form.at(0.01 * direction * f64::from(n)).orientation;
                    worst = greater(worst, phi.distance(&stepper.orientation()));
                }
            }
        }
    }
    tolerance::RISE_STEPPER.check("closed form against stepper", worst);
}

/// The aperiodic motion comes from the vertical and rises to it, at any time.
#[test]
fn aperiodic_for_ever() {
    let motion = vectors::motion("aperiodic_AneC");
    let mut stepper = Stepper::<f64>::new(&motion);
    for _ in 0..40_000 {
        stepper.step(0.01);
    }
    assert!(stepper.attitude_state().u() > 1.0 - 4e-16);
    for _ in 0..40_000 {
        stepper.step(-0.01);
    }
    assert!(
        (stepper.attitude_state().u() - motion.branch_points().e1).abs() < 1e-10,
        "back at e1 after 400 time units each way"
    );
}

/// A motion in a plane, from the horizontal, with exactly the energy to reach the vertical: it rises at once, or falls
/// first and rises on the other side.
#[test]
fn an_aperiodic_launch_from_half_way() {
    let top = top_of([1.0, 0.5, 1.0, 1.0], 1.0);
    let half = Complex::new(std::f64::consts::FRAC_1_SQRT_2, 0.0);
    for rising in [1.0, -1.0] {
        let state = State::new(Orientation { alpha: half, beta: -half }, [0.0, -rising, 0.0]).unwrap();
        let motion = Motion::launch(&top, &state).unwrap();
        assert_eq!(motion.regime(), Regime::Aperiodic);
        let mut stepper = Stepper::<f64>::new(&motion);
        let attitude = stepper.attitude_state();
        assert!(
            attitude.u().abs() < 1e-15 && (attitude.udot() - rising).abs() < 1e-15,
            "{} {}",
            attitude.u(),
            attitude.udot()
        );
        (0..1000).for_each(|_| stepper.step(0.02));
        assert!(1.0 - stepper.attitude_state().u() < 1e-3, "{}", stepper.attitude_state().u());
    }
}

//! Invariants: the unit norm, l, n and h, recomputed from α, β and their rates.

use toytop::scalar::Real;
use toytop::{AttitudeState, FirstIntegrals, Motion, Orientation, Regime, State, Stepper, Top};
use toytop_tests::{greater, tolerance, vectors, widened, worst};

/// First integrals from Φ and Φ' by the definitions of section 3.1, and the largest of them.
fn recomputed<R: Real + Into<f64>>(top: &Top, attitude: &AttitudeState<R>) -> FirstIntegrals {
    FirstIntegrals::from_state(
        top,
        &State::new(widened(attitude.orientation), attitude.omega().map(R::into)).unwrap(),
    )
}

fn drift(now: &FirstIntegrals, then: &FirstIntegrals) -> f64 {
    let scale = then.l.abs().max(then.n.abs()).max(then.h.abs());
    let differences = [now.l - then.l, now.n - then.n, now.h - then.h];
    worst(differences.map(|difference| (difference / scale).abs()))
}

/// Defect of the norm and change of the first integrals, the largest at thousand instants of 10⁶ steps.
fn after_a_million_steps<R: Real + Into<f64>>(motion: &Motion) -> (f64, f64) {
    let period = motion.period_advance().map_or(10.0, |averages| averages.period);
    let dt = R::from_f64(period / 1000.7);
    let mut stepper = Stepper::<R>::new(motion);
    let start = motion.first_integrals();
    let (mut norm, mut invariants) = (0.0_f64, 0.0_f64);
    for _ in 0..1000 {
        (0..1000).for_each(|_| stepper.step(dt));
        let attitude = stepper.attitude_state();
        norm = greater(norm, (attitude.orientation.norm_squared().to_f64() - 1.0).abs());
        invariants = greater(invariants, drift(&recomputed(motion.top(), &attitude), &start));
    }
    (norm, invariants)
}

#[test]
fn norm_and_first_integrals_over_a_million_steps() {
    let mut worst = [(0.0_f64, 0.0_f64); 2];
    for name in [
        "fig3_diff_e3_1.85",
        "generic_AneC",
        "near_separatrix_straddle",
        "si_toytop_150",
        "aperiodic_AneC",
        "regular_precession",
    ] {
        let motion = vectors::motion(name);
        for (worst, (norm, invariants)) in worst
            .iter_mut()
            .zip([after_a_million_steps::<f64>(&motion), after_a_million_steps::<f32>(&motion)])
        {
            *worst = (greater(worst.0, norm), greater(worst.1, invariants));
        }
    }
    let [(norm_f64, invariants_f64), (norm_f32, invariants_f32)] = worst;
    tolerance::NORM_F64.check("norm, f64", norm_f64);
    tolerance::NORM_F32.check("norm, f32", norm_f32);
    tolerance::INVARIANTS_F64.check("l, n, h, f64", invariants_f64);
    tolerance::INVARIANTS_F32.check("l, n, h, f32", invariants_f32);
}

#[test]
fn there_and_back_with_changing_steps() {
    let mut worst = 0.0_f64;
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let period = motion.period_advance().map_or(4.0, |averages| averages.period).min(10.0);
        let mut stepper = Stepper::<f64>::new(&motion);
        let start = stepper.orientation();
        let steps: Vec<f64> = (0..4000).map(|i| period * (1.0 + f64::from(i % 7)) / 16384.0).collect();
        for dt in &steps {
            stepper.step(*dt);
        }
        assert!(stepper.orientation().distance(&start) > 1e-3, "{}: did not move", vector.name);
        for dt in steps.iter().rev() {
            stepper.step(-dt);
        }
        worst = greater(worst, stepper.orientation().distance(&start) * vector.gap().clamp(1e-6, 1.0));
    }
    tolerance::REVERSAL_F64.check("there and back", worst);
}

/// (l, n) -> (-l, -n) gives the mirror image, with complex conjugate α and β.
#[test]
fn the_mirror_image_is_exact() {
    for vector in vectors::all().into_iter().filter(|vector| vector.by_branch_points()) {
        let signs = vector.signs();
        let flip = |sign: toytop::Sign| {
            if sign == toytop::Sign::Plus { toytop::Sign::Minus } else { toytop::Sign::Plus }
        };
        let mirrored = toytop::Signs { l_plus_n: flip(signs.l_plus_n), l_minus_n: flip(signs.l_minus_n) };
        let start = vector.start();
        let conjugate =
            toytop::InitialPhases { arg_alpha: -start.arg_alpha, arg_beta: -start.arg_beta, ..start };
        let one = vector.motion().unwrap();
        let other = Motion::from_branch_points(&vector.top(), vector.roots(), mirrored, &conjugate).unwrap();
        let (mut one, mut other) = (Stepper::<f64>::new(&one), Stepper::<f64>::new(&other));
        for _ in 0..500 {
            one.step(0.01);
            other.step(0.01);
        }
        let mirror =
            Orientation { alpha: other.orientation().alpha.conj(), beta: other.orientation().beta.conj() };
        assert!(one.orientation().distance(&mirror) < 4e-15, "{}", vector.name);
    }
}

/// Steps of any size keep the first integrals, even where the step is far too long.
#[test]
fn a_step_far_too_long_is_wrong_only_along_the_motion() {
    let mut worst = 0.0_f64;
    let motion = vectors::motion("generic_AneC");
    assert_eq!(motion.regime(), Regime::Nutating);
    let mut stepper = Stepper::<f64>::new(&motion);
    for _ in 0..1000 {
        stepper.step(3.7);
        worst = greater(
            worst,
            drift(&recomputed(motion.top(), &stepper.attitude_state()), &motion.first_integrals()),
        );
    }
    tolerance::INVARIANTS_F64.check("l, n, h", worst);
}

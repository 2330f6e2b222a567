//! The stepper is compared with the invariants of a motion (the unit norm, l, n and h) and with its symmetries (reversal of time, mirror image,
//! units).

use toytop::scalar::Real;
use toytop::{
    FirstIntegrals, InitialAngles, Motion, Orientation, Release, Sign, Signs, State, Stepper, Top,
    TopParameters,
};
use toytop_tests::{check, check_all, greater, keep, released, tolerance, vectors, widened, worst};

/// Change of l, n and h, from Φ and Φ' by the definitions of section 3.1, relative to the largest of them.
fn drift<R: Real + Into<f64>>(motion: &Motion, stepper: &Stepper<R>) -> f64 {
    let omega = stepper.attitude_state().omega().map(R::into);
    let state = State::new(widened(stepper.orientation()), omega).unwrap();
    let (now, then) = (FirstIntegrals::from_state(motion.top(), &state), motion.first_integrals());
    let scale = then.l.abs().max(then.n.abs()).max(then.h.abs());
    let differences = [now.l - then.l, now.n - then.n, now.h - then.h];
    worst(differences.map(|difference| (difference / scale).abs()))
}

/// Defect of the norm and change of the first integrals, the largest at thousand instants of 10⁶ steps.
fn after_a_million_steps<R: Real + Into<f64>>(motion: &Motion) -> [f64; 2] {
    let period = motion.period_advance().map_or(10.0, |advance| advance.period);
    let dt = R::from_f64(period / 1000.7);
    let mut stepper = Stepper::<R>::new(motion);
    let mut errors = [0.0; 2];
    for _ in 0..1000 {
        (0..1000).for_each(|_| stepper.step(dt));
        let norm = (stepper.orientation().norm_squared().to_f64() - 1.0).abs();
        keep(&mut errors, [norm, drift(motion, &stepper)]);
    }
    errors
}

#[test]
fn a_million_steps_keep_norm_and_first_integrals() {
    let (mut double, mut single) = ([0.0; 2], [0.0; 2]);
    for name in [
        "fig3_diff_e3_1.85",
        "generic_AneC",
        "near_separatrix_straddle",
        "si_toytop_150",
        "aperiodic_AneC",
        "regular_precession",
    ] {
        let motion = vectors::motion(name);
        keep(&mut double, after_a_million_steps::<f64>(&motion));
        keep(&mut single, after_a_million_steps::<f32>(&motion));
    }
    check_all(["norm, f64", "l, n, h, f64"], double, tolerance::CONSERVATION_F64);
    check_all(["norm, f32", "l, n, h, f32"], single, tolerance::CONSERVATION_F32);
}

#[test]
fn steps_there_and_back_end_at_the_start() {
    let mut worst = 0.0_f64;
    for vector in vectors::all() {
        let motion = vector.motion().unwrap();
        let period = motion.period_advance().map_or(4.0, |advance| advance.period).min(10.0);
        let mut stepper = Stepper::<f64>::new(&motion);
        let start = stepper.orientation();
        let steps: Vec<f64> = (0..4000).map(|i| period * (1.0 + f64::from(i % 7)) / 16384.0).collect();
        steps.iter().for_each(|dt| stepper.step(*dt));
        assert!(stepper.orientation().distance(&start) > 1e-3, "{}: did not move", vector.name);
        steps.iter().rev().for_each(|dt| stepper.step(-dt));
        worst = greater(worst, stepper.orientation().distance(&start) * vector.gap().clamp(1e-6, 1.0));
    }
    check("there and back", worst, tolerance::CONSERVATION_THERE_AND_BACK);
}

/// (l, n) -> (-l, -n) gives the mirror image, with complex conjugate α and β.
#[test]
fn the_mirror_image_is_exact() {
    for vector in vectors::all().into_iter().filter(|vector| vector.by_branch_points()) {
        let (Signs { l_plus_n, l_minus_n }, start) = (vector.signs(), vector.start());
        let flip = |sign: Sign| if sign == Sign::Plus { Sign::Minus } else { Sign::Plus };
        let signs = Signs { l_plus_n: flip(l_plus_n), l_minus_n: flip(l_minus_n) };
        let conjugate = InitialAngles { arg_alpha: -start.arg_alpha, arg_beta: -start.arg_beta, ..start };
        let other = Motion::from_branch_points(&vector.top(), vector.roots(), signs, &conjugate).unwrap();
        let [one, other] = [vector.motion().unwrap(), other].map(|motion| {
            let mut stepper = Stepper::<f64>::new(&motion);
            (0..500).for_each(|_| stepper.step(0.01));
            stepper.orientation()
        });
        let mirror = Orientation { alpha: other.alpha.conj(), beta: other.beta.conj() };
        assert!(one.distance(&mirror) < 4e-15, "{}", vector.name);
    }
}

/// Steps of any size keep the first integrals, even where the step is far too long.
#[test]
fn a_step_far_too_long_is_wrong_only_along_the_motion() {
    let motion = vectors::motion("generic_AneC");
    let mut stepper = Stepper::<f64>::new(&motion);
    let errors = (0..1000).map(|_| {
        stepper.step(3.7);
        drift(&motion, &stepper)
    });
    check("l, n, h", worst(errors), tolerance::CONSERVATION_L_N_H);
}

/// A motion depends on quotients only: a change of the units of mass and length by powers of two changes no bit.
#[test]
fn a_change_of_units_changes_no_bit() {
    let unit = |power: i32| 2.0_f64.powi(power);
    let top = |mass: f64, length: f64| {
        let inertia = mass * length * length;
        Top::sliding(&TopParameters {
            transverse_inertia: 1.3 * inertia,
            axial_inertia: 0.7 * inertia,
            com_height: 0.9 * length,
            mass_moment: 1.1 * mass * length,
            gravity: 1.7 * length,
            rotor_momentum: 0.3 * inertia,
            ..TopParameters::default()
        })
        .unwrap()
    };
    let release = Release { tilt: 0.5, spin: 3.0, precession: 0.25, ..Release::default() };
    let motion = released(&top(1.0, 1.0), &release);
    // units in which the numbers are those of a molecule, a planet or a star
    for (mass, length) in [(unit(-85), unit(-33)), (unit(80), unit(23)), (unit(100), unit(-40))] {
        let other = released(&top(mass, length), &release);
        assert_eq!(motion.branch_points(), other.branch_points());
        assert_eq!(motion.period_advance(), other.period_advance());
        assert_eq!(motion.min_normal_force(), other.min_normal_force());
        let (one, far) = (motion.first_integrals(), other.first_integrals());
        let energy = mass * length * length;
        assert_eq!(
            [one.l * energy, one.n * energy, one.h * energy, one.spin],
            [far.l, far.n, far.h, far.spin]
        );
        let poses = [&motion, &other].map(|motion| {
            let mut stepper = Stepper::<f32>::new(motion);
            (0..100).for_each(|_| stepper.step(0.01));
            stepper.orientation()
        });
        assert_eq!(poses[0], poses[1]);
    }
}

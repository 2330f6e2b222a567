//! The paper's closed forms against reference vectors, ephemeris and stepper: four ways to one motion.

use std::f64::consts::TAU;
use toytop::exact::ClosedForm;
use toytop::{Ephemeris, FirstIntegrals, Heaviness, Motion, Pose, Sign, Signs, Start, Stepper, Tick, Top};
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{greater, orientation_error, tolerance, worst};

fn with_closed_form() -> impl Iterator<Item = (Vector, Motion, ClosedForm)> {
    vectors::all().into_iter().filter_map(|vector| {
        let motion = vector.motion().unwrap();
        let form = ClosedForm::of(&motion).ok()?;
        Some((vector, motion, form))
    })
}

/// Worst errors over the samples: orientation (rad), u, u' relative to the greatest speed.
fn errors(vector: &Vector, form: &ClosedForm) -> [f64; 3] {
    let samples = vector.samples();
    let speed = samples.iter().fold(1.0_f64, |speed, sample| speed.max(sample.udot.abs()));
    samples.iter().fold([0.0_f64; 3], |[orientation, u, udot], sample| {
        let pose = form.at(sample.t);
        let rest = [(pose.u() - sample.u).abs(), (pose.udot() - sample.udot).abs() / speed];
        let error = orientation_error(pose.phi, sample.phi);
        [greater(orientation, error), greater(u, rest[0]), greater(udot, rest[1])]
    })
}

#[test]
fn every_vector_that_has_a_form_is_hit() {
    let (mut worst, mut rounded) = ([0.0_f64; 4], 0.0_f64);
    let mut count = [0; 4];
    for (vector, _, form) in with_closed_form() {
        let kind = match form {
            ClosedForm::RegularPrecession(_) => 0,
            ClosedForm::Aperiodic(_) => 1,
            ClosedForm::E3EqualsE4(_) => 2,
            ClosedForm::Lagrange(_) => 3,
        };
        let [orientation, u, udot] = errors(&vector, &form);
        if vector.is_exact() {
            worst[kind] = [orientation, u, udot].into_iter().fold(worst[kind], greater);
        } else {
            rounded = greater(rounded, orientation);
        }
        count[kind] += 1;
    }
    assert_eq!(count, [7, 4, 7, 4]);
    let names = ["constant tilt", "aperiodic", "e3 = e4", "Lagrange"];
    for ((name, error), budget) in names.iter().zip(worst).zip(tolerance::CLOSED_FORMS) {
        budget.check(name, error);
    }
    tolerance::CLOSED_FORMS_ROUNDED.check("rounded inputs", rounded);
}

/// At 10³, 10⁶ and 10⁹ periods: the rounding of the period, as often.
#[test]
fn the_error_grows_with_the_number_of_periods() {
    let mut worst = 0.0_f64;
    for (vector, _, form) in with_closed_form().filter(|(vector, ..)| vector.is_exact()) {
        for (periods, sample) in vector.huge_samples() {
            worst = greater(worst, orientation_error(form.at(sample.t).phi, sample.phi) / periods);
        }
    }
    tolerance::CLOSED_FORM_PER_PERIOD.check("per period", worst);
}

/// Motions of every kind that has a form, with all four signs, falling and rising at the start, A = C and A ≠ C.
fn motions() -> Vec<Motion> {
    let mut motions = Vec::new();
    let (spread, mass_moment) = (1.25, 0.75); // e₄ = 3/2
    for (s, c) in [(0.5, 1.0), (0.5, 1.7), (0.0, 0.6)] {
        let a = if s > 0.0 { spread * mass_moment * s } else { 1.25 };
        let top = if s > 0.0 {
            Top::sliding(a, c * a, s, Heaviness::MassMoment(mass_moment), 2.0)
        } else {
            Top::fixed(a, c * a, mass_moment, 2.0)
        };
        let roots = [
            [-0.4, 0.6, 1.5],
            [-1.0, 0.3, 1.5],
            [-0.2, 1.0, 1.5],
            [-1.0, 1.0, 1.5],
            [0.3, 0.301, 1.5],
            [-0.95, 0.97, 1.5],
            [-0.3, 1.0, 1.0],
            [0.9, 1.0, 1.0],
            [-1.0, 1.0, 1.0],
            [0.4, 0.4, 1.5],
            [-0.7, -0.7, 1.0625],
        ];
        for e in roots {
            for (plus, minus) in
                [Sign::Plus, Sign::Minus].map(|x| [Sign::Plus, Sign::Minus].map(|y| (x, y))).concat()
            {
                for theta in [0.0, 1.9, -2.5] {
                    let signs = Signs { l_plus_n: plus, l_minus_n: minus };
                    let start = Start { theta, arg_alpha: 0.7, arg_beta: -2.1 };
                    motions.push(Motion::from_branch_points(&top.unwrap(), e, signs, &start).unwrap());
                }
            }
        }
    }
    motions
}

/// l, n and h of a pose, relative to their sizes.
fn integrals_error(motion: &Motion, pose: &Pose<f64>) -> f64 {
    let truth = motion.first_integrals();
    let ours = FirstIntegrals::of(motion.top(), &pose.state().unwrap());
    let top = motion.top();
    let momentum = (top.a() * top.p() * top.g()).sqrt() + truth.l.abs() + truth.n.abs();
    let energy = top.p() * top.g() + truth.h.abs();
    let errors = [(ours.l - truth.l) / momentum, (ours.n - truth.n) / momentum, (ours.h - truth.h) / energy];
    worst(errors.map(f64::abs))
}

/// The four signs, both verticals and the separatrix, against the table and the stepper; the pose is a pose of the motion.
#[test]
fn closed_form_ephemeris_and_stepper_agree() {
    let (mut from_table, mut from_steps, mut integrals) = (0.0_f64, 0.0_f64, 0.0_f64);
    for motion in motions() {
        let form = ClosedForm::of(&motion).unwrap();
        let table = Ephemeris::<f64, 1024, 12>::new(&motion, Tick::hertz(1024).unwrap()).unwrap();
        let mut stepper = Stepper::<f64>::new(&motion);
        for second in 1..=6 {
            let t = f64::from(second);
            (0..2048).for_each(|_| stepper.step(1.0 / 2048.0));
            from_steps = greater(from_steps, orientation_error(form.at(t).phi, stepper.phi()));
            for t in [t, -t, 7.3 * t] {
                let pose = form.at(t);
                from_table = greater(from_table, orientation_error(pose.phi, table.at(t).phi()));
                integrals = greater(integrals, integrals_error(&motion, &pose));
            }
        }
        assert!(orientation_error(form.at(0.0).phi, table.at_tick(0).phi()) < 1e-14);
        for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(form.at(t), form.at(0.0));
        }
        assert!((form.at(1e300).phi.norm_squared() - 1.0).abs() < 1e-13);
    }
    tolerance::CLOSED_FORM_EPHEMERIS.check("closed form and ephemeris", from_table);
    tolerance::CLOSED_FORM_STEPPER.check("closed form and stepper", from_steps);
    tolerance::CLOSED_FORM_INTEGRALS.check("l, n, h of a closed form", integrals);
}

/// Motions without a form say which condition they miss, and every nutating Lagrange top has one.
#[test]
fn where_there_is_no_form_the_refusal_says_why() {
    let motion = vectors::named("generic_AneC").motion().unwrap();
    let refusal = ClosedForm::of(&motion).unwrap_err();
    assert_eq!(refusal.e3, motion.branch_points().e3);
    assert_eq!(Some(refusal.e4), motion.top().e4());
    assert!(refusal.to_string().contains("e3 = e4") && !refusal.to_string().contains('\n'));
}

/// The nutation phase: 0 at u = e₁, half a turn at e₂, one turn a period.
#[test]
fn the_nutation_phase_is_that_of_the_ephemeris() {
    for motion in motions() {
        let form = ClosedForm::of(&motion).unwrap();
        let Some(phase) = form.nutation_phase(0.0) else { continue };
        let table = Ephemeris::<f64, 256, 12>::new(&motion, Tick::hertz(1024).unwrap()).unwrap();
        let period = motion.averages().unwrap().period;
        for t in [0.0, 1.25, -7.5, 400.0] {
            let ours = form.nutation_phase(t).unwrap();
            let apart = (ours - table.at(t).nutation_phase()).principal().to_radians();
            assert!(apart.abs() < 1e-12, "{apart:e}");
            let turns = (ours - phase).to_radians();
            assert!((turns - TAU * t / period).abs() < 1e-12 * (1.0 + turns.abs()));
        }
    }
}

/// (s, e₁, e₂, e₃) at each corner that a fixed tip, or a sliding one with e₄ = 3/2, allows.
fn corners(gap: f64) -> [(f64, [f64; 3]); 16] {
    [
        (0.0, [0.3, 0.3 + gap, 1.5]),
        (0.0, [-0.3, 1.0 - gap, 1.5]),
        (0.0, [-1.0 + gap, 0.4, 1.5]),
        (0.0, [-1.0 + gap, 1.0 - gap, 1.5]),
        (0.0, [-0.3, 1.0 - gap, 1.0 + gap]),
        (0.0, [-0.3, 1.0, 1.0 + gap]),
        (0.0, [-0.3, 0.4, 1.0 + gap]),
        (0.0, [-0.3, 0.4, 1.0 / gap]),
        (0.0, [1.0 - 2.0 * gap, 1.0 - gap, 1.5]),
        (0.0, [-1.0 + gap, -1.0 + 2.0 * gap, 1.5]),
        (1.0, [0.3, 0.3 + gap, 1.5]),
        (1.0, [-0.3, 1.0 - gap, 1.5]),
        (1.0, [-1.0 + gap, 0.4, 1.5]),
        (1.0, [-1.0 + gap, 1.0 - gap, 1.5]),
        (1.0, [1.0 - 2.0 * gap, 1.0 - gap, 1.5]),
        (1.0, [-1.0 + gap, -1.0 + 2.0 * gap, 1.5]),
    ]
}

/// Against the ephemeris, whose set-up is in double-double: nothing is lost as a difference shrinks.
#[test]
fn towards_every_corner() {
    let mut worst = 0.0_f64;
    for (s, e) in [1e-3, 1e-6, 1e-9, 1e-12].into_iter().flat_map(corners) {
        let top = if s > 0.0 {
            Top::sliding(1.25, 1.0, s, Heaviness::MassMoment(1.0), 1.0)
        } else {
            Top::fixed(1.25, 1.0, 1.0, 1.0)
        };
        for l_minus_n in [Sign::Plus, Sign::Minus] {
            let signs = Signs { l_plus_n: Sign::Plus, l_minus_n };
            let start = Start { theta: 0.9, arg_alpha: 0.7, arg_beta: -2.1 };
            let motion = Motion::from_branch_points(&top.unwrap(), e, signs, &start).unwrap();
            let form = ClosedForm::of(&motion).unwrap();
            let period = motion.averages().unwrap().period;
            let table = Ephemeris::<f64, 1024, 12>::new(&motion, Tick::hertz(1 << 30).unwrap()).unwrap();
            for share in [0.0, 0.17, 0.31, 0.49, 0.77, 1.3, -0.9] {
                let t = share * period;
                worst = greater(worst, orientation_error(form.at(t).phi, table.at(t).phi()));
            }
        }
    }
    tolerance::CLOSED_FORM_CORNERS.check("towards the corners", worst);
}

//! Closed forms of the paper against reference vectors, ephemeris and stepper: four methods for one motion.

use std::f64::consts::TAU;
use toytop::{
    AttitudeState, Ephemeris, FirstIntegrals, InitialPhases, Motion, Regime, Sign, Signs, Stepper, Tick,
};
use toytop_closed_forms::ClosedForm;
use toytop_tests::vectors::{self, Vector};
use toytop_tests::{greater, tolerance, top_of, worst};

fn with_closed_form() -> impl Iterator<Item = (Vector, Motion, ClosedForm)> {
    vectors::all().into_iter().filter_map(|vector| {
        let motion = vector.motion().unwrap();
        let form = ClosedForm::of(&motion).ok()?;
        Some((vector, motion, form))
    })
}

/// Largest errors over the samples: orientation (rad), u, u' relative to the greatest speed.
fn errors(vector: &Vector, form: &ClosedForm) -> [f64; 3] {
    let samples = vector.samples();
    let speed = samples.iter().fold(1.0_f64, |speed, sample| speed.max(sample.udot.abs()));
    samples.iter().fold([0.0_f64; 3], |[orientation, u, udot], sample| {
        let attitude = form.at(sample.t);
        let rest = [(attitude.u() - sample.u).abs(), (attitude.udot() - sample.udot).abs() / speed];
        let error = attitude.orientation.distance(&sample.phi);
        [greater(orientation, error), greater(u, rest[0]), greater(udot, rest[1])]
    })
}

#[test]
fn closed_forms_agree_with_the_vectors() {
    let (mut worst, mut rounded) = ([0.0_f64; 4], 0.0_f64);
    let mut count = [0; 4];
    for (vector, _, form) in with_closed_form() {
        let kind = match form {
            ClosedForm::RegularPrecession(_) => 0,
            ClosedForm::Aperiodic(_) => 1,
            ClosedForm::E3EqualsE4(_) => 2,
            ClosedForm::Lagrange(_) => 3,
            ClosedForm::FreeBody(_) => panic!("{}: tops::closed_forms_agree", vector.name),
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

/// The error at 10³, 10⁶ and 10⁹ periods, for times t that are exact.
#[test]
fn the_error_does_not_grow_with_the_number_of_periods() {
    let mut worst = 0.0_f64;
    for (vector, _, form) in with_closed_form().filter(|(vector, ..)| vector.is_exact()) {
        for (_, sample) in vector.huge_samples() {
            worst = greater(worst, form.at(sample.t).orientation.distance(&sample.phi));
        }
    }
    tolerance::CLOSED_FORM_FAR_OUT.check("after 1e9 periods", worst);
}

/// Motions of every kind that has a closed form, with all four signs, u falling and rising at the start, A = C and A
/// ≠ C.
fn motions() -> Vec<Motion> {
    let mut motions = Vec::new();
    let (spread, mass_moment) = (1.25, 0.75); // e₄ = 3/2
    for (s, c) in [(0.5, 1.0), (0.5, 1.7), (0.0, 0.6)] {
        let a = if s > 0.0 { spread * mass_moment * s } else { 1.25 };
        let top = top_of([a, c * a, s, mass_moment], 2.0);
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
                    let start = InitialPhases { theta, arg_alpha: 0.7, arg_beta: -2.1 };
                    motions.push(Motion::from_branch_points(&top, e, signs, &start).unwrap());
                }
            }
        }
    }
    motions
}

/// Errors of l, n and h recomputed from an attitude state, relative to their sizes.
fn integrals_error(motion: &Motion, attitude: &AttitudeState<f64>) -> f64 {
    let truth = motion.first_integrals();
    let ours = FirstIntegrals::from_state(motion.top(), &attitude.state().unwrap());
    let top = motion.top();
    let momentum =
        (top.transverse_inertia() * top.mass_moment() * top.gravity()).sqrt() + truth.l.abs() + truth.n.abs();
    let energy = top.mass_moment() * top.gravity() + truth.h.abs();
    let errors = [(ours.l - truth.l) / momentum, (ours.n - truth.n) / momentum, (ours.h - truth.h) / energy];
    worst(errors.map(f64::abs))
}

/// Motions with the four signs, through both verticals and near the separatrix, against ephemeris and stepper. The
/// attitude state has the first integrals of the motion.
#[test]
fn closed_form_ephemeris_and_stepper_agree() {
    let (mut from_table, mut from_steps, mut integrals) = (0.0_f64, 0.0_f64, 0.0_f64);
    for motion in motions() {
        let form = ClosedForm::of(&motion).unwrap();
        let table = Ephemeris::<f64, 1024>::new(&motion, Tick::hertz(1024).unwrap());
        assert_eq!(table.is_err(), motion.regime() == Regime::Aperiodic);
        let mut stepper = Stepper::<f64>::new(&motion);
        for second in 1..=6 {
            let t = f64::from(second);
            (0..2048).for_each(|_| stepper.step(1.0 / 2048.0));
            from_steps = greater(from_steps, form.at(t).orientation.distance(&stepper.orientation()));
            for t in [t, -t, 7.3 * t] {
                let attitude = form.at(t);
                if let Ok(table) = &table {
                    from_table =
                        greater(from_table, attitude.orientation.distance(&table.at(t).orientation()));
                }
                integrals = greater(integrals, integrals_error(&motion, &attitude));
            }
        }
        let start = Stepper::<f64>::new(&motion).orientation();
        assert!(form.at(0.0).orientation.distance(&start) < 1e-14);
        assert!(
            table.is_ok_and(|table| table.at_tick(0).orientation().distance(&start) < 1e-14)
                || motion.regime() == Regime::Aperiodic
        );
        for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(form.at(t), form.at(0.0));
        }
        assert!((form.at(1e300).orientation.norm_squared() - 1.0).abs() < 1e-15);
    }
    tolerance::CLOSED_FORM_EPHEMERIS.check("closed form and ephemeris", from_table);
    tolerance::CLOSED_FORM_STEPPER.check("closed form and stepper", from_steps);
    tolerance::CLOSED_FORM_INTEGRALS.check("l, n, h of a closed form", integrals);
}

/// Motions without a closed form return the condition that fails, and every nutating Lagrange top has a closed form.
#[test]
fn motions_without_a_closed_form_are_refused_with_the_reason() {
    let motion = vectors::motion("generic_AneC");
    let refusal = ClosedForm::of(&motion).unwrap_err();
    assert_eq!(refusal.e3, motion.branch_points().e3);
    assert_eq!(Some(refusal.e4), motion.top().e4());
    assert!(refusal.to_string().contains("e3 = e4") && !refusal.to_string().contains('\n'));
}

/// The nutation phase is 0 at u = e₁, half a turn at e₂, and increases by one turn a period.
#[test]
fn the_nutation_phase_is_that_of_the_ephemeris() {
    for motion in motions() {
        let form = ClosedForm::of(&motion).unwrap();
        let Some(phase) = form.nutation_phase(0.0) else { continue };
        let table = Ephemeris::<f64, 256>::new(&motion, Tick::hertz(1024).unwrap()).unwrap();
        let period = motion.period_advance().unwrap().period;
        for t in [0.0, 1.25, -7.5, 400.0] {
            let ours = form.nutation_phase(t).unwrap();
            let apart = (ours - table.at(t).nutation_phase()).principal().to_radians();
            assert!(apart.abs() < 1e-12, "{apart:e}");
            let turns = (ours - phase).to_radians();
            assert!((turns - TAU * t / period).abs() < 1e-12 * (1.0 + turns.abs()));
        }
    }
}

/// Least A/(ps) that [`Top`] accepts.
const LEAST_SPREAD: f64 = 1e-6;

/// Parameters (s, A, e) near each degenerate case, with one small difference or several. For a sliding tip e₃ = e₄
/// exactly, or e₂ = e₃ = 1. `gap` and `other` are powers of two, so that e₃² - 1 = A/(ps) is an `f64`.
fn corners(gap: f64, other: f64) -> Vec<(f64, f64, [f64; 3])> {
    let lows = [-0.3, 0.3, -1.0, -1.0 + gap, 1.0 - gap - other, 1.0 - gap];
    let highs = |e1: f64| [0.4, 1.0, 1.0 - other, e1 + gap, e1 + other];
    let pairs = lows.into_iter().flat_map(|e1| highs(e1).map(|e2| [e1, e2]));
    let pairs: Vec<_> = pairs.filter(|[e1, e2]| e1 < e2 && *e2 <= 1.0).collect();
    let mut corners = Vec::new();
    for e3 in [1.5, 1.0 + gap, 1.0 + other, 1.0] {
        for &[e1, e2] in pairs.iter().filter(|[_, e2]| e3 > 1.0 || *e2 == 1.0) {
            corners.push((0.0, 1.25, [e1, e2, e3]));
            let spread = if e3 > 1.0 { (e3 - 1.0) * (e3 + 1.0) } else { other };
            if spread > LEAST_SPREAD {
                corners.push((1.0, spread, [e1, e2, e3]));
            }
        }
    }
    corners.extend([0.3, 1.0 - gap].map(|e1| (0.0, 1.25, [e1, e1 + other.min(0.5 * gap), 1.0 / other])));
    corners
}

/// Orientation difference of a closed form and the ephemeris at fractions of a period, as far as its tick is exact.
/// `None` where no table of this size is large enough, or its error bound exceeds 1e-14 rad (small A/(ps); the module
/// `small_together` compares those with exact values).
fn off_from_ephemeris(motion: &Motion, shares: &[f64]) -> Option<f64> {
    const FURTHEST: f64 = 1e7;
    let form = ClosedForm::of(motion).unwrap();
    let table = Ephemeris::<f64, 4096>::new(motion, Tick::hertz(1 << 20).unwrap()).ok()?;
    if table.error_bound().constant > 1e-14 {
        return None;
    }
    let period = motion.period_advance().map_or(1.0, |averages| averages.period);
    let times = shares.iter().map(|share| (share * period).clamp(-FURTHEST, FURTHEST));
    Some(worst(times.map(|t| form.at(t).orientation.distance(&table.at(t).orientation()))))
}

/// Largest error over all cases, and the numbers of motions compared and not compared.
fn worst_towards_corners() -> (f64, [u32; 2]) {
    let gaps = [10, 20, 30, 40].map(|bits| 0.5_f64.powi(bits));
    let (mut worst, mut count) = (0.0_f64, [0; 2]);
    for (s, a, e) in
        gaps.into_iter().flat_map(|gap| gaps.into_iter().flat_map(move |other| corners(gap, other)))
    {
        let top = top_of([a, 0.8 * a, s, 1.0], 1.0);
        for l_minus_n in [Sign::Plus, Sign::Minus] {
            let signs = Signs { l_plus_n: Sign::Plus, l_minus_n };
            let start = InitialPhases { theta: 0.9, arg_alpha: 0.7, arg_beta: -2.1 };
            let motion = Motion::from_branch_points(&top, e, signs, &start).unwrap();
            match off_from_ephemeris(&motion, &[0.0, 0.17, 0.49, 1.3, -0.9, 1e6 + 0.3]) {
                Some(error) => {
                    worst = greater(worst, error);
                    count[0] += 1;
                }
                None => count[1] += 1,
            }
        }
    }
    (worst, count)
}

/// The error does not grow as differences of branch points shrink, alone or together, within some periods and after a
/// million.
#[test]
fn towards_every_corner() {
    // a table of this size needs a larger stack than a test thread has
    let thread = std::thread::Builder::new().stack_size(1 << 27).spawn(worst_towards_corners);
    let (worst, [judged, left_out]) = thread.unwrap().join().unwrap();
    assert!(judged > 1000 && left_out < judged / 2, "{judged} judged, {left_out} left out");
    tolerance::CLOSED_FORM_CORNERS.check("towards the corners", worst);
}

//! Closed forms of the paper are compared with reference vectors, tables and the stepper: four methods for one motion.

use std::f64::consts::TAU;
use toytop::{InitialAngles, Motion, Regime, Stepper, Tick};
use toytop_closed_forms::ClosedForm;
use toytop_tests::{
    DIFFERENT, SAME, SIGNS, check, greater, keep, table_if_it_fits, tolerance, top_of, vectors, worst,
};

/// Errors of the orientation (rad), of u, and of u' relative to the greatest speed: with exact inputs by kind of form, and for all kinds of
/// the orientation with rounded inputs and after 10³, 10⁶ and 10⁹ periods.
#[test]
fn closed_forms_agree_with_the_vectors() {
    let (mut exact, mut count) = ([0.0_f64; 4], [0; 4]);
    let [mut rounded, mut far_out] = [0.0_f64; 2];
    for vector in vectors::all() {
        let Ok(form) = ClosedForm::from_motion(&vector.motion().unwrap()) else { continue };
        let kind = match form {
            ClosedForm::RegularPrecession(_) => 0,
            ClosedForm::Aperiodic(_) => 1,
            ClosedForm::E3EqualsE4(_) => 2,
            ClosedForm::Lagrange(_) => 3,
            ClosedForm::FreeBody(_) => panic!("{}: tops_beyond_the_paper has these", vector.name),
        };
        count[kind] += 1;
        let samples = vector.samples();
        let speed = samples.iter().fold(1.0_f64, |speed, sample| speed.max(sample.udot.abs()));
        for sample in samples {
            let attitude = form.at(sample.t);
            let error = attitude.orientation.distance(&sample.phi);
            if vector.is_exact() {
                let rest = [
                    (attitude.orientation.u() - sample.u).abs(),
                    (attitude.udot() - sample.udot).abs() / speed,
                ];
                exact[kind] = worst([exact[kind], error, rest[0], rest[1]]);
            } else {
                rounded = greater(rounded, error);
            }
        }
        for (_, sample) in vector.huge_samples().iter().filter(|_| vector.is_exact()) {
            far_out = greater(far_out, form.at(sample.t).orientation.distance(&sample.phi));
        }
    }
    assert!(count.iter().zip([7, 4, 7, 4]).all(|(found, least)| *found >= least), "{count:?}");
    exact.into_iter().for_each(|error| check("exact inputs", error, tolerance::METHODS_AGREE_EXACT_INPUTS));
    check("rounded inputs", rounded, tolerance::METHODS_AGREE_ROUNDED_INPUTS);
    check("after 1e9 periods", far_out, tolerance::METHODS_AGREE_AFTER_1E9_PERIODS);
}

/// Motions of every kind that has a closed form, with all four signs, u falling and rising at the start, A = C and A
/// ≠ C.
fn motions() -> Vec<Motion> {
    let mut motions = Vec::new();
    // A/(ps) = 5/4, so that e₄ = 3/2
    for top in [[0.46875, 0.46875, 0.5, 0.75], [0.46875, 0.796875, 0.5, 0.75], [1.25, 0.75, 0.0, 0.75]] {
        let top = top_of(top, 2.0);
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
        for (e, signs) in roots.into_iter().flat_map(|e| SIGNS.map(|signs| (e, signs))) {
            for theta in [0.0, 1.9, -2.5] {
                let start = InitialAngles { theta, arg_alpha: 0.7, arg_beta: -2.1 };
                motions.push(Motion::from_branch_points(&top, e, signs, &start).unwrap());
            }
        }
    }
    motions
}

/// Motions through both verticals and near the separatrix, against table and stepper. The nutation phase is that of the table, and
/// increases by one turn a period.
#[test]
fn closed_form_table_and_stepper_agree() {
    let mut worst = [0.0_f64; 2];
    for motion in motions() {
        let form = ClosedForm::from_motion(&motion).unwrap();
        let table = table_if_it_fits::<f64, 1024>(&motion, Tick::hertz(1024).unwrap());
        assert_eq!(table.is_none(), motion.regime() == Regime::Aperiodic);
        let mut stepper = Stepper::<f64>::new(&motion);
        let start = stepper.orientation();
        assert!(form.at(0.0).orientation.distance(&start) < 1e-14);
        for second in 1..=6 {
            let t = f64::from(second);
            (0..2048).for_each(|_| stepper.step(1.0 / 2048.0));
            keep(&mut worst, [0.0, form.at(t).orientation.distance(&stepper.orientation())]);
            for (table, t) in table.iter().flat_map(|table| [t, -t, 7.3 * t].map(|t| (table, t))) {
                let sample = table.at(t);
                keep(&mut worst, [form.at(t).orientation.distance(&sample.orientation()), 0.0]);
                let Some(phase) = form.nutation_phase(t) else { continue };
                assert!((phase - sample.nutation_phase()).principal().to_radians().abs() < 1e-12);
                let turns = (phase - form.nutation_phase(0.0).unwrap()).to_radians();
                let expected = TAU * t / motion.period_advance().unwrap().period;
                assert!((turns - expected).abs() < 1e-12 * (1.0 + turns.abs()));
            }
        }
        for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(form.at(t), form.at(0.0));
        }
        assert!((form.at(1e300).orientation.norm_squared() - 1.0).abs() < 1e-15);
    }
    check("closed form and table", worst[0], tolerance::METHODS_AGREE_CLOSED_FORM_AND_TABLE);
    check("closed form and stepper", worst[1], tolerance::METHODS_AGREE_CLOSED_FORM_AND_STEPPER);
}

/// Motions with a closed form near each degenerate case: s, A and the branch points, with one small difference or two. For a sliding tip
/// e₃ = e₄ exactly, or e₂ = e₃ = 1.
fn corners() -> Vec<(f64, f64, [f64; 3])> {
    let gaps = [10, 20, 30, 40].map(|bits| 0.5_f64.powi(bits));
    let mut corners = Vec::new();
    for (gap, other) in gaps.into_iter().flat_map(|gap| gaps.map(|other| (gap, other))) {
        let highs = |e1: f64| [0.4, 1.0, 1.0 - other, e1 + gap, e1 + other].map(|e2| [e1, e2]);
        let pairs = [-0.3, -1.0, -1.0 + gap, 1.0 - gap - other, 1.0 - gap].into_iter().flat_map(highs);
        for [e1, e2] in pairs.filter(|[e1, e2]| e1 < e2 && *e2 <= 1.0) {
            for e3 in [1.5, 1.0 + gap, 1.0].into_iter().filter(|e3| *e3 > 1.0 || e2 == 1.0) {
                let spread = if e3 > 1.0 { (e3 - 1.0) * (e3 + 1.0) } else { gap };
                corners.extend([(0.0, 1.25, [e1, e2, e3]), (1.0, spread, [e1, e2, e3])]);
            }
        }
        corners.push((0.0, 1.25, [0.3, 0.3 + other.min(0.5 * gap), 1.0 / other]));
    }
    // a top has at least this A/(ps)
    corners.retain(|(_, a, _)| *a > 1e-6);
    corners
}

/// The error does not grow as differences of branch points shrink, alone or together, within some periods and after a
/// million. Tables that do not fit, or whose bound exceeds 1.7e-14 rad, judge nothing (small A/(ps); the file
/// `against_mpmath` compares those with exact values).
#[test]
fn the_error_does_not_grow_towards_any_corner() {
    let (mut worst, [mut judged, mut left_out]) = (0.0_f64, [0; 2]);
    for ((s, a, e), signs) in
        corners().into_iter().flat_map(|corner| [SAME, DIFFERENT].map(|signs| (corner, signs)))
    {
        let start = InitialAngles { theta: 0.9, arg_alpha: 0.7, arg_beta: -2.1 };
        let motion =
            Motion::from_branch_points(&top_of([a, 0.8 * a, s, 1.0], 1.0), e, signs, &start).unwrap();
        let form = ClosedForm::from_motion(&motion).unwrap();
        let table = table_if_it_fits::<f64, 4096>(&motion, Tick::hertz(1 << 20).unwrap());
        let Some(table) = table.filter(|table| table.error_bound().constant <= 1.7e-14) else {
            left_out += 1;
            continue;
        };
        judged += 1;
        let period = motion.period_advance().map_or(1.0, |advance| advance.period);
        for share in [0.0, 0.17, 0.49, 1.3, -0.9, 1e6 + 0.3] {
            let t = (share * period).clamp(-1e7, 1e7);
            worst = greater(worst, form.at(t).orientation.distance(&table.at(t).orientation()));
        }
    }
    assert!(judged > 1000 && left_out < judged / 2, "{judged} judged, {left_out} left out");
    check("towards the corners", worst, tolerance::METHODS_AGREE_TOWARDS_THE_CORNERS);
}

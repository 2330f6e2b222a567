//! Each stage of the computation separately, against the reference vectors.

use toytop::scalar::Real;
use toytop::{BranchPoints, FirstIntegrals, Motion, Sign, Signs, Stepper};
use toytop_tests::vectors::{self, Sample, Vector};
use toytop_tests::{by_branch_points, greater, tolerance, top_of, widened, worst};

fn relative(value: f64, truth: f64, scale: f64) -> f64 {
    ((value - truth) / scale).abs()
}

/// Vectors with inputs exact in f64; the one with a very small A/(ps) has tolerances of its own.
fn exact() -> Vec<Vector> {
    vectors::all().into_iter().filter(|vector| vector.is_exact() && vector.name != "exact_small_A").collect()
}

#[test]
fn there_are_vectors_of_every_kind() {
    assert!(vectors::all().len() >= 50);
    assert!(exact().iter().filter(|vector| !vector.by_branch_points()).count() >= 4);
}

#[test]
fn first_integrals_from_branch_points_and_from_states() {
    let errors = vectors::all().into_iter().flat_map(|vector| {
        let truth = ["l", "n", "h"].map(|key| vector.number(key).unwrap());
        let scale = truth.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
        let [e1, e2, e3] = vector.roots();
        let top = vector.top();
        // a state near the vertical rounded to f64 has a different l - n, but the same l and n up to rounding
        let integrals = if vector.by_branch_points() {
            // near_vertical_pass contains 1 - 1e-8 in decimal, which is rounded; the exact vectors contain its exact
            // counterpart
            if vector.name == "near_vertical_pass" {
                return vec![];
            }
            BranchPoints::new(e1, e2, e3).unwrap().integrals(&top, vector.signs())
        } else {
            FirstIntegrals::from_state(&top, &vector.state())
        };
        [integrals.l, integrals.n, integrals.h]
            .iter()
            .zip(truth)
            .map(|(x, y)| relative(*x, y, scale))
            .collect()
    });
    tolerance::CONSTANTS.check("l, n, h", worst(errors));
}

#[test]
fn branch_points_from_exact_states() {
    let errors = exact().into_iter().filter(|vector| !vector.by_branch_points()).flat_map(|vector| {
        let e = BranchPoints::from_state(&vector.top(), &vector.state()).unwrap();
        let truth = vector.roots();
        [e.e1, e.e2, e.e3]
            .into_iter()
            .zip(truth)
            .map(|(x, y)| relative(x, y, y.abs().max(0.1)))
            .collect::<Vec<_>>()
    });
    let worst = worst(errors);
    assert!(worst <= f64::EPSILON, "to the last bit but one: {worst:e}");
}

#[test]
fn period_and_phase_advances() {
    let errors = |vector: &Vector| {
        let (truth, averages) = (vector.period()?, vector.motion().unwrap().period_advance()?);
        let turn = std::f64::consts::TAU;
        // where the axis is vertical at all times, α or β is 0, and its advance has no meaning
        let vertical = vector.motion().unwrap().regime().is_vertical();
        let rest = [
            relative(averages.alpha_turns * turn, truth.alpha, truth.alpha.abs().max(1.0)),
            relative(averages.beta_turns * turn, truth.beta, truth.beta.abs().max(1.0)),
            relative(averages.phi_per_period(), truth.phi, truth.phi.abs().max(1.0)),
        ];
        Some(worst([relative(averages.period, truth.period, truth.period)].into_iter().chain(if vertical {
            [0.0; 3]
        } else {
            rest
        })))
    };
    let (exact, rounded): (Vec<_>, Vec<_>) = vectors::all().into_iter().partition(Vector::is_exact);
    assert!(exact.iter().filter_map(errors).count() >= 15);
    tolerance::PERIOD.check("exact inputs", worst(exact.iter().filter_map(errors)));
    let of_rounding = |vector: &Vector| Some(errors(vector)? * vector.smallest_difference());
    tolerance::PERIOD_ROUNDED.check("rounded inputs", worst(rounded.iter().filter_map(of_rounding)));
}

/// Largest errors of the stepper at every sample, forward and backward from t = 0, with `steps` steps a period.
fn follow<R: Real>(
    motion: &Motion,
    samples: &[Sample],
    steps: f64,
    mut at: impl FnMut(&Stepper<R>, &Sample),
) {
    let period = motion.period_advance().map_or(20.0, |averages| averages.period);
    for forward in [true, false] {
        let mut stepper = Stepper::<R>::new(motion);
        let mut elapsed = 0.0;
        let mut chosen: Vec<&Sample> = samples.iter().filter(|sample| (sample.t >= 0.0) == forward).collect();
        chosen.sort_by(|a, b| a.t.abs().total_cmp(&b.t.abs()));
        for sample in chosen {
            let count = ((sample.t - elapsed).abs() * steps / period).ceil().max(1.0);
            let (from, count) = (elapsed, count as u32);
            for step in 1..=count {
                let target = from + (sample.t - from) * f64::from(step) / f64::from(count);
                let dt = R::from_f64(target - elapsed);
                stepper.step(dt);
                elapsed += dt.to_f64();
            }
            at(&stepper, sample);
        }
    }
}

fn orientation_over<R: Real + Into<f64>>(vector: &Vector, steps: f64) -> f64 {
    let mut error = 0.0_f64;
    follow::<R>(&vector.motion().unwrap(), &vector.samples(), steps, |stepper, sample| {
        error = greater(error, widened(stepper.orientation()).distance(&sample.phi));
    });
    error
}

#[test]
fn stepper_orientation() {
    let (near, away): (Vec<_>, Vec<_>) = exact().into_iter().partition(|vector| {
        let gap = vector.gap();
        gap > 0.0 && gap < 1e-3
    });
    assert!(near.len() >= 2);
    tolerance::STEPPER_F64
        .check("f64", worst(away.iter().map(|vector| orientation_over::<f64>(vector, 4096.0))));
    let small = vectors::named("exact_small_A");
    tolerance::STEPPER_F64_SMALL_A.check("f64, A/(ps) = 1/16", orientation_over::<f64>(&small, 4096.0));
    let scaled = near.iter().map(|vector| orientation_over::<f64>(vector, 4096.0) * vector.gap());
    tolerance::STEPPER_F64_SEPARATRIX.check("f64 near the separatrix", worst(scaled));
    tolerance::STEPPER_F32
        .check("f32", worst(away.iter().map(|vector| orientation_over::<f32>(vector, 1024.0))));
}

/// Orientation errors that the project promises, on all vectors, including those with rounded inputs.
#[test]
fn stepper_orientation_on_every_vector() {
    for vector in vectors::all() {
        let allowed = if vector.gap() > 0.0 && vector.gap() < 1e-5 { 1e-8 } else { 1e-10 };
        let error = orientation_over::<f64>(&vector, 4096.0);
        assert!(error <= allowed, "{}: {error:.1e} rad", vector.name);
    }
}

#[test]
fn stepper_reduced_motion_tip_and_angle() {
    let (mut reduced, mut tip, mut angle) = (0.0_f64, 0.0_f64, 0.0_f64);
    for vector in exact().into_iter().filter(|vector| vector.gap() == 0.0 || vector.gap() > 1e-3) {
        let motion = vector.motion().unwrap();
        let speed = vector.samples().iter().fold(1.0_f64, |speed, sample| speed.max(sample.udot.abs()));
        follow::<f64>(&motion, &vector.samples(), 4096.0, |stepper, sample| {
            let attitude = stepper.attitude_state();
            reduced = worst([
                reduced,
                (attitude.u() - sample.u).abs(),
                (attitude.udot() - sample.udot).abs() / speed,
            ]);
            let place = stepper.tip();
            let distance = (place - sample.c).norm_squared().sqrt() / motion.top().tip_scale();
            tip = greater(tip, distance);
            if let (Some(ours), Some(truth)) = (stepper.tip_angle(), sample.tip_angle) {
                angle = greater(angle, (ours.to_radians() - truth).abs());
            }
        });
    }
    tolerance::REDUCED_F64.check("u and u'", reduced);
    tolerance::TIP_F64.check("tip", tip);
    tolerance::TIP_ANGLE_F64.check("tip angle", angle);
}

/// Advance of the tip angle where those of α and β nearly cancel, against the trapezoid rule at 50 digits.
#[test]
fn the_tip_angle_per_period_keeps_its_digits() {
    let top = top_of([1.0, 1.0, 1.0, 1.0], 1.0);
    let unit = f64::EPSILON;
    for (e, l_minus_n, truth) in [
        ([0.5, 0.5 + 13.0 * unit, 1e8], Sign::Minus, 4.1559364514228804e-8),
        ([0.25, 0.75, 1e8], Sign::Minus, 0.10892358846408101),
        ([-0.5, 0.5, 1e10], Sign::Minus, 3.724434666656092e-10),
        ([-0.25, 0.75, 1e12], Sign::Minus, 0.19166432368986494),
        ([0.5, 0.5 + 4096.0 * unit, 1e6], Sign::Minus, 4.15593748001752e-6),
        ([0.25, 0.5, 2.0], Sign::Plus, 9.166926859134456),
        ([0.25, 0.75, 1.5], Sign::Minus, 3.5509969828335914),
    ] {
        let signs = Signs { l_plus_n: Sign::Plus, l_minus_n };
        let motion = by_branch_points(&top, e, signs);
        let phi = motion.period_advance().unwrap().phi_per_period();
        assert!((phi / truth - 1.0).abs() <= unit, "{e:?}: {phi:e} against {truth:e}");
    }
}

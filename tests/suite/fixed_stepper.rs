//! The fixed-point stepper: against truth, forward and back, at any tick, and within its range.

use toytop::{
    Ephemeris, FixedStepper, Heaviness, Motion, NoTickMap, Phi, Sign, Signs, Start, Stepper, Tick, Top,
};
use toytop_tests::vectors::{self, Sample, Vector};
use toytop_tests::{greater, orientation_error, tolerance, widened};

/// Ticks a unit of time, so that every sample is at a whole tick.
fn rate(vector: &Vector) -> f64 {
    let whole = |rate: f64| vector.samples().iter().all(|sample| (sample.t * rate).fract() == 0.0);
    (0..30).map(|k| f64::from(1_u32 << k)).find(|&rate| whole(rate)).unwrap()
}

/// Motions known exactly, away from the separatrix.
fn exact() -> impl Iterator<Item = Vector> {
    let apart = |gap: f64| gap == 0.0 || gap >= 1e-4;
    vectors::all()
        .into_iter()
        .filter(move |vector| vector.is_exact() && apart(vector.gap()))
        .filter(|vector| !vector.name.contains("aperiodic"))
}

/// Steps to every sample, past and future, and hands over what is there.
fn follow(vector: &Vector, mut see: impl FnMut(&FixedStepper, &Sample)) {
    let rate = rate(vector);
    let tick = Tick::hertz(rate as u32).unwrap();
    let start = FixedStepper::new(&vector.motion().unwrap(), tick)
        .unwrap_or_else(|error| panic!("{}: {error}", vector.name));
    for (sense, step) in [(1.0, FixedStepper::step as fn(&mut _)), (-1.0, FixedStepper::step_back)] {
        let mut samples = vector.samples();
        samples.retain(|sample| sample.t * sense >= 0.0);
        samples.sort_by(|a, b| a.t.abs().total_cmp(&b.t.abs()));
        let (mut stepper, mut ticks) = (start, 0.0);
        for sample in &samples {
            while ticks < sample.t.abs() * rate {
                step(&mut stepper);
                ticks += 1.0;
            }
            see(&stepper, sample);
        }
    }
}

#[test]
fn truth_over_three_periods() {
    let [mut orientation, mut tilt, mut curve] = [0.0_f64; 3];
    for vector in exact() {
        let (scale, rate) = (vector.top().tip_scale(), rate(&vector));
        follow(&vector, |stepper, sample| {
            let error = orientation_error(widened(stepper.phi()), sample.phi);
            assert!(error <= stepper.error_bound().after(sample.t * rate), "{}", vector.name);
            orientation = greater(orientation, error);
            tilt = greater(tilt, (f64::from(stepper.u()) - sample.u).abs());
            let tip = stepper.tip();
            let (x, y) = (f64::from(tip.re) - sample.c.re / scale, f64::from(tip.im) - sample.c.im / scale);
            curve = greater(curve, x.hypot(y));
        });
    }
    tolerance::STEPPER_Q31.check("orientation", orientation);
    tolerance::U_Q31.check("u", tilt);
    tolerance::TIP_Q31.check("tip", curve);
}

/// Whole turns included, and past the centre at 1e-4 of s.
#[test]
fn the_tip_angle_is_continued() {
    let (mut worst, mut turns) = (0.0_f64, 0.0_f64);
    for vector in exact() {
        let scale = vector.top().tip_scale();
        follow(&vector, |stepper, sample| {
            let (Some(angle), Some(truth)) = (stepper.tip_angle(), sample.tip_angle) else {
                return assert_eq!(stepper.tip_angle().is_some(), sample.tip_angle.is_some());
            };
            let lever = 0.5 * sample.c.norm_squared().sqrt() / scale;
            worst = greater(worst, (angle.to_radians() - truth).abs() * lever);
            turns = greater(turns, angle.to_f64().abs());
        });
    }
    assert!(turns > 1.0, "{turns}");
    tolerance::TIP_ANGLE_Q31.check("tip angle", worst);
}

/// A tick of so many in a period.
fn tick(motion: &Motion, per_period: f64) -> Tick {
    let period = motion.averages().unwrap().period;
    let seconds = 1e9 / (1.0 + per_period / period);
    Tick::ratio((seconds * per_period / period) as u32, seconds as u32).unwrap()
}

/// The flow is exact: it has no order in the tick. Sixteen ticks a period are as good as sixteen thousand, where a Runge-Kutta
/// step of the same length is ten times worse and more.
#[test]
fn the_error_does_not_depend_on_the_tick() {
    let mut worst = 0.0_f64;
    for name in ["generic_AneC", "fig3_diff_e3_3", "vertical_pass_e2_1", "e3_equals_e4"] {
        let motion = vectors::named(name).motion().unwrap();
        for per_period in [16, 64, 1024, 16384] {
            let tick = tick(&motion, f64::from(per_period));
            let truth = Ephemeris::<f64, 48, 11>::new(&motion, tick).unwrap();
            let mut stepper = FixedStepper::<64, 8>::new(&motion, tick).unwrap();
            let mut runge_kutta = Stepper::<f64>::new(&motion);
            let mut lost = 0.0_f64;
            for n in 1..=3 * per_period {
                stepper.step();
                runge_kutta.step(motion.averages().unwrap().period / f64::from(per_period));
                let phi = truth.at_tick(n.into()).phi();
                worst = greater(worst, orientation_error(widened(stepper.phi()), phi));
                lost = greater(lost, orientation_error(runge_kutta.phi(), phi));
            }
            assert!(per_period > 16 || lost > 1e-7, "{name}: {lost:.1e}");
        }
    }
    tolerance::STEPPER_Q31.check("any tick", worst);
}

/// Over 1000 periods of 100 ticks: the two ways round off differently.
#[test]
fn there_and_back() {
    let mut worst = 0.0_f64;
    for vector in exact() {
        let motion = vector.motion().unwrap();
        let mut stepper = FixedStepper::<64, 8>::new(&motion, tick(&motion, 100.0)).unwrap();
        let start = widened(stepper.phi());
        (0..100_000).for_each(|_| stepper.step());
        (0..100_000).for_each(|_| stepper.step_back());
        worst = greater(worst, orientation_error(widened(stepper.phi()), start));
    }
    tolerance::REVERSAL_Q31.check("there and back", worst);
}

/// Numbers that fill [0, 1) evenly, one sequence for each seed.
fn spread(i: u32, seed: f64) -> f64 {
    (f64::from(i) * seed.sqrt()).fract()
}

/// Every kind of motion, the extremes of e₁ and e₂ among them.
fn any_motion(i: u32) -> Motion {
    let a = 10_f64.powf(2.0 * spread(i, 2.0) - 1.0);
    let s = 10_f64.powf(1.0 - 2.0 * spread(i, 3.0));
    let top = Top::sliding(a, a * (0.2 + 1.8 * spread(i, 5.0)), s, Heaviness::MassMoment(1.0), 1.0).unwrap();
    let e1 = if i.is_multiple_of(7) { -1.0 } else { 2.0 * spread(i, 7.0) - 1.0 };
    let e2 = if i.is_multiple_of(5) { 1.0 } else { e1 + (1.0 - e1) * spread(i, 11.0) };
    let e3 = 1.0 + 10_f64.powf(4.0 * spread(i, 13.0) - 1.0);
    let sign = |minus| if minus { Sign::Minus } else { Sign::Plus };
    let signs = Signs { l_plus_n: sign(i.is_multiple_of(2)), l_minus_n: sign(i.is_multiple_of(3)) };
    let angle = |seed| 20.0 * spread(i, seed) - 10.0;
    let start = Start { theta: angle(17.0), arg_alpha: angle(19.0), arg_beta: angle(23.0) };
    Motion::from_branch_points(&top, [e1, e2, e3], signs, &start).unwrap()
}

/// Overflow would panic here; and what the error bound says holds.
#[test]
fn a_million_ticks_of_random_motions_stay_in_range() {
    let (mut ticks, mut refused, mut judged) = (0, 0, 0);
    for i in 0..1000 {
        let motion = any_motion(i);
        let per_period = 10_f64.powf(0.8 + 3.0 * spread(i, 29.0));
        let tick = tick(&motion, per_period);
        let Ok(mut stepper) = <FixedStepper>::new(&motion, tick) else {
            refused += 1;
            continue;
        };
        let truth = Ephemeris::<f64, 256, 12>::new(&motion, tick).ok();
        judged += u32::from(truth.is_some());
        let bound = stepper.error_bound();
        let mut n = 0_i64;
        for leap in [1, 2, 7, 40, 150, 400, 1000_i64] {
            (0..leap).for_each(|_| stepper.step());
            n += leap;
            let phi: Phi<f64> = widened(stepper.phi());
            assert!((phi.norm_squared() - 1.0).abs() < 2e-8, "{i}");
            assert!((phi.u() - f64::from(stepper.u())).abs() < 2e-8, "{i}");
            assert!(stepper.tip_angle().is_some() && f64::from(stepper.tip().norm_squared()) <= 1.0 + 1e-7);
            if let Some(truth) = &truth {
                let error = orientation_error(phi, truth.at_tick(n).phi());
                assert!(error <= bound.after(n as f64), "{i}: {error:e} after {n}");
            }
        }
        ticks += n;
    }
    assert!(ticks >= 1_000_000, "{ticks}");
    assert!((20..100).contains(&refused) && judged > 500, "{refused} refused, {judged} judged");
}

#[test]
fn what_does_not_fit_is_named() {
    let of = |name: &str| vectors::named(name).motion().unwrap();
    let second = Tick::hertz(1000).unwrap();
    assert_eq!(<FixedStepper>::new(&of("aperiodic"), second), Err(NoTickMap::Aperiodic));
    let generic = of("generic_AneC");
    let long = <FixedStepper>::new(&generic, tick(&generic, 1.8));
    assert_eq!(long, Err(NoTickMap::TickTooLong { phase: "nutation" }));
    let coarse = <FixedStepper>::new(&of("near_separatrix_straddle"), second);
    assert!(
        matches!(coarse, Err(NoTickMap::TooCoarse { phase: "nutation", segments: None, .. })),
        "{coarse:?}"
    );
    // what is said to fit does, and half of it does not
    let small = of("exact_small_A");
    let coarse = FixedStepper::<16, 8>::new(&small, second).unwrap_err();
    let NoTickMap::TooCoarse { segments: Some(32), miss, .. } = coarse else { panic!("{coarse:?}") };
    assert!(miss > 6e-8 && FixedStepper::<32, 8>::new(&small, second).is_ok());
    assert!(coarse.to_string().ends_with("32 segments of this degree would fit"), "{coarse}");
}

/// Where u is constant the phases are exact for ever.
#[test]
fn steady_motions_do_not_go_astray() {
    for name in ["regular_precession", "sleeping_stable", "sleeping_unstable", "hanging"] {
        let motion = vectors::named(name).motion().unwrap();
        let mut stepper = FixedStepper::<2, 2>::new(&motion, Tick::hertz(10).unwrap()).unwrap();
        (0..1_000_000).for_each(|_| stepper.step());
        let mut truth = Stepper::<f64>::new(&motion);
        truth.step(1e5);
        let error = orientation_error(widened(stepper.phi()), truth.phi());
        assert!(error < tolerance::STEPPER_Q31.most, "{name}: {error:.1e}");
        assert!((f64::from(stepper.u()) - truth.phi().u()).abs() < 4e-9, "{name}");
        assert_eq!(stepper.tip_angle().is_none(), motion.regime().is_vertical(), "{name}");
    }
}

/// 10⁶ ticks, a thousand periods: what rounding adds up to, against an ephemeris, in which nothing does.
#[test]
fn little_adds_up() {
    let (mut worst, mut judged) = (0.0_f64, 0);
    for vector in exact() {
        let motion = vector.motion().unwrap();
        let tick = tick(&motion, 1000.0);
        let Ok(truth) = Ephemeris::<f64, 256, 12>::new(&motion, tick) else { continue };
        let mut stepper = <FixedStepper>::new(&motion, tick).unwrap();
        (0..1_000_000).for_each(|_| stepper.step());
        worst = greater(worst, orientation_error(widened(stepper.phi()), truth.at_tick(1_000_000).phi()));
        judged += 1;
    }
    assert!(judged > 15, "{judged}");
    tolerance::STEPPER_Q31_LONG.check("10⁶ ticks", worst);
}

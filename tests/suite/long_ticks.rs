//! Ticks of any length: of a motion that rises to the vertical between one and the next, of one that begins almost there, and
//! of one that only turns.

use std::f64::consts::PI;
use toytop::exact::Aperiodic;
use toytop::{
    Ephemeris, FixedStepper, Heaviness, Motion, Release, Sign, Signs, Start, State, Stepper, Tabular, Tick,
    Top,
};
use toytop_tests::{orientation_error, widened};

fn rising(theta: f64) -> Motion {
    let top = Top::sliding(1.25, 0.75, 0.5, Heaviness::MassMoment(1.5), 3.0).unwrap();
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };
    let start = Start { theta, arg_alpha: 0.3, arg_beta: 1.0 };
    Motion::from_branch_points(&top, [0.5, 1.0, 1.0], signs, &start).unwrap()
}

/// At ticks and between them, long before the rise and long after: how often |β| was of a size that tells.
fn keeps_its_bound<R: Tabular + Into<f64>>(motion: &Motion, seconds: u32) -> usize {
    let form = Aperiodic::new(motion).unwrap();
    let tick = Tick::ratio(8, seconds).unwrap();
    let ephemeris = Ephemeris::<R, 512, 11>::new(motion, tick).unwrap();
    let bound = ephemeris.error_bound();
    let mut tilted = 0;
    for n in -2000..2000 {
        for share in [0.0, 0.1, 0.5, 0.96875] {
            let t = (f64::from(n) + share) * f64::from(seconds) / 8.0;
            let truth = form.at(t).phi;
            let error = orientation_error(widened(ephemeris.at(t).phi()), truth);
            // the closed form is f64 throughout
            let allowed = bound.after(f64::from(n)) + 5e-14 * (1.0 + t.abs());
            assert!(error <= allowed, "{seconds}/8 s, tick {n} and {share}: {error:e} of {allowed:e}");
            tilted += usize::from(truth.beta.norm_squared() > 1e-4);
        }
    }
    tilted
}

/// Two ticks for the whole rise, as well as hundreds.
#[test]
fn a_rise_between_ticks() {
    let motion = rising(0.0);
    for (seconds, least) in [(1, 100), (16, 6), (100, 1)] {
        assert!(keeps_its_bound::<f64>(&motion, seconds) >= least);
        assert!(keeps_its_bound::<f32>(&motion, seconds) >= least);
    }
}

/// A pendulum on its separatrix, which does not turn about the vertical: from one end of time to the other α changes sign.
#[test]
fn a_step_longer_than_all_time() {
    let top = Top::sliding(1.25, 0.75, 0.5, Heaviness::MassMoment(1.5), 3.0).unwrap();
    let motion =
        Motion::from_branch_points(&top, [-1.0, 1.0, 1.0], Signs::default(), &Start::default()).unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    stepper.step(-1e300);
    let before = stepper.phi();
    stepper.step(1e301);
    let after = stepper.phi();
    assert!(after.alpha.re * before.alpha.re < -0.999, "{before:?} {after:?}");
    assert!(after.u() > 0.999 && before.u() > 0.999);
}

/// A cursor goes where at_tick is, before the rise, in it and after.
#[test]
fn a_cursor_rises_too() {
    let motion = rising(0.4);
    let ephemeris = Ephemeris::<f32, 512, 5>::new(&motion, Tick::hertz(8).unwrap()).unwrap();
    let mut cursor = ephemeris.cursor(-200);
    for n in -200..200 {
        assert_eq!(cursor.next().phi(), ephemeris.at_tick(n).phi(), "{n}");
    }
}

/// Further up, or down, than the table goes: it is upright until the table begins, and from where it ends.
#[test]
fn a_start_beyond_the_table() {
    for theta in [5e-8 - PI, PI - 5e-8] {
        let motion = rising(theta);
        assert!(keeps_its_bound::<f32>(&motion, 1) > 100);
        assert!(keeps_its_bound::<f64>(&motion, 1) > 100);
    }
}

/// A steady motion in fixed point turns as it should within its stated bound, which is about what it loses: 10⁸ rad and more.
#[test]
fn steady_turning_by_long_ticks() {
    let top = Top::sliding(3.0e-5, 2.0e-5, 0.03, Heaviness::Mass(0.05), 9.81).unwrap();
    let upright = State::release(&Release { spin: 9876.5, ..Release::default() }).unwrap();
    let motion = Motion::launch(&top, &upright).unwrap();
    let mut stepper = <FixedStepper>::new(&motion, Tick::ratio(1, 7).unwrap()).unwrap();
    const TICKS: u32 = 1 << 20;
    (0..TICKS).for_each(|_| stepper.step());
    let truth = Ephemeris::<f64, 16, 11>::new(&motion, Tick::ratio(1, 7).unwrap()).unwrap();
    let error = orientation_error(widened(stepper.phi()), truth.at_tick(i64::from(TICKS)).phi());
    let bound = stepper.error_bound();
    assert!(error <= bound.after(f64::from(TICKS)) && error > 1e-11, "{error:e}");
    assert!(bound.per_tick * 1e12 < bound.constant && bound.per_tick > 1e-24, "{bound:?}");
}

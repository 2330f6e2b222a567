//! Ticks of any length: motions that rise to the vertical within one tick, and motions that begin almost there.

use std::f64::consts::PI;
use toytop::exact::Aperiodic;
use toytop::{Ephemeris, EphemerisScalar, Motion, Sign, Signs, Start, Stepper, Tick};
use toytop_tests::{top_of, widened};

fn rising(theta: f64) -> Motion {
    let top = top_of([1.25, 0.75, 0.5, 1.5], 3.0);
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };
    let start = Start { theta, arg_alpha: 0.3, arg_beta: 1.0 };
    Motion::from_branch_points(&top, [0.5, 1.0, 1.0], signs, &start).unwrap()
}

/// Checks the bound at ticks and between them, long before and long after the rise. Returns how often |β| was large
/// enough to show an error.
fn keeps_its_bound<R: EphemerisScalar + Into<f64>>(motion: &Motion, seconds: u32) -> usize {
    let form = Aperiodic::new(motion).unwrap();
    let tick = Tick::ratio(8, seconds).unwrap();
    let ephemeris = Ephemeris::<R, 512>::new(motion, tick).unwrap();
    let bound = ephemeris.error_bound();
    let mut tilted = 0;
    for n in -2000..2000 {
        for share in [0.0, 0.1, 0.5, 0.96875] {
            let t = (f64::from(n) + share) * f64::from(seconds) / 8.0;
            let truth = form.at(t).orientation;
            let error = widened(ephemeris.at(t).orientation()).distance(&truth);
            // the closed form has the rounding of f64
            let allowed = bound.after(f64::from(n)) + 5e-14 * (1.0 + t.abs());
            assert!(error <= allowed, "{seconds}/8 s, tick {n} and {share}: {error:e} of {allowed:e}");
            tilted += usize::from(truth.beta.norm_squared() > 1e-4);
        }
    }
    tilted
}

/// The whole rise within two ticks, and over hundreds of ticks.
#[test]
fn a_rise_between_ticks() {
    let motion = rising(0.0);
    for (seconds, least) in [(1, 100), (16, 6), (100, 1)] {
        assert!(keeps_its_bound::<f64>(&motion, seconds) >= least);
        assert!(keeps_its_bound::<f32>(&motion, seconds) >= least);
    }
}

/// Pendulum on its separatrix, which does not rotate about the vertical: α changes sign between the distant past and
/// the distant future.
#[test]
fn a_step_longer_than_all_time() {
    let top = top_of([1.25, 0.75, 0.5, 1.5], 3.0);
    let motion =
        Motion::from_branch_points(&top, [-1.0, 1.0, 1.0], Signs::default(), &Start::default()).unwrap();
    let mut stepper = Stepper::<f64>::new(&motion);
    stepper.step(-1e300);
    let before = stepper.orientation();
    stepper.step(1e301);
    let after = stepper.orientation();
    assert!(after.alpha.re * before.alpha.re < -0.999, "{before:?} {after:?}");
    assert!(after.u() > 0.999 && before.u() > 0.999);
}

/// The cursor agrees with `at_tick` before, during and after the rise.
#[test]
fn a_cursor_rises_too() {
    let motion = rising(0.4);
    let ephemeris = Ephemeris::<f32, 512>::new(&motion, Tick::hertz(8).unwrap()).unwrap();
    let mut cursor = ephemeris.cursor(-200);
    for n in -200..200 {
        assert_eq!(cursor.next(&ephemeris).orientation(), ephemeris.at_tick(n).orientation(), "{n}");
    }
}

/// A start higher than the table reaches: the axis is upright until the table begins, and after it ends.
#[test]
fn a_start_beyond_the_table() {
    for theta in [5e-8 - PI, PI - 5e-8] {
        let motion = rising(theta);
        assert!(keeps_its_bound::<f32>(&motion, 1) > 100);
        assert!(keeps_its_bound::<f64>(&motion, 1) > 100);
    }
}

//! Steps and ticks of any length.

use toytop::{EphemerisF64, Motion, Release, Signs, State, Stepper, Tick};
use toytop_tests::{by_branch_points, kilohertz, top_of, vectors};

/// Pendulum on its separatrix, which does not rotate about the vertical: α changes sign between the distant past and
/// the distant future.
#[test]
fn a_step_longer_than_all_time() {
    let top = top_of([1.25, 0.75, 0.5, 1.5], 3.0);
    let motion = by_branch_points(&top, [-1.0, 1.0, 1.0], Signs::default());
    let mut stepper = Stepper::<f64>::new(&motion);
    stepper.step(-1e300);
    let before = stepper.orientation();
    stepper.step(1e301);
    let after = stepper.orientation();
    assert!(after.alpha.re * before.alpha.re < -0.999, "{before:?} {after:?}");
    assert!(after.u() > 0.999 && before.u() > 0.999);
}

/// A time between two ticks keeps the bound for ticks of any length, beside a table with a millisecond a tick.
#[test]
fn times_between_long_ticks_keep_the_bound() {
    let top = *vectors::motion("si_toytop_150").top();
    let release = Release { tilt: 0.35, spin: 150.0, ..Release::default() };
    let motion = Motion::launch(&top, &State::release(&release).unwrap()).unwrap();
    let short = EphemerisF64::new(&motion, kilohertz()).unwrap();
    for (ticks, seconds) in [(1, 86_400), (1, 60), (7, 3), (3, 7_654_321), (1, u32::MAX), (u32::MAX, 1)] {
        let long = EphemerisF64::new(&motion, Tick::ratio(ticks, seconds).unwrap()).unwrap();
        let per_time = f64::from(ticks) / f64::from(seconds);
        for t in [1.2345, -0.1, 1e-7, 59.9, 86_400.0, -12_345.678, 1e6 / 3.0, 4e9] {
            let [found, truth] = [long.at(t), short.at(t)];
            let allowed = long.error_bound().after(t * per_time) + short.error_bound().after(1000.0 * t);
            let error = found.orientation().distance(&truth.orientation());
            assert!(error <= allowed, "{ticks}/{seconds}, {t}: {error:e} of {allowed:e}");
            let [found, truth] = [found, truth].map(|sample| sample.tip_angle().unwrap());
            // the tip is at least 0.3 of its greatest distance from the centre
            let error = (found - truth).to_radians().abs();
            assert!(error <= 8.0 * allowed, "{ticks}/{seconds}, {t}: tip angle {error:e} of {allowed:e}");
        }
    }
}

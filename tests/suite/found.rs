//! What hostile input has broken, each in its smallest form (`cargo xtask fuzz`).

use fixed::types::{I2F14, I2F30};
use toytop::{
    Complex, Ephemeris, Heaviness, Motion, Phi, Sign, Signs, Start, State, Stepper, Tabular, Tick, Top,
};
use toytop_tests::{orientation_error, worst};

/// A miss of the vertical by 3e-43: the tip angle turns faster than `f32` can say, and 1/|β| leaves its range, too.
#[test]
fn the_rate_of_the_tip_angle_is_a_number_however_near_the_vertical() {
    let top = Top::fixed(1.0, 1.0, 1.0, 1.0).unwrap();
    for (push, sign) in [([1.0, 0.0, 3.0], 1.0), ([-1.0, 0.0, 3.0], -1.0)] {
        let phi = Phi { alpha: Complex::ONE, beta: Complex::new(3e-43, 0.0) };
        let motion = Motion::launch(&top, &State::new(phi, push).unwrap()).unwrap();
        let rate = Stepper::<f64>::new(&motion).tip().angle.unwrap().rate;
        let narrow = Stepper::<f32>::new(&motion).tip().angle.unwrap().rate;
        assert!(rate * sign > 1e42, "{rate:e}");
        assert_eq!(narrow, f32::MAX * sign as f32);
    }
}

/// A small A lets the slow phases turn by tens of radians a segment; sixteen terms do not hold that, which the bound must say.
#[test]
fn a_series_that_is_cut_off_is_in_the_error_bound() {
    let top = Top::sliding(1.7e-5, 1e-6, 1.0, Heaviness::MassMoment(1.0), 1.0).unwrap();
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };
    let motion = Motion::from_branch_points(&top, [-0.3, 0.26, 28.8], signs, &Start::default()).unwrap();
    let period = motion.averages().unwrap().period;
    let tick = Tick::hertz(1000).unwrap();
    let coarse = Ephemeris::<f64, 16, 12>::within(&motion, tick, 1.0).unwrap();
    let fine = Ephemeris::<f64, 512, 12>::new(&motion, tick).unwrap();
    let worst = worst((0..2000).map(|i| {
        let t = period * f64::from(i) / 2000.0;
        orientation_error(coarse.at(t).phi(), fine.at(t).phi())
    }));
    let bound = coarse.error_bound().constant;
    assert!(worst <= bound && worst > 0.05 * bound, "{worst:e}, bound {bound:e}");
}

/// A table whose sums would leave its integers was accepted where much error is allowed, and wrapped.
#[test]
fn a_table_that_its_integers_cannot_hold_fits_no_allowance() {
    tables_are_refused::<f32>();
    tables_are_refused::<I2F30>();
    tables_are_refused::<I2F14>();
}

fn tables_are_refused<R: Tabular>() {
    let signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };
    let tick = Tick::hertz(1000).unwrap();
    let (mut held, mut refused) = (0, 0);
    // the smaller A, the faster the slow phases turn in a segment
    for k in 0..20 {
        let a = 10_f64.powf(-0.25 * f64::from(k));
        let top = Top::sliding(a, a, 1.0, Heaviness::MassMoment(1.0), 1.0).unwrap();
        let motion = Motion::from_branch_points(&top, [-0.3, 0.26, 3.0], signs, &Start::default()).unwrap();
        if Ephemeris::<f64, 3, 4>::within(&motion, tick, 1e6).is_err() {
            continue;
        }
        match Ephemeris::<R, 3, 4>::within(&motion, tick, 1e6) {
            Ok(_) => held += 1,
            Err(error) => {
                assert!(error.truncation == 1e6 && error.segments > Some(3), "{error:?}");
                refused += 1;
            }
        }
    }
    assert!(held > 0 && refused > 0, "{held} held, {refused} refused");
}

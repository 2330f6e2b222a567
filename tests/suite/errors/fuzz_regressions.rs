//! Inputs on which the fuzzer found failures (`cargo fuzz`), each in its smallest form, are compared with what must result.

use fixed::types::{I2F14, I2F30};
use toytop::{
    Complex, Motion, Orientation, SetUpError, Sign, Signs, SizedTable, State, Stepper, Table, TableScalar,
    TableSettings, Tick, Top, TopParameters,
};
use toytop_tests::{SAME, by_branch_points, kilohertz, released_from_rest, top_of, toy, worst};

/// The axis misses the vertical by 3e-43: the rate of the tip angle and 1/|β| exceed the range of `f32`.
#[test]
fn the_rate_of_the_tip_angle_is_a_number_however_near_the_vertical() {
    let top = top_of([1.0, 1.0, 0.0, 1.0], 1.0);
    for (push, sign) in [([1.0, 0.0, 3.0], 1.0), ([-1.0, 0.0, 3.0], -1.0)] {
        let phi = Orientation { alpha: Complex::ONE, beta: Complex::new(3e-43, 0.0) };
        let motion = Motion::launch(&top, &State::new(phi, push).unwrap()).unwrap();
        let rate = Stepper::<f64>::new(&motion).tip_angle_rate();
        let narrow = Stepper::<f32>::new(&motion).tip_angle_rate();
        assert!(rate * sign > 1e42, "{rate:e}");
        assert_eq!(narrow, f32::MAX * sign as f32);
    }
}

/// Greatest distance of two tables of a motion in a period.
fn apart(motion: &Motion, coarse: &Table<f64>, fine: &Table<f64>) -> f64 {
    worst((0..2000).map(|i| {
        let t = motion.period_advance().unwrap().period * f64::from(i) / 2000.0;
        coarse.at(t).orientation().distance(&fine.at(t).orientation())
    }))
}

/// With a small A the slow phases change by tens of radians per segment, which sixteen terms do not represent: such a
/// table is refused whatever error is allowed, and the coarsest table that is not refused keeps its bound.
#[test]
fn a_series_that_does_not_converge_is_refused() {
    let top = top_of([1.7e-5, 1e-6, 1.0, 1.0], 1.0);
    let motion = by_branch_points(&top, [-0.3, 0.26, 28.8], SAME);
    let tick = kilohertz();
    assert!(
        SizedTable::<f64, 16>::new(&motion, TableSettings { truncation: Some(1.0), ..tick.into() }).is_err()
    );
    assert_eq!(Table::<f64>::segments_needed(&motion, 1.0), Ok(96));
    let coarse =
        SizedTable::<f64, 96>::new(&motion, TableSettings { truncation: Some(1.0), ..tick.into() }).unwrap();
    let fine = SizedTable::<f64, 512>::new(&motion, tick).unwrap();
    let worst = apart(&motion, &coarse, &fine);
    let bound = coarse.error_bound().constant;
    assert!(worst <= bound && worst > 0.05 * bound, "{worst:e}, bound {bound:e}");
}

/// Near the separatrix one product of two series exceeded the range of its integers by a factor of 2, and the code did not check that
/// range. The error of α was 2e-14 rad in the middle of the period, nearly as large as the bound.
#[test]
fn a_product_of_series_beyond_its_range_shortens_the_segment() {
    let top = [0.00015742034488291326, 3.3065282083723238e-6, 0.11407086745336946, 0.6738442746464433];
    let e = [0.9997064562286313, 0.9999999993407629, 1.0];
    let signs = Signs { l_plus_n: Sign::Minus, l_minus_n: Sign::Plus };
    let motion = by_branch_points(&top_of(top, 1.2811341798619644), e, signs);
    let tick = Tick::hertz(8192).unwrap();
    let coarse = SizedTable::<f64, 32>::new(&motion, tick).unwrap();
    let fine = SizedTable::<f64, 512>::new(&motion, TableSettings { truncation: Some(1e-18), ..tick.into() })
        .unwrap();
    let worst = apart(&motion, &coarse, &fine);
    assert!((1e-16..3e-15).contains(&worst), "{worst:e}");
}

/// A table whose series do not converge, or whose sums overflow its integers, must be refused even where a large error is
/// allowed.
#[test]
fn a_table_that_its_integers_cannot_hold_fits_no_allowance() {
    tables_are_refused::<f32>();
    tables_are_refused::<I2F30>();
    tables_are_refused::<I2F14>();
}

fn tables_are_refused<R: TableScalar>() {
    let (mut held, mut refused) = (0, 0);
    // the smaller A, the faster the slow phases change within a segment
    for k in 0..20 {
        let a = 10_f64.powf(-0.25 * f64::from(k));
        let top = top_of([a, a, 1.0, 1.0], 1.0);
        let motion = by_branch_points(&top, [-0.3, 0.26, 3.0], SAME);
        match SizedTable::<R, 16>::new(&motion, TableSettings { truncation: Some(1e6), ..kilohertz().into() })
        {
            Ok(_) => held += 1,
            Err(error) => {
                assert_eq!(error, SetUpError::TableTooSmall { truncation: 1e6, segments: 16 });
                refused += 1;
            }
        }
    }
    assert!(held > 0 && refused > 0, "{held} held, {refused} refused");
}

/// A rod at rest with a rotor whose angular momentum is almost 0: its period would exceed the range of `f64`.
#[test]
fn a_rotor_that_hardly_turns_counts_as_none() {
    let top = |rotor_momentum| {
        let parameters = TopParameters {
            transverse_inertia: 500.0,
            axial_inertia: 0.0,
            rotor_momentum,
            ..TopParameters::default()
        };
        Top::free(&parameters).unwrap()
    };
    assert_eq!(top(3e-309), top(0.0));
    let phi = Orientation { alpha: Complex::new(0.8, 0.0), beta: Complex::new(0.0, 0.6) };
    let motion = Motion::launch(&top(1e-57), &State::new(phi, [0.0; 3]).unwrap()).unwrap();
    let period = motion.period_advance().unwrap().period;
    let expected = std::f64::consts::TAU * 500.0 / 1e-57;
    assert!((period / expected - 1.0).abs() < 1e-15, "{period:e}");
}

/// A table of any error is the best one with the fewest segments. Terms were left out up to a fraction of the error allowed, which was all
/// of them.
#[test]
fn a_table_of_any_error_keeps_its_terms() {
    let (motion, tick) = (released_from_rest(&toy(), 0.35, 150.0), kilohertz());
    let coarse =
        SizedTable::<f64, 64>::new(&motion, TableSettings { truncation: Some(f64::MAX), ..tick.into() })
            .unwrap();
    let fine = SizedTable::<f64, 512>::new(&motion, tick).unwrap();
    let worst = apart(&motion, &coarse, &fine);
    let bound = coarse.error_bound().constant;
    assert!(worst <= bound && bound < 1e-6, "{worst:e}, bound {bound:e}");
}

//! Shared parts of the tests of all crates: reference vectors, tolerances, and the measure of errors.

pub mod complex;
pub mod hostile;
pub mod tolerance;
pub mod vectors;

use toytop::{Complex, Ephemeris, EphemerisScalar, Motion, Orientation, Tick, Top, TopParameters};

/// Larger of two errors. NaN counts as larger than any number, so that it cannot pass a bound; `f64::max` would drop
/// it.
pub fn greater(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// Largest of several errors: NaN if one of them is NaN, 0 if there are none.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, greater)
}

/// Orientation of any scalar as `f64`.
pub fn widened<R: Into<f64>>(phi: Orientation<R>) -> Orientation<f64> {
    let widen = |z: Complex<R>| Complex::new(z.re.into(), z.im.into());
    Orientation { alpha: widen(phi.alpha), beta: widen(phi.beta) }
}

/// Top with A, C, s and p in a gravity g; s = 0 means a fixed tip.
///
/// # Panics
/// If there is no such top.
pub fn top_of([a, c, s, p]: [f64; 4], gravity: f64) -> Top {
    let parameters = TopParameters {
        transverse_inertia: a,
        axial_inertia: c,
        com_height: s,
        mass_moment: p,
        gravity,
        ..TopParameters::default()
    };
    if s > 0.0 { Top::sliding(&parameters) } else { Top::fixed(&parameters) }.unwrap()
}

/// Ephemeris on the heap: a large one, by value, is too much for the stack of a test.
///
/// # Panics
/// If the motion does not fit.
pub fn boxed<R: EphemerisScalar, const SEGMENTS: usize>(
    motion: &Motion,
    tick: Tick,
) -> Box<Ephemeris<R, SEGMENTS>> {
    let mut ephemeris = Box::new(Ephemeris::<R, SEGMENTS>::EMPTY);
    ephemeris.set_up(motion, tick, 4.0 * R::ROUNDING).unwrap();
    ephemeris
}

/// The example of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

#[test]
fn an_error_that_is_no_number_is_the_worst() {
    assert_eq!(worst([0.5, 2.0, 1.0]), 2.0);
    for errors in [[f64::NAN, 1.0, 2.0], [1.0, f64::NAN, 2.0], [1.0, 2.0, f64::NAN]] {
        assert!(worst(errors).is_nan(), "{errors:?}");
    }
}

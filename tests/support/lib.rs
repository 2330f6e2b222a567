//! Shared parts of the tests of all crates: reference vectors, tolerances, and the measure of errors.

pub mod complex;
pub mod hostile;
pub mod hyperelliptic;
pub mod tolerance;
pub mod vectors;

use std::ops::Deref;
use toytop::{
    Complex, Ephemeris, EphemerisMemory, EphemerisScalar, EphemerisView, InitialPhases, Motion, Orientation,
    SetUp, Signs, Tick, Top, TopParameters,
};

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

/// Motion with these branch points that starts at e₁.
///
/// # Panics
/// If there is no such motion.
pub fn by_branch_points(top: &Top, e: [f64; 3], signs: Signs) -> Motion {
    Motion::from_branch_points(top, e, signs, &InitialPhases::default()).unwrap()
}

/// Tick of a millisecond.
pub fn kilohertz() -> Tick {
    Tick::ratio(1000, 1).unwrap()
}

/// Table on the heap: a large one, by value, is too much for the stack of a test.
pub struct Table<R: EphemerisScalar, const SEGMENTS: usize>(Box<EphemerisMemory<Ephemeris<R, SEGMENTS>>>);

impl<R: EphemerisScalar, const SEGMENTS: usize> Deref for Table<R, SEGMENTS> {
    type Target = EphemerisView<R>;

    fn deref(&self) -> &EphemerisView<R> {
        self.0.get().expect("set up")
    }
}

/// Table of a motion that is launched at tick 0.
///
/// # Panics
/// If the motion does not fit.
pub fn boxed<R: EphemerisScalar, const SEGMENTS: usize>(motion: &Motion, tick: Tick) -> Table<R, SEGMENTS> {
    launched_at(motion, tick, 0)
}

/// Table of a motion that is launched at a tick.
///
/// # Panics
/// If the motion does not fit.
pub fn launched_at<R: EphemerisScalar, const SEGMENTS: usize>(
    motion: &Motion,
    tick: Tick,
    epoch: i64,
) -> Table<R, SEGMENTS> {
    let mut memory = Box::new(EphemerisMemory::<Ephemeris<R, SEGMENTS>>::new());
    memory.set_up(&mut SetUp::new(), motion, tick, epoch, &mut || {}).unwrap();
    Table(memory)
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

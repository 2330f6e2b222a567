//! Shared parts of the tests: reference vectors, motions, tables, and the measure of errors.

#[cfg(feature = "host")]
pub mod full_solver;
pub mod fuzz_targets;
pub mod hyperelliptic_curve;
pub mod random;
pub mod tolerance;
pub mod vectors;

use std::ops::Deref;
use toytop::{
    Complex, InitialAngles, Motion, Orientation, Release, SetUpError, Sign, Signs, SizedTable, State, Table,
    TableMemory, TableScalar, TableSettings, Tick, Top, TopParameters, Workspace,
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

/// Keeps the larger of the errors of each quantity.
pub fn keep<const N: usize>(worst: &mut [f64; N], errors: [f64; N]) {
    *worst = std::array::from_fn(|i| greater(worst[i], errors[i]));
}

/// Checks the worst error of a whole test. It must stay below `most` and reach `most / 30`: a bound far above every error would not fail
/// if the code, or the test, stopped working.
///
/// # Panics
/// If the error exceeds the bound, is far below it, or is NaN.
pub fn check(what: &str, worst: f64, most: f64) {
    assert!(worst <= most, "{what}: {worst:.1e}, allowed {most:.1e}");
    assert!(worst >= most / 30.0, "{what}: {worst:.1e}, so {most:.1e} is too lax a bound");
}

/// Checks the worst errors of several quantities.
pub fn check_all<const N: usize>(what: [&str; N], worst: [f64; N], most: [f64; N]) {
    (0..N).for_each(|i| check(what[i], worst[i], most[i]));
}

/// Length of a vector.
pub fn length(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Distance of two vectors.
pub fn apart(x: [f64; 3], y: [f64; 3]) -> f64 {
    length(std::array::from_fn(|i| x[i] - y[i]))
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

/// Toy top of 50 g, in SI units.
pub const TOY: TopParameters = TopParameters::TOY;

/// Top of the parameters [`TOY`].
///
/// # Panics
/// Never.
pub fn toy() -> Top {
    Top::sliding(&TOY).unwrap()
}

/// Motion of a released top.
///
/// # Panics
/// If there is no such motion.
pub fn released(top: &Top, release: &Release) -> Motion {
    Motion::launch(top, &State::from_release(release).unwrap()).unwrap()
}

/// Motion of a top released from rest apart from its spin.
pub fn released_from_rest(top: &Top, tilt: f64, spin: f64) -> Motion {
    released(top, &Release { tilt, spin, ..Release::default() })
}

/// Positive l + n and l - n.
pub const SAME: Signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Plus };
/// Positive l + n and negative l - n.
pub const DIFFERENT: Signs = Signs { l_plus_n: Sign::Plus, l_minus_n: Sign::Minus };
/// All choices of the signs of l + n and l - n.
pub const SIGNS: [Signs; 4] = [
    SAME,
    DIFFERENT,
    Signs { l_plus_n: Sign::Minus, l_minus_n: Sign::Plus },
    Signs { l_plus_n: Sign::Minus, l_minus_n: Sign::Minus },
];

/// Motion with these branch points that starts at e₁.
///
/// # Panics
/// If there is no such motion.
pub fn by_branch_points(top: &Top, e: [f64; 3], signs: Signs) -> Motion {
    Motion::from_branch_points(top, e, signs, &InitialAngles::default()).unwrap()
}

/// Tick of a millisecond.
pub fn kilohertz() -> Tick {
    Tick::ratio(1000, 1).unwrap()
}

/// Table on the heap: a large one, by value, is too much for the stack of a test.
pub struct HeapTable<R: TableScalar, const SEGMENTS: usize>(Box<TableMemory<SizedTable<R, SEGMENTS>>>);

impl<R: TableScalar, const SEGMENTS: usize> Deref for HeapTable<R, SEGMENTS> {
    type Target = Table<R>;

    fn deref(&self) -> &Table<R> {
        self.0.get().expect("set up")
    }
}

/// Table of a motion that is launched at tick 0, if it fits.
pub fn table_if_it_fits<R: TableScalar, const SEGMENTS: usize>(
    motion: &Motion,
    tick: Tick,
) -> Option<HeapTable<R, SEGMENTS>> {
    table_from_epoch(motion, tick, 0).ok()
}

/// Table of a motion that is launched at tick 0.
///
/// # Panics
/// If the motion does not fit.
pub fn table_of<R: TableScalar, const SEGMENTS: usize>(
    motion: &Motion,
    tick: Tick,
) -> HeapTable<R, SEGMENTS> {
    table_from_epoch(motion, tick, 0).unwrap()
}

/// Table of a motion that is launched at a tick.
///
/// # Errors
/// If the motion does not fit.
pub fn table_from_epoch<R: TableScalar, const SEGMENTS: usize>(
    motion: &Motion,
    tick: Tick,
    epoch: i64,
) -> Result<HeapTable<R, SEGMENTS>, SetUpError> {
    let mut memory = Box::new(TableMemory::<SizedTable<R, SEGMENTS>>::new());
    let settings = TableSettings { epoch, ..TableSettings::new(tick) };
    memory.set_up(&mut Workspace::new(), motion, settings, &mut || {})?;
    Ok(HeapTable(memory))
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

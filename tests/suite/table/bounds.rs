//! Stated error bounds are not too loose: their values for one motion. The tests of errors check that they hold.

use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, EphemerisScalar, ErrorBound};
use toytop_tests::{kilohertz, vectors};

/// Error bound of a motion like the paper's, with C ≠ A, in rad and in rad per tick of 1/1000.
fn of_an_ephemeris<R: EphemerisScalar, const SEGMENTS: usize>() -> ErrorBound {
    let motion = vectors::motion("exact_generic_pp");
    Ephemeris::<R, SEGMENTS>::new(&motion, kilohertz()).unwrap().error_bound()
}

#[test]
fn bounds_have_their_stated_values() {
    let found = [
        ("f64", of_an_ephemeris::<f64, 48>(), [4.355e-15, 8.059e-29]),
        ("f64, 256 segments", of_an_ephemeris::<f64, 256>(), [4.355e-15, 8.059e-29]),
        ("f32", of_an_ephemeris::<f32, 25>(), [1.863e-7, 4.349e-20]),
        ("q31", of_an_ephemeris::<I2F30, 128>(), [2.095e-8, 4.349e-20]),
        ("q15", of_an_ephemeris::<I2F14, 64>(), [5.801e-4, 4.349e-20]),
    ];
    for (name, bound, stated) in found {
        for (found, stated) in [bound.constant, bound.per_tick].into_iter().zip(stated) {
            assert!((found / stated - 1.0).abs() < 0.02, "{name}: {found:e}, not {stated:e}; {bound:?}");
        }
    }
}

//! Stated bounds are not lax: what they come to for one motion. That they are kept is tested where errors are.

use fixed::types::{I2F14, I2F30};
use toytop::{Ephemeris, ErrorBound, FixedStepper, Tabular, Tick};
use toytop_tests::vectors;

/// Of the paper's kind of motion with C unlike A, rad and rad a tick of 1/1000.
fn of_an_ephemeris<R: Tabular, const SEGMENTS: usize, const TERMS: usize>() -> ErrorBound {
    let motion = vectors::named("exact_generic_pp").motion().unwrap();
    Ephemeris::<R, SEGMENTS, TERMS>::new(&motion, Tick::hertz(1000).unwrap()).unwrap().error_bound()
}

#[test]
fn as_they_were_found() {
    let motion = vectors::named("exact_generic_pp").motion().unwrap();
    let stepper = <FixedStepper>::new(&motion, Tick::hertz(16).unwrap()).unwrap();
    let found = [
        ("f64", of_an_ephemeris::<f64, 48, 11>(), [2.411e-15, 2.382e-28]),
        ("f64, shorter series", of_an_ephemeris::<f64, 256, 9>(), [2.592e-15, 2.382e-28]),
        ("f32", of_an_ephemeris::<f32, 25, 5>(), [1.703e-7, 2.382e-28]),
        ("q31", of_an_ephemeris::<I2F30, 32, 6>(), [1.347e-8, 2.382e-28]),
        ("q15", of_an_ephemeris::<I2F14, 16, 4>(), [3.306e-4, 2.382e-28]),
        ("fixed-point stepper", stepper.error_bound(), [1.000e-8, 1.176e-10]),
    ];
    for (name, bound, stated) in found {
        for (found, stated) in [bound.constant, bound.per_tick].into_iter().zip(stated) {
            assert!((found / stated - 1.0).abs() < 0.02, "{name}: {found:e}, not {stated:e}; {bound:?}");
        }
    }
}

//! Stated error bounds are not too loose: their values for one motion, and an error near one of them. The tests of errors check that they
//! hold.

use fixed::types::{I2F14, I2F30};
use toytop::{EphemerisF64, EphemerisScalar};
use toytop_tests::{Table, boxed, greater, kilohertz, vectors, widened};

/// Table of a motion like the paper's, with C ≠ A.
fn table<R: EphemerisScalar, const SEGMENTS: usize>() -> Table<R, SEGMENTS> {
    boxed(&vectors::motion("exact_generic_pp"), kilohertz())
}

/// Bounds in rad and in rad per tick of 1/1000.
#[test]
fn bounds_have_their_stated_values() {
    for (bound, stated) in [
        (table::<f64, 48>().error_bound(), [4.355e-15, 8.059e-29]),
        (table::<f64, 256>().error_bound(), [4.355e-15, 8.059e-29]),
        (table::<f32, 25>().error_bound(), [1.863e-7, 4.349e-20]),
        (table::<I2F30, 128>().error_bound(), [2.095e-8, 4.349e-20]),
        (table::<I2F14, 64>().error_bound(), [5.801e-4, 4.349e-20]),
    ] {
        for (found, stated) in [bound.constant, bound.per_tick].into_iter().zip(stated) {
            assert!((found / stated - 1.0).abs() < 0.02, "{found:e}, not {stated:e}; {bound:?}");
        }
    }
}

/// Rounding error of a tick, against a table in `f64` with the same clock, over enough ticks to reach the greatest error.
#[test]
fn a_tick_in_32_bits_is_within_its_bound_of_one_in_f64() {
    let motion = vectors::motion("exact_generic_pm");
    let fixed = boxed::<I2F30, 256>(&motion, kilohertz());
    let double = EphemerisF64::new(&motion, kilohertz()).unwrap();
    let worst = (0..300_000).map(|n| 7919 * n).fold(0.0, |worst: f64, n| {
        greater(worst, widened(fixed.at_tick(n).orientation()).distance(&double.at_tick(n).orientation()))
    });
    let bound = fixed.error_bound().constant;
    assert!((0.4 * bound..bound).contains(&worst), "{worst:.2e}, bound {bound:.2e}");
}

//! Stated error bounds are not too loose: errors reach a part of them. The tests of errors check that they hold.

use fixed::types::{I2F14, I2F30};
use toytop::{TableF64, TableScalar};
use toytop_tests::{greater, kilohertz, table_of, vectors, widened};

/// Greatest rounding error of a tick over its bound, against a table in `f64` with the same clock.
fn share_of_bound<R: TableScalar + Into<f64>>() -> f64 {
    let motion = vectors::motion("exact_generic_pm");
    let table = table_of::<R, 256>(&motion, kilohertz());
    let double = TableF64::new(&motion, kilohertz()).unwrap();
    let worst = (0..300_000).map(|n| 7919 * n).fold(0.0, |worst: f64, n| {
        greater(worst, widened(table.at_tick(n).orientation()).distance(&double.at_tick(n).orientation()))
    });
    worst / table.error_bound().constant
}

#[test]
fn errors_of_ticks_reach_a_part_of_their_bounds() {
    let shares = [share_of_bound::<f32>(), share_of_bound::<I2F30>(), share_of_bound::<I2F14>()];
    for (share, least) in shares.into_iter().zip([0.2, 0.4, 0.2]) {
        assert!((least..1.0).contains(&share), "{shares:?}");
    }
}

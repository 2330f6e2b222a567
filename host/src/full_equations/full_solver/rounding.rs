//! Keeping the integrator's rounding out of the result: exact units, compensated sums, the unit sphere.

use super::equations::Vector7;

/// The power of two at or below `x` > 0; 1 for what has none.
pub(super) fn power_of_two(x: f64) -> f64 {
    let power = f64::from_bits(x.to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 { power } else { 1.0 }
}

/// a + b as its rounded value and the exact remainder (Knuth).
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let shadow = sum - a;
    (sum, (a - (sum - shadow)) + (b - shadow))
}

/// Puts the orientation part of y + low on the unit sphere by shortening or stretching it, to first order in
/// the defect; the squares' rounding errors count, or the defect would be known to 1e-16 only.
pub(super) fn project(y: &Vector7, low: &mut Vector7) {
    let mut defect = -1.0;
    let mut rest = 0.0;
    for i in 0..4 {
        let square = y[i] * y[i];
        let (sum, error) = two_sum(defect, square);
        defect = sum;
        rest += error + y[i].mul_add(y[i], -square) + 2.0 * y[i] * low[i];
    }
    defect += rest;
    for i in 0..4 {
        low[i] -= 0.5 * defect * y[i];
    }
}

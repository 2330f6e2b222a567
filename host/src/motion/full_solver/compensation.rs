//! Sums and norms whose rounding errors are computed too.

use toytop_model::equations::Vector7;

/// Sum a + b as its rounded value and the exact remainder (Knuth).
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let shadow = sum - a;
    (sum, (a - (sum - shadow)) + (b - shadow))
}

/// Normalises the orientation in y + low, to first order in the deviation of its norm from 1. The rounding errors of the squares are
/// included, because otherwise the deviation would be known to 1e-16 only.
pub fn normalise_orientation(y: &Vector7, low: &mut Vector7) {
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

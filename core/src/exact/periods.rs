//! Time in whole periods and a rest, and the inverse of a time that rises with its variable.

use crate::real::{DoubleDouble, Float};

/// The nearest whole number of periods in origin + t, and what is left of it: the sum and the product are exact, so that
/// only the rounding of the period itself grows with their number. Beyond 9e15 periods nothing is left; a t that is not
/// finite counts as 0, as everywhere.
pub(super) fn split(origin: f64, t: f64, period: f64) -> (i64, f64) {
    let t = if t.is_finite() { t } else { 0.0 };
    let time = DoubleDouble::from(origin) + DoubleDouble::from(t);
    let periods = libm::round(time.to_f64() / period);
    if Float::abs(periods) >= 9e15 {
        return (0, 0.0);
    }
    (periods as i64, (time - DoubleDouble::product(periods, period)).to_f64())
}

/// The y in [low, high] at which a rising function is `target`: Newton's method, and bisection where it would leave the
/// bracket. `function` returns value and slope > 0.
pub(super) fn solve_rising(
    target: f64,
    [low, high]: [f64; 2],
    guess: f64,
    function: impl Fn(f64) -> (f64, f64),
) -> f64 {
    const MOST_STEPS: usize = 80;
    let (mut low, mut high, mut y) = (low, high, guess);
    for _ in 0..MOST_STEPS {
        let (value, slope) = function(y);
        let excess = value - target;
        if excess > 0.0 {
            high = y
        } else {
            low = y
        }
        let newton = y - excess / slope;
        let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
        let done = Float::abs(next - y) <= 2e-16 * Float::abs(next);
        y = next;
        if done || excess == 0.0 {
            break;
        }
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_periods_are_taken_off_exactly() {
        let period = 1.0 / 3.0;
        assert_eq!(split(0.125, 1e9 * period - 0.125, period).0, 1_000_000_000);
        let (periods, rest) = split(0.0, 1e9, period);
        assert_eq!(periods, 3_000_000_000);
        // 1e9 - 3e9 (1/3 rounded down by 2^-54/3)
        assert!((rest - 3e9 * (1.0 / 54_043_195_528_445_952.0)).abs() < 1e-20, "{rest:e}");
        assert_eq!(split(0.0, 1e300, 1.0), (0, 0.0));
    }

    #[test]
    fn the_inverse_of_a_stiff_function() {
        let stiff = |y: f64| (y * y * y + 1e-9 * y, 3.0 * y * y + 1e-9);
        for target in [-1.0, -1e-12, 0.0, 1e-20, 0.3] {
            let y = solve_rising(target, [-2.0, 2.0], 1.0, stiff);
            assert!((stiff(y).0 - target).abs() <= 1e-15 * target.abs(), "{target}");
        }
    }
}

//! Inverse of an increasing function.

use toytop::scalar::{Extended, Float, Ring};

/// Solution y in [low, high] of `function`(y) = `target` for an increasing function: Newton's method, with bisection
/// where a step would leave the interval. `function` returns value and slope > 0.
pub(super) fn solve_increasing(
    target: Extended,
    [low, high]: [Extended; 2],
    guess: Extended,
    function: impl Fn(Extended) -> (Extended, Extended),
) -> Extended {
    const MAX_STEPS: usize = 150;
    /// Relative step after which the iteration ends. The error after a step of Newton's method is about the square of
    /// the step.
    const LAST_STEP: f64 = 1e-18;
    let mut low = low;
    let mut high = high;
    let mut y = guess;
    for _ in 0..MAX_STEPS {
        let (value, slope) = function(y);
        let residual = value - target;
        if residual > Extended::ZERO {
            high = y
        } else {
            low = y
        }
        let newton = y - residual / slope;
        let next = if newton >= low && newton <= high { newton } else { (low + high).halved() };
        let done = (next - y).abs() <= next.abs() * LAST_STEP.into();
        y = next;
        if done || residual == Extended::ZERO {
            break;
        }
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_of_a_stiff_function() {
        let small = Extended::from(1e-9);
        let stiff = |y: Extended| (y.squared() * y + small * y, y.squared() * 3.0.into() + small);
        for target in [-1.0, -1e-12, 0.0, 1e-20, 0.3] {
            let y = solve_increasing(target.into(), [(-2.0).into(), 2.0.into()], 1.0.into(), stiff);
            let error = (stiff(y).0 - target.into()).abs().to_f64();
            assert!(error <= 1e-30 * target.abs(), "{target}: {error:e}");
        }
    }
}

//! Integration by the modified midpoint rule with extrapolation (Gragg, Bulirsch and Stoer).

use crate::scalar::Float;
use crate::sensitivity::equations::Equations;
use crate::sensitivity::flow::Flow;

/// Largest number of midpoint sums of a step. The order is twice as large.
const MOST_SUMS: usize = 7;
/// Product of the first step and the bound on the frequencies at the start.
const FIRST_STEP: f64 = 0.5;

/// Flow after the time `span`, of either sign; `None` after `most_steps` steps, including the repeated ones.
///
/// * `tolerance`: error of a step, relative to each part of the result
pub(crate) fn advance<F: Float, const N: usize>(
    equations: &Equations<F>,
    flow: &Flow<F, N>,
    span: F,
    tolerance: f64,
    most_steps: u32,
) -> Option<Flow<F, N>> {
    let tolerance = F::from_f64(tolerance);
    let mut flow = *flow;
    let mut rest = span;
    let mut length = F::from_f64(FIRST_STEP) / equations.frequency(&flow);
    for _ in 0..most_steps {
        if rest == F::ZERO {
            return Some(flow);
        }
        let last = rest.abs() <= length;
        let step = if last {
            rest
        } else if rest < F::ZERO {
            -length
        } else {
            length
        };
        match extrapolated(equations, &flow, step, tolerance) {
            Some((next, sums)) => {
                flow = next;
                rest = if last { F::ZERO } else { rest - step };
                if sums + 1 < MOST_SUMS && !last {
                    length = length * F::from_f64(1.5);
                }
            }
            None => length = step.abs().halved(),
        }
    }
    None
}

/// Flow after one step, and the number of midpoint sums it took; `None` if they did not suffice.
fn extrapolated<F: Float, const N: usize>(
    equations: &Equations<F>,
    flow: &Flow<F, N>,
    step: F,
    tolerance: F,
) -> Option<(Flow<F, N>, usize)> {
    let frequency = equations.frequency(flow);
    // row[k] has the order 2(k + 1), from the sums up to the last
    let mut row = [*flow; MOST_SUMS];
    for sums in 1..=MOST_SUMS {
        let mut next = midpoint(equations, flow, step, sums);
        let mut change = F::ONE;
        for (k, entry) in row.iter_mut().enumerate().take(sums) {
            let previous = *entry;
            *entry = next;
            if k + 1 < sums {
                let ratio = F::from_f64(sums as f64 / (sums - 1 - k) as f64);
                let weight = F::ONE / (ratio.squared() - F::ONE);
                let better = next.plus(&next.plus(&previous, -F::ONE), weight);
                change = equations.difference(&better, &next, frequency);
                next = better;
            }
        }
        if change <= tolerance {
            return Some((next, sums));
        }
    }
    None
}

/// Midpoint rule with twice `pairs` substeps, smoothed at the end. Its error is a series in the square of the substep.
fn midpoint<F: Float, const N: usize>(
    equations: &Equations<F>,
    flow: &Flow<F, N>,
    step: F,
    pairs: usize,
) -> Flow<F, N> {
    let h = step / F::from_f64(2.0 * pairs as f64);
    let mut before = *flow;
    let mut now = flow.plus(&equations.rate(flow), h);
    for _ in 1..2 * pairs {
        let after = before.plus(&equations.rate(&now), h.doubled());
        (before, now) = (now, after);
    }
    let ahead = before.plus(&equations.rate(&now), h);
    let half = F::ONE.halved();
    now.plus(&ahead.plus(&now, -F::ONE), half)
}

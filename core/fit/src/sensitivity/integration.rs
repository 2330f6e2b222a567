//! Integration by the modified midpoint rule with extrapolation (Gragg, Bulirsch and Stoer).

use crate::sensitivity::equations::Equations;
use crate::sensitivity::flow::{Flow, Tangent};
use crate::vector::dot;

/// Largest number of midpoint sums of a step. The order is twice as large.
const MOST_SUMS: usize = 7;
/// Product of the first step and the bound on the frequencies at the start.
const FIRST_STEP: f64 = 0.5;
/// Largest square of a tangent's size; the squares of larger ones would not be finite.
const LARGEST: f64 = 1e300;

/// Flow after the time `span`, of either sign. `None` after `most_steps` steps, including the repeated ones, and where a tangent has grown
/// beyond 1e150.
///
/// * `tolerance`: error of a step, relative to each part of the result
pub(crate) fn advance<const N: usize>(
    equations: &Equations<f64>,
    flow: &Flow<f64, N>,
    span: f64,
    tolerance: f64,
    most_steps: u32,
) -> Option<Flow<f64, N>> {
    let mut flow = *flow;
    let mut remainder = span;
    let mut length = FIRST_STEP / equations.frequency(&flow);
    for _ in 0..most_steps {
        if remainder == 0.0 {
            return Some(flow);
        }
        let last = libm::fabs(remainder) <= length;
        let step = if last { remainder } else { libm::copysign(length, remainder) };
        let Some((next, sums)) = extrapolated(equations, &flow, step, tolerance) else {
            length = 0.5 * libm::fabs(step);
            continue;
        };
        let is_bounded = |tangent: &Tangent<f64>| {
            dot(tangent.theta, tangent.theta) < LARGEST && dot(tangent.eta, tangent.eta) < LARGEST
        };
        if !next.tangents.iter().all(is_bounded) {
            return None;
        }
        flow = next;
        remainder = if last { 0.0 } else { remainder - step };
        if sums + 1 < MOST_SUMS {
            length *= 1.5;
        }
    }
    None
}

/// Flow after one step, and the number of midpoint sums it took; `None` if they did not suffice.
fn extrapolated<const N: usize>(
    equations: &Equations<f64>,
    flow: &Flow<f64, N>,
    step: f64,
    tolerance: f64,
) -> Option<(Flow<f64, N>, usize)> {
    let frequency = equations.frequency(flow);
    // row[k] has the order 2(k + 1), from the sums up to the last
    let mut row = [*flow; MOST_SUMS];
    for sums in 1..=MOST_SUMS {
        let mut next = midpoint(equations, flow, step, sums);
        let mut change = 1.0;
        for (k, entry) in row.iter_mut().enumerate().take(sums) {
            let previous = core::mem::replace(entry, next);
            if k + 1 < sums {
                let ratio = sums as f64 / (sums - 1 - k) as f64;
                let better = next.plus(&next.plus(&previous, -1.0), 1.0 / (ratio * ratio - 1.0));
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
fn midpoint<const N: usize>(
    equations: &Equations<f64>,
    flow: &Flow<f64, N>,
    step: f64,
    pairs: usize,
) -> Flow<f64, N> {
    let h = step / (2.0 * pairs as f64);
    let mut before = *flow;
    let mut now = flow.plus(&equations.rate(flow), h);
    for _ in 1..2 * pairs {
        let after = before.plus(&equations.rate(&now), 2.0 * h);
        (before, now) = (now, after);
    }
    let ahead = before.plus(&equations.rate(&now), h);
    now.plus(&ahead.plus(&now, -1.0), 0.5)
}

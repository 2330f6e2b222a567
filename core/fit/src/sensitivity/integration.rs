//! Integration by a Runge-Kutta method of order 6 with seven stages (Butcher).

use crate::sensitivity::equations::Equations;
use crate::sensitivity::flow::{COLUMNS, Flow, Tangent};
use crate::vector::dot;
use toytop::scalar::Float;

/// Weights of the earlier rates in the state of each later stage, and in the result.
const WEIGHTS: [&[f64]; 7] = [
    &[1.0 / 3.0],
    &[0.0, 2.0 / 3.0],
    &[1.0 / 12.0, 1.0 / 3.0, -1.0 / 12.0],
    &[25.0 / 48.0, -55.0 / 24.0, 35.0 / 48.0, 15.0 / 8.0],
    &[3.0 / 20.0, -11.0 / 24.0, -1.0 / 8.0, 1.0 / 2.0, 1.0 / 10.0],
    &[-261.0 / 260.0, 33.0 / 13.0, 43.0 / 156.0, -118.0 / 39.0, 32.0 / 195.0, 80.0 / 39.0],
    &[13.0 / 200.0, 0.0, 11.0 / 40.0, 11.0 / 40.0, 4.0 / 25.0, 4.0 / 25.0, 13.0 / 200.0],
];
/// Largest number of steps for one time.
const MOST_STEPS: f64 = 1e6;
/// Largest square of a tangent's size; the squares of larger ones would not be finite.
const LARGEST: f64 = 1e300;

impl<F: Float> Equations<F> {
    /// Sets `end` to the flow one step after `start`.
    ///
    /// * `rate`: rate of `start`
    pub(crate) fn step<const N: usize>(
        &self,
        start: &Flow<F, N>,
        rate: &Flow<F, N>,
        length: f64,
        end: &mut Flow<F, N>,
    ) {
        let mut rates = [*rate; WEIGHTS.len()];
        for (index, weights) in WEIGHTS.iter().enumerate() {
            *end = *start;
            for (rate, weight) in rates.iter().zip(*weights) {
                end.add(rate, F::from_f64(length * weight));
            }
            if let Some(slot) = rates.get_mut(index + 1) {
                *slot = self.rate(end);
            }
        }
    }
}

impl Equations<f64> {
    /// Flow after the time `span`, of either sign. `None` where that takes too many steps, or where a tangent grows beyond 1e150.
    ///
    /// * `longest_step`: product of the longest step and the bound on the frequencies
    pub(crate) fn advance(
        &self,
        flow: &Flow<f64, COLUMNS>,
        span: f64,
        longest_step: f64,
    ) -> Option<Flow<f64, COLUMNS>> {
        let steps = libm::ceil(libm::fabs(span) * self.frequency(flow) / longest_step);
        let steps = Some(steps).filter(|steps| *steps <= MOST_STEPS)?;
        let mut end = *flow;
        for _ in 0..steps as u32 {
            let start = end;
            self.step(&start, &self.rate(&start), span / steps, &mut end);
        }
        let is_bounded = |tangent: &Tangent<f64>| {
            dot(tangent.theta, tangent.theta) < LARGEST && dot(tangent.eta, tangent.eta) < LARGEST
        };
        end.tangents.iter().all(is_bounded).then_some(end)
    }
}

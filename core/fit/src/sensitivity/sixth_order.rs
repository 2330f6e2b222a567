//! Step of Butcher's Runge-Kutta method of order 6, with seven stages.

use crate::sensitivity::equations::{Acceleration, Equations};
use crate::sensitivity::state::{BodyState, Tangent};
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

impl<F: Float> Equations<F> {
    /// Moves a state and its tangents by a step of either sign.
    pub(crate) fn step<const N: usize>(
        &self,
        state: &mut BodyState<F>,
        tangents: &mut [Tangent<F>; N],
        step: F,
    ) {
        let start = (*state, *tangents);
        let mut rates = [start; WEIGHTS.len()];
        for (index, weights) in WEIGHTS.iter().enumerate() {
            if let Some((rate, tangent_rates)) = rates.get_mut(index) {
                let at = Acceleration::new(&self.coefficients, state);
                *rate = at.rate;
                let slots = tangent_rates.iter_mut().zip(tangents.iter()).take(self.column_count);
                for (column, (slot, tangent)) in slots.enumerate() {
                    *slot = self.tangent_rate(&at, tangent, self.change(column));
                }
            }
            (*state, *tangents) = start;
            for ((rate, rates), weight) in rates.iter().zip(*weights).filter(|(_, weight)| **weight != 0.0) {
                let f = step * F::from_f64(*weight);
                state.add(rate, f);
                for (tangent, rate) in tangents.iter_mut().zip(rates).take(self.column_count) {
                    *tangent = tangent.plus(rate, f);
                }
            }
        }
    }
}

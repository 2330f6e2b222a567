//! Integration by a Runge-Kutta method of order 6 with seven stages (Butcher).

use crate::sensitivity::equations::Equations;
use crate::sensitivity::state::AugmentedState;
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
/// Largest number of steps from one time to the next.
const MOST_STEPS: f64 = 200_000.0;

/// Number of equal steps over a time of either sign; `None` where there are too many.
pub(crate) fn steps(span: f64, longest_step: f64) -> Option<u32> {
    let steps = libm::ceil(libm::fabs(span) / longest_step);
    (steps <= MOST_STEPS).then_some(steps as u32)
}

impl<F: Float> Equations<F> {
    /// Moves a state over the time `span` by equal steps.
    pub(crate) fn advance<const N: usize>(&self, state: &mut AugmentedState<F, N>, span: f64, steps: u32) {
        let step = F::from_f64(span / f64::from(steps));
        for _ in 0..steps {
            let start = *state;
            let mut rates = [self.rate(&start); WEIGHTS.len()];
            for (index, weights) in WEIGHTS.iter().enumerate() {
                *state = start;
                for (rate, weight) in rates.iter().zip(*weights) {
                    state.add(rate, step * F::from_f64(*weight));
                }
                if let Some(slot) = rates.get_mut(index + 1) {
                    *slot = self.rate(state);
                }
            }
        }
    }
}

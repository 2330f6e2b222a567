//! Step of Butcher's Runge-Kutta method of order 6, with seven stages.

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

/// Moves a state by a step of either sign.
///
/// * `set_rate`: sets the rate of a state
/// * `add`: adds a factor times a rate to a state
pub(crate) fn sixth_order_step<F: Float, S: Copy>(
    state: &mut S,
    step: F,
    set_rate: impl Fn(&S, &mut S),
    add: impl Fn(&mut S, &S, F),
) {
    let start = *state;
    let mut rates = [start; WEIGHTS.len()];
    for (index, weights) in WEIGHTS.iter().enumerate() {
        rates.iter_mut().skip(index).take(1).for_each(|rate| set_rate(state, rate));
        *state = start;
        for (rate, weight) in rates.iter().zip(*weights).filter(|(_, weight)| **weight != 0.0) {
            add(state, rate, step * F::from_f64(*weight));
        }
    }
}

//! Times of a motion: within its reach, spread over an interval, and in the order in which a method steps to them.

use crate::Failure;

/// Refuses times further from t = 0 than `most`; `suffix` ends the message.
///
/// # Errors
/// [`Failure::input`].
pub fn require_within(times: impl IntoIterator<Item = f64>, most: f64, suffix: &str) -> Result<(), Failure> {
    let beyond = |t| Err(Failure::input(format!("{t:e} must be within ±{most:.1e}{suffix}")));
    times.into_iter().find(|t| t.abs() > most).map_or(Ok(()), beyond)
}

/// Times in [0, `end`], s: one in each of `count` equal parts, shifted within the part by multiples of the golden section.
pub fn spread_times(end: f64, count: u32) -> Vec<f64> {
    const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
    let part = end / f64::from(count);
    (0..count).map(|i| part * (f64::from(i) + (f64::from(i) * GOLDEN_SECTION).fract())).collect()
}

/// Results of `step_to` at each time, in the order of `times`. A method steps from `start` at t = 0 forward, and then from `start` backward.
///
/// # Errors
/// The first error that `step_to` returns.
pub fn step_to_each<S, T, E>(
    times: &[f64],
    start: impl Fn() -> S,
    mut step_to: impl FnMut(&mut S, f64) -> Result<T, E>,
) -> Result<Vec<T>, E> {
    let mut by_distance: Vec<(usize, f64)> = times.iter().copied().enumerate().collect();
    by_distance.sort_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
    let mut results = Vec::with_capacity(times.len());
    for backwards in [false, true] {
        let mut state = start();
        for (index, t) in by_distance.iter().filter(|(_, t)| (*t < 0.0) == backwards) {
            results.push((*index, step_to(&mut state, *t)?));
        }
    }
    results.sort_by_key(|(index, _)| *index);
    Ok(results.into_iter().map(|(_, result)| result).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    #[test]
    fn times_are_reached_in_steps_from_0_and_returned_in_the_order_of_the_request() {
        let mut visited = Vec::new();
        let results = step_to_each(
            &[2.0, -1.0, 0.5, -3.0, 2.0],
            || 0.0,
            |at: &mut f64, t| {
                visited.push((*at, t));
                *at = t;
                Ok::<_, Infallible>(10.0 * t)
            },
        );
        assert_eq!(results.unwrap(), [20.0, -10.0, 5.0, -30.0, 20.0]);
        assert_eq!(visited, [(0.0, 0.5), (0.5, 2.0), (2.0, 2.0), (0.0, -1.0), (-1.0, -3.0)]);
    }
}

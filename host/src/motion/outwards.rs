//! Order in which a method that steps from t = 0 reaches given times.

/// Results of `step_to` at each time, in the order of `times`. The calls go outwards from t = 0, first forward and then backward, each
/// from `start`.
///
/// # Errors
/// The first error that `step_to` returns.
pub fn step_outwards<S, T, E>(
    times: &[f64],
    start: impl Fn() -> S,
    mut step_to: impl FnMut(&mut S, f64) -> Result<T, E>,
) -> Result<Vec<T>, E> {
    let mut outwards: Vec<(usize, f64)> = times.iter().copied().enumerate().collect();
    outwards.sort_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
    let mut results = Vec::with_capacity(times.len());
    for backwards in [false, true] {
        let mut state = start();
        for (index, t) in outwards.iter().filter(|(_, t)| (*t < 0.0) == backwards) {
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
    fn times_are_visited_outwards_and_returned_in_the_order_of_the_request() {
        let mut visited = Vec::new();
        let results = step_outwards(
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

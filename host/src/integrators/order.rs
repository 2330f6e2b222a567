//! Order of convergence: the slope of the error against the step size, both in logarithms.

/// Order of convergence between two runs \[step, error\]; `None` where the second step is not smaller by a twentieth at least.
pub fn between([coarse_step, coarse_error]: [f64; 2], [fine_step, fine_error]: [f64; 2]) -> Option<f64> {
    const SMALLER: f64 = 1.05;
    let order = (coarse_error / fine_error).ln() / (coarse_step / fine_step).ln();
    (order.is_finite() && coarse_step >= SMALLER * fine_step).then_some(order)
}

/// Order fitted by least squares to runs \[step, error\]; `None` if fewer than two of them count.
///
/// * Runs with an error above half a radian do not count.
/// * From the largest step on, runs count until rounding dominates: until the order between two of them is below 1/2, or below seven
///   tenths of the order before.
pub fn fitted(runs: &[[f64; 2]]) -> Option<f64> {
    const LOST: f64 = 0.5;
    let mut points = runs.to_vec();
    points.retain(|[_, error]| *error > 0.0 && *error < LOST);
    points.sort_by(|[a, _], [b, _]| b.total_cmp(a));
    let mut before = 0.0_f64;
    let falls = |pair: &&[[f64; 2]]| {
        let order = between(pair[0], pair[1]).filter(|order| *order > 0.5 && *order > 0.7 * before);
        before = order.unwrap_or(before);
        order.is_some()
    };
    let pairs = points.windows(2).take_while(falls).count();
    if pairs == 0 {
        return None;
    }
    let points: Vec<_> = points[..=pairs].iter().map(|run| run.map(f64::ln)).collect();
    let mean = |i: usize| points.iter().map(|point| point[i]).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let products = points.iter().map(|point| (point[0] - x) * (point[1] - y)).sum::<f64>();
    let squares = points.iter().map(|point| (point[0] - x).powi(2)).sum::<f64>();
    Some(products / squares)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lost_and_rounded_runs_do_not_count() {
        let fourth = |step: f64| [step, 3.0 * step.powi(4)];
        let clean = [fourth(0.01), fourth(0.04), fourth(0.02)];
        let order = fitted(&clean).unwrap();
        assert!((order - 4.0).abs() < 1e-12, "{order}");
        let spoilt =
            [&[[1.0, 0.9], [2.0, 1.1]], &clean[..], &[[1e-4, 2e-12], [5e-5, 4e-12], [2e-5, 1e-15]]].concat();
        let order = fitted(&spoilt).unwrap();
        assert!((order - 4.0).abs() < 1e-12, "{order}");
        assert_eq!(fitted(&clean[..1]), None);
        assert_eq!(fitted(&[[0.1, 1e-3], [0.1, 1e-4]]), None);
        assert!((between([0.2, 1.6e-3], [0.1, 1e-4]).unwrap() - 4.0).abs() < 1e-12);
        assert_eq!(between([0.1, 1.0], [0.1, 1e-4]), None);
        assert_eq!(between([0.1, 1.0], [0.2, 1e-4]), None);
    }
}

//! Gauss-Legendre quadrature in numbers of 192 bits.

use super::precise::{Precise, precise, to_f64, whole};
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Number of nodes. If the distance of the nearest singularity from the end of a panel is at least a quarter of the panel's length, the
/// relative error is below 3^-80, 38 digits.
const NODES: usize = 40;

/// Quadrature rule: nodes in [-1, 1] with their weights.
#[derive(Clone, Debug)]
pub(crate) struct Rule {
    nodes: Vec<(Precise, Precise)>,
    coarse: Vec<(f64, f64)>,
}

/// Quadrature rule, computed at its first use.
pub(crate) static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

impl Rule {
    /// Rule whose nodes are found by Newton's method on the Legendre polynomial.
    fn new() -> Self {
        let one = precise(1.0);
        let node = |i: usize| {
            let mut x = precise(-(PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos());
            for _ in 0..6 {
                let (value, slope) = legendre(&x);
                x -= value / slope;
            }
            let (_, slope) = legendre(&x);
            let weight = precise(2.0) / ((&one - x.sqr()) * slope.sqr());
            (x, weight)
        };
        let nodes: Vec<_> = (0..NODES).map(node).collect();
        let coarse = nodes.iter().map(|(x, weight)| (to_f64(x), to_f64(weight))).collect();
        Self { nodes, coarse }
    }

    /// Integrals of `f` from a to b.
    pub(crate) fn integrate<const N: usize>(
        &self,
        [a, b]: [&Precise; 2],
        mut f: impl FnMut(&Precise) -> [Precise; N],
    ) -> [Precise; N] {
        let (middle, half) = ((a + b) >> 1, (b - a) >> 1);
        let mut sums = [(); N].map(|()| precise(0.0));
        for (x, weight) in &self.nodes {
            let values = f(&(&middle + &half * x));
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
        }
        sums.map(|sum| sum * &half)
    }

    /// Integral of `f` from a to b in `f64`.
    pub(crate) fn integrate_in_f64(&self, [a, b]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        half * self.coarse.iter().map(|(x, weight)| weight * f(middle + half * x)).sum::<f64>()
    }
}

/// Legendre polynomial P_n and its derivative.
fn legendre(x: &Precise) -> (Precise, Precise) {
    let (mut before, mut last) = (precise(1.0), x.clone());
    for k in 2..=NODES as i64 {
        let next = (whole(2 * k - 1) * x * &last - whole(k - 1) * before) / whole(k);
        (before, last) = (last, next);
    }
    let slope = whole(NODES as i64) * (before - x * &last) / (precise(1.0) - x.sqr());
    (last, slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_degree_79_are_exact() {
        let power = |x: &Precise, n: usize| (0..n).fold(precise(1.0), |product, _| product * x);
        for n in [0, 1, 2, 17, 78, 79] {
            let [integral] = RULE.integrate([&precise(1.0), &precise(2.0)], |x| [power(x, n)]);
            let exact = (power(&precise(2.0), n + 1) - precise(1.0)) / whole(n as i64 + 1);
            let error = to_f64(&((integral - &exact) / exact)).abs();
            assert!(error < 1e-54, "{n}: {error:e}");
        }
    }
}

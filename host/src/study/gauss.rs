//! Gauss and Legendre's rule in double-double.

use std::f64::consts::PI;
use toytop::real::{DoubleDouble, Float, Ring};

/// Nodes of the rule.
const NODES: usize = 20;

/// Nodes in [-1, 1] with their weights.
#[derive(Clone, Debug)]
pub struct Rule([(DoubleDouble, DoubleDouble); NODES]);

impl Rule {
    /// By Newton's method on the Legendre polynomial.
    #[must_use]
    pub fn new() -> Self {
        Self(std::array::from_fn(|i| {
            let guess = -(PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
            let mut x = DoubleDouble::from(guess);
            for _ in 0..6 {
                let (value, slope) = legendre(x);
                x = x - value / slope;
            }
            let (_, slope) = legendre(x);
            (x, DoubleDouble::from(2.0) / ((DoubleDouble::ONE - x.squared()) * slope.squared()))
        }))
    }

    /// The integrals of `f` from a to b.
    pub fn integrate<const N: usize>(
        &self,
        [a, b]: [DoubleDouble; 2],
        mut f: impl FnMut(DoubleDouble) -> [DoubleDouble; N],
    ) -> [DoubleDouble; N] {
        let (middle, half) = ((a + b).halved(), (b - a).halved());
        let mut sums = [DoubleDouble::ZERO; N];
        for (x, weight) in self.0 {
            let values = f(middle + half * x);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum = *sum + weight * value);
        }
        sums.map(|sum| sum * half)
    }
}

impl Default for Rule {
    fn default() -> Self {
        Self::new()
    }
}

/// P_n and its derivative.
fn legendre(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let (mut before, mut last) = (DoubleDouble::ONE, x);
    for k in 2..=NODES {
        let k = k as f64;
        let next =
            (DoubleDouble::from(2.0 * k - 1.0) * x * last - DoubleDouble::from(k - 1.0) * before) / k.into();
        (before, last) = (last, next);
    }
    let n = DoubleDouble::from(NODES as f64);
    (last, n * (before - x * last) / (DoubleDouble::ONE - x.squared()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_degree_39_are_exact() {
        let rule = Rule::new();
        let power = |x: DoubleDouble, n: u32| (0..n).fold(DoubleDouble::ONE, |product, _| product * x);
        for n in [0, 1, 2, 17, 38, 39] {
            let [integral] = rule.integrate([1.0.into(), 2.0.into()], |x| [power(x, n)]);
            let exact = (power(2.0.into(), n + 1) - DoubleDouble::ONE) / f64::from(n + 1).into();
            let error = ((integral - exact) / exact).to_f64().abs();
            assert!(error < 1e-29, "{n}: {error:e}");
        }
    }
}

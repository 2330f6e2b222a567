//! Gauss-Legendre quadrature, and the integrands near a turning point, in numbers of 192 bits and in `f64`.

use super::precise::{Precise, precise, root, to_f64, whole};
use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Sub};
use std::sync::LazyLock;

/// Number in which an integral is computed: of 192 bits, or `f64` for a first guess.
pub trait Number:
    Clone
    + PartialEq
    + From<u8>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + 'static
{
    /// Nodes in [-1, 1] with their weights.
    fn nodes() -> &'static [(Self, Self)];

    /// Square root.
    fn root(self) -> Self;
}

impl Number for Precise {
    fn nodes() -> &'static [(Self, Self)] {
        &NODES
    }

    fn root(self) -> Self {
        root(&self)
    }
}

impl Number for f64 {
    fn nodes() -> &'static [(Self, Self)] {
        static IN_F64: LazyLock<Vec<(f64, f64)>> =
            LazyLock::new(|| NODES.iter().map(|(x, weight)| (to_f64(x), to_f64(weight))).collect());
        &IN_F64
    }

    fn root(self) -> Self {
        self.sqrt()
    }
}

/// Number of nodes. If the distance of the nearest singularity from the end of a panel is at least a quarter of the panel's length, the
/// relative error is below 3^-80, 38 digits.
const COUNT: i64 = 40;

/// Nodes with their weights, found by Newton's method on the Legendre polynomial.
static NODES: LazyLock<Vec<(Precise, Precise)>> = LazyLock::new(|| {
    let node = |i: i64| {
        let mut x = precise(-(PI * (i as f64 + 0.75) / (COUNT as f64 + 0.5)).cos());
        for _ in 0..6 {
            let (value, slope) = legendre(&x);
            x -= value / slope;
        }
        let (_, slope) = legendre(&x);
        let weight = whole(2) / ((whole(1) - x.sqr()) * slope.sqr());
        (x, weight)
    };
    (0..COUNT).map(node).collect()
});

/// Integrals of `f` from a to b.
pub fn integrate<R: Number, const N: usize>([a, b]: [&R; 2], f: impl Fn(&R) -> [R; N]) -> [R; N] {
    let half = |x: R| x / R::from(2);
    let (middle, length) = (half(a.clone() + b.clone()), half(b.clone() - a.clone()));
    let mut sums = [(); N].map(|()| R::from(0));
    for (x, weight) in R::nodes() {
        let values = f(&(middle.clone() + length.clone() * x.clone()));
        let weight = length.clone() * weight.clone();
        sums = std::array::from_fn(|i| sums[i].clone() + weight.clone() * values[i].clone());
    }
    sums
}

/// Legendre polynomial of the degree [`COUNT`] and its derivative.
fn legendre(x: &Precise) -> (Precise, Precise) {
    let (mut before, mut last) = (whole(1), x.clone());
    for k in 2..=COUNT {
        let next = (x * &last * (2 * k - 1) - before * (k - 1)) / whole(k);
        (before, last) = (last, next);
    }
    let slope = (before - x * &last) * COUNT / (whole(1) - x.sqr());
    (last, slope)
}

/// Turning point.
#[derive(Clone, Copy, PartialEq)]
pub enum TurningPoint {
    /// Turning point u = e₁.
    Lower,
    /// Turning point u = e₂.
    Upper,
}

/// Constants of a motion; differences of the branch points are separate constants.
#[derive(Clone)]
pub struct Integrands<R> {
    pub s: R,
    pub g: R,
    pub a_over_p: R,
    pub one_plus_e1: R,
    pub one_minus_e2: R,
    pub e2_minus_e1: R,
    pub e3_minus_e2: R,
    /// Whether torque acts. Without torque e₃ - u does not depend on u, and is 1 in the units of this module.
    pub torque: bool,
    /// Rates (l ± n)/(2A).
    pub momenta: [R; 2],
}

impl Integrands<Precise> {
    /// Constants in numbers of another type or precision.
    pub fn map<R>(&self, number: fn(&Precise) -> R) -> Integrands<R> {
        Integrands {
            s: number(&self.s),
            g: number(&self.g),
            a_over_p: number(&self.a_over_p),
            one_plus_e1: number(&self.one_plus_e1),
            one_minus_e2: number(&self.one_minus_e2),
            e2_minus_e1: number(&self.e2_minus_e1),
            e3_minus_e2: number(&self.e3_minus_e2),
            torque: self.torque,
            momenta: self.momenta.each_ref().map(number),
        }
    }
}

impl<R: Number> Integrands<R> {
    /// Values of 1 + u, 1 - u and e₃ - u, where x is the sine of the difference of χ from a turning point.
    pub fn heights(&self, end: TurningPoint, x: &R) -> [R; 3] {
        let square = x.clone() * x.clone();
        let complement = R::from(1) - square.clone();
        let (above, below) =
            if end == TurningPoint::Lower { (square, complement) } else { (complement, square) };
        let rise = self.e2_minus_e1.clone() * above;
        let fall = self.e2_minus_e1.clone() * below;
        let drop = if self.torque { fall.clone() } else { R::from(0) };
        [self.one_plus_e1.clone() + rise, self.one_minus_e2.clone() + fall, self.e3_minus_e2.clone() + drop]
    }

    /// Derivatives of t, arg α and arg β with respect to x, without the rate ±τ/2.
    pub fn rates(&self, end: TurningPoint, x: &R) -> [R; 3] {
        let [one_plus_u, one_minus_u, below_e3] = self.heights(end, x);
        let d = self.a_over_p.clone() + self.s.clone() * (one_plus_u.clone() * one_minus_u.clone());
        let cosine = R::from(1) - x.clone() * x.clone();
        let slowness = (R::from(2) * d / (self.g.clone() * below_e3 * cosine)).root();
        let turning = |i: usize, complement: R| match self.momenta[i].clone() {
            momentum if momentum == R::from(0) => momentum,
            momentum => momentum / complement * slowness.clone(),
        };
        let (alpha, beta) = (turning(0, one_plus_u), turning(1, one_minus_u));
        [slowness, alpha, beta]
    }
}

impl Integrands<f64> {
    /// Square of the rate of Φ without its mean rotation: |α|'² + |β|'² plus |α|² and |β|² times the squared deviations of the rates of arg α
    /// and arg β from their mean rates.
    pub fn relative_speed_squared(&self, end: TurningPoint, x: f64, mean_rates: [f64; 2]) -> f64 {
        let [slowness, alpha, beta] = self.rates(end, &x);
        let [one_plus_u, one_minus_u, _] = self.heights(end, &x);
        let rise = self.e2_minus_e1 * x / slowness;
        let tilting = rise * rise / (one_plus_u * one_minus_u);
        let turning =
            |rate: f64, mean: f64, complement: f64| 0.5 * complement * (rate / slowness - mean).powi(2);
        let turning = turning(alpha, mean_rates[0], one_plus_u) + turning(beta, mean_rates[1], one_minus_u);
        if tilting.is_nan() { turning } else { turning + tilting }
    }

    /// Distance of the nearest singularity from the turning point, as the sine of an imaginary angle; `None` for the pole of
    /// an aperiodic motion.
    pub fn depth(&self, end: TurningPoint) -> Option<f64> {
        // e₄² - 1 = A/(ps)
        let spread = self.a_over_p / self.s;
        let beyond_e4 = spread / ((1.0 + spread).sqrt() + 1.0);
        let (gap, further) = match end {
            TurningPoint::Lower => (self.one_plus_e1, f64::INFINITY),
            TurningPoint::Upper if self.e3_minus_e2 == 0.0 => return None,
            TurningPoint::Upper => (self.one_minus_e2, self.e3_minus_e2),
        };
        let gaps = [gap, gap + beyond_e4, further].into_iter().filter(|gap| *gap > 0.0);
        Some((gaps.fold(f64::INFINITY, f64::min) / self.e2_minus_e1).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_degree_79_are_exact() {
        let power = |x: &Precise, n: usize| (0..n).fold(precise(1.0), |product, _| product * x);
        for n in [0, 1, 2, 17, 78, 79] {
            let [integral] = integrate([&precise(1.0), &precise(2.0)], |x| [power(x, n)]);
            let exact = (power(&precise(2.0), n + 1) - precise(1.0)) / whole(n as i64 + 1);
            let error = to_f64(&((integral - &exact) / exact)).abs();
            assert!(error < 1e-54, "{n}: {error:e}");
        }
    }
}

//! Integrands near a turning point, in 192 bits and in `f64`.

use super::gauss::Number;
use super::precise::Precise;

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

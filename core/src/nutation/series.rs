//! The law as a power series in time: the motion around any of its points, to sixteen terms.
//!
//! Every quantity of the law is a product, a quotient or a root of earlier ones, so its coefficients follow one after the
//! other from convolutions. The series of χ itself is never formed: sin χ, cos χ and e^{i(θ ± χ)} have linear equations.

use super::Nutation;
use crate::complex::Complex;
use crate::real::Float;

/// Terms of a series. A segment that a short polynomial can follow is a small part of the radius of convergence:
/// sixteen terms leave 1e-10 where degree 5 leaves 3e-8, and 1e-16 where degree 9 leaves 1e-16.
pub(crate) const TERMS: usize = 16;

/// Coefficients of 1, x, x², ...
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Series([f64; TERMS]);

/// A point of the motion, as an expansion needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point {
    pub(crate) sine: f64,
    pub(crate) cosine: f64,
    /// e^{i(θ + χ)} and e^{i(θ - χ)} for α, then for β; θ is what a slow phase has turned beyond its mean.
    pub(crate) turning: [[Complex<f64>; 2]; 2],
}

/// The motion around a point, as functions of x = (t - t₀)/unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Expansion {
    pub(crate) sine: Series,
    pub(crate) cosine: Series,
    pub(crate) turning: [[Complex<Series>; 2]; 2],
    /// θ of α and of β, counted from the point, rad.
    pub(crate) theta: [Series; 2],
}

impl Series {
    const ZERO: Self = Self([0.0; TERMS]);

    fn constant(value: f64) -> Self {
        let mut series = Self::ZERO;
        series.put(0, value);
        series
    }

    /// The k-th coefficient.
    pub(crate) fn get(&self, k: usize) -> f64 {
        self.0.get(k).copied().unwrap_or(0.0)
    }

    fn put(&mut self, k: usize, value: f64) {
        if let Some(coefficient) = self.0.get_mut(k) {
            *coefficient = value;
        }
    }

    /// The value at x.
    pub(crate) fn value(&self, x: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// All coefficients.
    pub(crate) fn coefficients(&self) -> [f64; TERMS] {
        self.0
    }

    /// The k-th coefficient of a product.
    fn product(a: &Self, b: &Self, k: usize) -> f64 {
        let leading = |series: &'_ Self| series.0.into_iter().take(k + 1);
        leading(a).zip(b.0.iter().take(k + 1).rev()).fold(0.0, |sum, (x, y)| sum + x * y)
    }

    /// The k-th coefficient of q = n/d, from that of n and the earlier ones of q.
    fn quotient(n: f64, d: &Self, q: &Self, k: usize) -> f64 {
        let known = d.0.iter().skip(1).take(k).zip(q.0.iter().take(k).rev());
        (n - known.fold(0.0, |sum, (x, y)| sum + x * y)) / d.get(0)
    }

    /// The k-th coefficient of r = √square, from the earlier ones of r.
    fn root(square: &Self, r: &Self, k: usize) -> f64 {
        if k == 0 {
            return Float::sqrt(square.get(0));
        }
        let known = r.0.iter().take(k).skip(1).zip(r.0.iter().take(k).skip(1).rev());
        (square.get(k) - known.fold(0.0, |sum, (x, y)| sum + x * y)) / (2.0 * r.get(0))
    }
}

impl Complex<Series> {
    fn constant(z: Complex<f64>) -> Self {
        Self { re: Series::constant(z.re), im: Series::constant(z.im) }
    }

    /// The value at x.
    pub(crate) fn value(&self, x: f64) -> Complex<f64> {
        Complex::new(self.re.value(x), self.im.value(x))
    }
}

impl Point {
    /// χ = 0, where all phases are counted from.
    pub(crate) const LOWEST: Self = Self { sine: 0.0, cosine: 1.0, turning: [[Complex::ONE; 2]; 2] };
}

impl Expansion {
    fn starting_at(point: &Point) -> Self {
        Self {
            sine: Series::constant(point.sine),
            cosine: Series::constant(point.cosine),
            turning: point.turning.map(|pair| pair.map(Complex::<Series>::constant)),
            theta: [Series::ZERO; 2],
        }
    }

    /// The point at x, put back on its circles.
    pub(crate) fn point(&self, x: f64) -> Point {
        let (sine, cosine) = (self.sine.value(x), self.cosine.value(x));
        let unit = 1.0 / Float::sqrt(sine * sine + cosine * cosine);
        let onto_circle = |z: Complex<f64>| z.scaled(1.0 / Float::sqrt(z.norm_squared()));
        Point {
            sine: sine * unit,
            cosine: cosine * unit,
            turning: self.turning.each_ref().map(|pair| pair.each_ref().map(|z| onto_circle(z.value(x)))),
        }
    }

    /// The largest of the last terms at x: what the series leaves out is smaller.
    pub(crate) fn last_term(&self, x: f64) -> f64 {
        let power = (1..TERMS).fold(1.0, |power, _| power * Float::abs(x));
        let last = |series: &Series| Float::abs(series.get(TERMS - 1)) * power;
        let turning =
            self.turning.iter().flatten().fold(0.0, |sum: f64, z| sum.max(last(&z.re)).max(last(&z.im)));
        turning.max(last(&self.sine)).max(last(&self.cosine))
    }

    /// The coefficients k + 1 from those up to k of the rates per unit of x: z' = i z (θ' ± χ'), and the like.
    fn extend(&mut self, k: usize, chi: &Series, theta: &[Series; 2]) {
        let per_power = 1.0 / (k + 1) as f64;
        let sine = per_power * Series::product(chi, &self.cosine, k);
        let cosine = -per_power * Series::product(chi, &self.sine, k);
        self.sine.put(k + 1, sine);
        self.cosine.put(k + 1, cosine);
        for ((turning, rate), angle) in self.turning.iter_mut().zip(theta).zip(&mut self.theta) {
            angle.put(k + 1, per_power * rate.get(k));
            let mut whole = Series::ZERO;
            for (z, sense) in turning.iter_mut().zip([1.0, -1.0]) {
                for i in 0..=k {
                    whole.put(i, rate.get(i) + sense * chi.get(i));
                }
                let re = -per_power * Series::product(&whole, &z.im, k);
                let im = per_power * Series::product(&whole, &z.re, k);
                z.re.put(k + 1, re);
                z.im.put(k + 1, im);
            }
        }
    }
}

impl Nutation<f64> {
    /// Expands around `point`, with `unit` of time to a unit of x; `excess` is what the rates of the two slow phases have
    /// besides ψ': drift less mean, rad per unit time.
    pub(crate) fn expand(&self, point: &Point, unit: f64, excess: [f64; 2]) -> Expansion {
        let [alpha_excess, beta_excess] = excess;
        let mut motion = Expansion::starting_at(point);
        let [mut below, mut above, mut d, mut square, mut chi] = [Series::ZERO; 5];
        let [mut alpha_divisor, mut beta_divisor, mut alpha, mut beta] = [Series::ZERO; 4];
        let (mut chi_per_x, mut theta_per_x) = (Series::ZERO, [Series::ZERO; 2]);
        for k in 0..TERMS {
            let constant = |value: f64| if k == 0 { value } else { 0.0 };
            // 1 - u, 1 + u and D; the one constant term that could cancel is direct
            let swing = self.e2_minus_e1 * Series::product(&motion.cosine, &motion.cosine, k);
            let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * point.sine * point.sine;
            below.put(k, swing + constant(self.one_minus_e2));
            above.put(k, if k == 0 { one_plus_u } else { -swing });
            d.put(k, self.s * Series::product(&below, &above, k) + constant(self.a_over_p));
            // χ'² = g (e₃ - u)/(2D), and its root
            let e3_minus_u = swing + constant(self.e3_minus_e2);
            square.put(k, Series::quotient(self.half_g * e3_minus_u, &d, &square, k));
            chi.put(k, Series::root(&square, &chi, k));
            // ψ_A' and ψ_B'
            let smoothing = Series::product(&d, &chi, k);
            alpha_divisor.put(k, d.get(k) + self.alpha_smoothing * smoothing);
            beta_divisor.put(k, self.root_e3 * d.get(k) + self.beta_smoothing * smoothing);
            let alpha_rest = self.alpha_scale * (self.s * below.get(k) + constant(self.a_over_p_e3));
            let beta_rest = self.beta_scale * (self.s_e3 * above.get(k) - constant(self.a_over_p));
            alpha.put(k, Series::quotient(alpha_rest, &alpha_divisor, &alpha, k));
            beta.put(k, Series::quotient(beta_rest, &beta_divisor, &beta, k));

            chi_per_x.put(k, unit * chi.get(k));
            let [alpha_theta, beta_theta] = &mut theta_per_x;
            alpha_theta.put(k, unit * (alpha.get(k) + constant(alpha_excess)));
            beta_theta.put(k, unit * (beta.get(k) + constant(beta_excess)));
            motion.extend(k, &chi_per_x, &theta_per_x);
        }
        motion
    }
}

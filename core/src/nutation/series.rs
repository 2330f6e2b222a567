//! The law as a power series in time: the motion around any of its points, to sixteen terms.
//!
//! Every quantity of the law is a product, a quotient or a root of earlier ones, so its coefficients follow one after the
//! other from convolutions. The series of χ itself is never formed: sin χ, cos χ and e^{i(θ ± χ)} have linear equations.

use super::Nutation;
use crate::complex::Complex;
use crate::real::{Float, Scalar};
use crate::turns::Turns;

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
    /// θ of α and of β: what their slow phases have turned beyond their mean, rad.
    pub(crate) theta: [f64; 2],
}

/// The motion around a point, as functions of x = (t - t₀)/unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Expansion {
    pub(crate) sine: Series,
    pub(crate) cosine: Series,
    /// dχ/dx.
    chi: Series,
    /// dθ/dx of α and of β.
    theta: [Series; 2],
    origin: Point,
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

    pub(crate) fn put(&mut self, k: usize, value: f64) {
        if let Some(coefficient) = self.0.get_mut(k) {
            *coefficient = value;
        }
    }

    /// The value at x.
    pub(crate) fn value(&self, x: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// The integral from 0 to x.
    fn integral(&self, x: f64) -> f64 {
        let terms = self.0.iter().enumerate().rev();
        x * terms.fold(0.0, |sum, (k, c)| sum * x + c / (k + 1) as f64)
    }

    /// All coefficients.
    pub(crate) fn coefficients(&self) -> &[f64; TERMS] {
        &self.0
    }

    /// The k-th coefficient of a product.
    fn product(a: &Self, b: &Self, k: usize) -> f64 {
        a.0.iter().take(k + 1).zip(b.0.iter().take(k + 1).rev()).fold(0.0, |sum, (x, y)| sum + x * y)
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

impl Point {
    /// χ = 0, where all phases are counted from.
    pub(crate) const LOWEST: Self = Self { sine: 0.0, cosine: 1.0, theta: [0.0; 2] };
}

impl Expansion {
    /// The point at x, with sin χ and cos χ put back on their circle.
    pub(crate) fn point(&self, x: f64) -> Point {
        let (sine, cosine) = (self.sine.value(x), self.cosine.value(x));
        let unit = 1.0 / Float::sqrt(sine * sine + cosine * cosine);
        Point { sine: sine * unit, cosine: cosine * unit, theta: self.theta_at(x) }
    }

    /// θ of α and of β at x, rad.
    pub(crate) fn theta_at(&self, x: f64) -> [f64; 2] {
        let [alpha, beta] = self.origin.theta;
        let [alpha_rate, beta_rate] = &self.theta;
        [alpha + alpha_rate.integral(x), beta + beta_rate.integral(x)]
    }

    /// The bracket p e^{iχ} + q e^{-iχ} times e^{iθ}, of α (`which` = 0) or of β (1): real and imaginary part.
    #[inline(never)] // set-up's frames should not add up on a small stack
    pub(crate) fn turned(&self, which: usize, [p, q]: [f64; 2]) -> [Series; 2] {
        let rate = self.theta.get(which).unwrap_or(&Series::ZERO);
        let angle = self.origin.theta.get(which).copied().unwrap_or(0.0);
        let (sine, cosine) = f64::sine_cosine(Turns::from_radians(angle));
        let theta = Complex::new(cosine, sine);
        let chi = Complex::new(self.origin.cosine, self.origin.sine);
        let [mut re, mut im] = exponential(rate, &self.chi, 1.0, theta * chi, p);
        let [backward_re, backward_im] = exponential(rate, &self.chi, -1.0, theta * chi.conj(), q);
        for (sum, term) in [(&mut re, backward_re), (&mut im, backward_im)] {
            sum.0.iter_mut().zip(term.0).for_each(|(sum, term)| *sum += term);
        }
        [re, im]
    }

    /// The largest of the last terms at x: what the series leave out is smaller.
    pub(crate) fn last_term(&self, x: f64) -> f64 {
        let power = (1..TERMS).fold(1.0, |power, _| power * Float::abs(x));
        let [alpha, beta] = &self.theta;
        let last = |series: &Series| Float::abs(series.get(TERMS - 1)) * power;
        let angle = last(alpha).max(last(beta)) * Float::abs(x) / TERMS as f64;
        last(&self.sine).max(last(&self.cosine)).max(angle)
    }
}

/// scale · start · e^{i ∫(θ' ± χ')}: z' = i z (θ' ± χ').
#[inline(never)]
fn exponential(theta: &Series, chi: &Series, sense: f64, start: Complex<f64>, scale: f64) -> [Series; 2] {
    let mut rate = *theta;
    rate.0.iter_mut().zip(chi.0).for_each(|(rate, chi)| *rate += sense * chi);
    let (mut re, mut im) = (Series::constant(scale * start.re), Series::constant(scale * start.im));
    for k in 0..TERMS - 1 {
        let per_power = 1.0 / (k + 1) as f64;
        let (next_re, next_im) = (-Series::product(&rate, &im, k), Series::product(&rate, &re, k));
        re.put(k + 1, per_power * next_re);
        im.put(k + 1, per_power * next_im);
    }
    [re, im]
}

impl Nutation<f64> {
    /// Expands around `point`, with `unit` of time to a unit of x; `excess` is what the rates of the two slow phases have
    /// besides ψ': drift less mean, rad per unit time.
    #[inline(never)]
    pub(crate) fn expand(&self, point: &Point, unit: f64, excess: [f64; 2]) -> Expansion {
        let [alpha_excess, beta_excess] = excess;
        let (mut sine, mut cosine) = (Series::constant(point.sine), Series::constant(point.cosine));
        // w = 1 - u, and the rates by x of χ, θ of α and θ of β
        let [mut w, mut d, mut square, mut chi, mut alpha, mut beta] = [Series::ZERO; 6];
        let [mut alpha_divisor, mut beta_divisor] = [Series::ZERO; 2];
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * point.sine * point.sine;
        for k in 0..TERMS {
            let constant = |value: f64| if k == 0 { value } else { 0.0 };
            let swing = self.e2_minus_e1 * Series::product(&cosine, &cosine, k);
            w.put(k, swing + constant(self.one_minus_e2));
            // D = A/p + s (1 - u)(1 + u), where 1 + u = 2 - w; only its constant term could cancel, and that is direct
            let product =
                if k == 0 { w.get(0) * one_plus_u } else { 2.0 * w.get(k) - Series::product(&w, &w, k) };
            d.put(k, self.s * product + constant(self.a_over_p));
            // (dχ/dx)² = unit² g (e₃ - u)/(2D), and its root
            let e3_minus_u = swing + constant(self.e3_minus_e2);
            square.put(k, Series::quotient(unit * unit * self.half_g * e3_minus_u, &d, &square, k));
            chi.put(k, Series::root(&square, &chi, k));
            // ψ_A' and ψ_B'
            let smoothing = Series::product(&d, &chi, k);
            alpha_divisor.put(k, unit * d.get(k) + self.alpha_smoothing * smoothing);
            beta_divisor.put(k, unit * self.root_e3 * d.get(k) + self.beta_smoothing * smoothing);
            let above = if k == 0 { one_plus_u } else { -w.get(k) };
            let alpha_rest =
                unit * unit * self.alpha_scale * (self.s * w.get(k) + constant(self.a_over_p_e3));
            let beta_rest = unit * unit * self.beta_scale * (self.s_e3 * above - constant(self.a_over_p));
            alpha.put(k, Series::quotient(alpha_rest, &alpha_divisor, &alpha, k));
            beta.put(k, Series::quotient(beta_rest, &beta_divisor, &beta, k));

            let per_power = 1.0 / (k + 1) as f64;
            let (next_sine, next_cosine) =
                (Series::product(&chi, &cosine, k), -Series::product(&chi, &sine, k));
            sine.put(k + 1, per_power * next_sine);
            cosine.put(k + 1, per_power * next_cosine);
        }
        alpha.put(0, alpha.get(0) + unit * alpha_excess);
        beta.put(0, beta.get(0) + unit * beta_excess);
        Expansion { sine, cosine, chi, theta: [alpha, beta], origin: *point }
    }
}

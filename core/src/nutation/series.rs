//! The law as a power series in time: the motion around any of its points, to sixteen terms or fewer.
//!
//! Every quantity of the law is a product, a quotient or a root of earlier ones, so its coefficients follow one after the
//! other from convolutions. The series of χ itself is never formed: sin χ, cos χ and e^{i(θ ± χ)} have linear equations.

use super::{Nutation, PhaseRates};
use crate::complex::Complex;
use crate::real::{Float, Scalar};
use crate::turns::Turns;

/// Terms of a series at most; it stops where they fall below what the scalar can tell. A segment that a short polynomial
/// can follow is a small part of the radius of convergence: where degree 5 leaves 3e-8 sixteen terms leave 1e-10, and no less
/// than degree 9 where that leaves 1e-16, which is rounding.
pub(crate) const TERMS: usize = 16;

/// 1/(k + 1), which integrating x^k divides by: a product costs a chip without a divider much less.
#[allow(clippy::indexing_slicing)] // evaluated by the compiler, which would refuse an index out of range
pub(crate) static PER_POWER: [f64; TERMS] = {
    let mut inverses = [1.0; TERMS];
    let mut k = 0;
    while k < TERMS {
        inverses[k] = 1.0 / (k + 1) as f64;
        k += 1;
    }
    inverses
};

/// Coefficients of 1, x, x², ...
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Series([f64; TERMS]);

/// A point of the motion. Its phases are integers, so that marching from point to point adds up without rounding, and
/// the cosine of χ near a quarter turn keeps its digits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Point {
    pub(crate) chi: Turns,
    /// θ of α and of β: what their slow phases have turned beyond their mean.
    pub(crate) theta: [Turns; 2],
}

/// The rates of χ, of ψ_A and ψ_B, and of θ_A and θ_B at a point, by x.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes {
    pub(crate) psi: PhaseRates<f64>,
    /// ψ' less its mean: given apart, because the difference may be small.
    pub(crate) theta: [f64; 2],
    /// What an error of χ here counts for, one of θ being 1: more where the motion rests, because it delays what follows.
    pub(crate) weight: f64,
}

/// The motion around a point, as functions of x = (t - t₀)/unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Expansion {
    /// dχ/dx.
    chi: Series,
    /// dθ/dx of α and of β.
    theta: [Series; 2],
    origin: Point,
    /// What an error of χ counts for.
    weight: f64,
    /// How many terms there are: as many as were needed, at most [`TERMS`].
    terms: usize,
    /// For what is computed on the way, so that a small stack holds it once.
    room: [Series; 5],
}

impl Series {
    const ZERO: Self = Self([0.0; TERMS]);

    fn set_constant(&mut self, value: f64) {
        self.0.fill(0.0);
        self.put(0, value);
    }

    /// The k-th coefficient.
    fn get(&self, k: usize) -> f64 {
        self.0.get(k).copied().unwrap_or(0.0)
    }

    fn put(&mut self, k: usize, value: f64) {
        if let Some(coefficient) = self.0.get_mut(k) {
            *coefficient = value;
        }
    }

    /// The integral from 0 to x of the first `terms`.
    fn integral(&self, x: f64, terms: usize) -> f64 {
        let terms = self.0.iter().zip(&PER_POWER).take(terms).rev();
        x * terms.fold(0.0, |sum, (c, per_power)| sum * x + c * per_power)
    }

    /// The k-th coefficient of a product.
    fn product(a: &Self, b: &Self, k: usize) -> f64 {
        a.0.iter().take(k + 1).zip(b.0.iter().take(k + 1).rev()).fold(0.0, |sum, (x, y)| sum + x * y)
    }

    /// The k-th coefficient of a square.
    fn square(a: &Self, k: usize) -> f64 {
        folded(a.0.get(..=k).unwrap_or_default())
    }

    /// What a₁ bₖ₋₁ + ... + aₙ bₖ₋ₙ adds to the k-th coefficient of a product, n = `last`.
    fn rest(a: &Self, b: &Self, k: usize, last: usize) -> f64 {
        let pairs = a.0.iter().skip(1).take(last).zip(b.0.iter().take(k).rev());
        pairs.fold(0.0, |sum, (x, y)| sum + x * y)
    }
}

/// The larger of two, or NaN if one is.
pub(crate) fn worse(a: f64, b: f64) -> f64 {
    if b <= a || a.is_nan() { a } else { b }
}

/// Σ cᵢ cₙ₋₁₋ᵢ, each pair once.
fn folded(c: &[f64]) -> f64 {
    let half = c.len() / 2;
    let pairs = c.iter().zip(c.iter().rev()).take(half);
    let sum = 2.0 * pairs.fold(0.0, |sum, (x, y)| sum + x * y);
    match c.get(half) {
        Some(middle) if c.len() % 2 == 1 => sum + middle * middle,
        _ => sum,
    }
}

impl Point {
    /// sin χ and cos χ.
    pub(crate) fn sine_cosine(&self) -> (f64, f64) {
        f64::sine_cosine(self.chi)
    }
}

impl Expansion {
    /// Room for one.
    pub(crate) const EMPTY: Self = Self {
        chi: Series::ZERO,
        theta: [Series::ZERO; 2],
        origin: Point { chi: Turns::ZERO, theta: [Turns::ZERO; 2] },
        weight: 1.0,
        terms: 0,
        room: [Series::ZERO; 5],
    };

    /// The point at x.
    pub(crate) fn point(&self, x: f64) -> Point {
        Point { chi: self.chi_at(x), theta: self.theta_at(x) }
    }

    /// χ at x.
    pub(crate) fn chi_at(&self, x: f64) -> Turns {
        self.origin.chi + Turns::from_radians(self.chi.integral(x, self.terms))
    }

    /// dχ/dx at x.
    pub(crate) fn chi_slope(&self, x: f64) -> f64 {
        self.chi.0.iter().take(self.terms).rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// θ of α and of β at x.
    pub(crate) fn theta_at(&self, x: f64) -> [Turns; 2] {
        let [alpha, beta] = self.origin.theta;
        let [alpha_rate, beta_rate] = &self.theta;
        let change = |rate: &Series| Turns::from_radians(rate.integral(x, self.terms));
        [alpha + change(alpha_rate), beta + change(beta_rate)]
    }

    /// The bracket p e^{iχ} + q e^{-iχ} times e^{iθ}, of α (`which` = 0) or of β (1), in real and imaginary part, to
    /// where its terms fall below `least`.
    #[inline(never)] // set-up's frames should not add up on a small stack
    pub(crate) fn turned(&mut self, which: usize, [p, q]: [f64; 2], least: f64) -> [&mut [f64; TERMS]; 2] {
        let slow = self.theta.get(which).unwrap_or(&Series::ZERO);
        let theta = self.origin.theta.get(which).copied().unwrap_or_default();
        let [sum_re, sum_im, re, im, rate] = &mut self.room;
        sum_re.0.fill(0.0);
        sum_im.0.fill(0.0);
        for (forwards, scale) in [(true, p), (false, q)] {
            let (sense, chi) = if forwards { (1.0, self.origin.chi) } else { (-1.0, -self.origin.chi) };
            for (rate, (slow, chi)) in rate.0.iter_mut().zip(slow.0.iter().zip(&self.chi.0)) {
                *rate = slow + sense * chi;
            }
            exponential(rate, Complex::cis(theta + chi).scaled(scale), least, [re, im]);
            for (sum, part) in [(&mut *sum_re, &*re), (&mut *sum_im, &*im)] {
                sum.0.iter_mut().zip(part.0).for_each(|(sum, term)| *sum += term);
            }
        }
        [&mut sum_re.0, &mut sum_im.0]
    }

    /// Bound of what the series of the phases leave out at x > 0, rad, by the larger of the last two terms of their rates,
    /// if further terms fall to a quarter each: where sixteen terms leave little, they fall to a tenth.
    pub(crate) fn left_out(&self, x: f64) -> f64 {
        let before = self.terms.saturating_sub(2);
        let power = (0..before).fold(1.0, |power, _| power * x);
        let last = worse(self.term(before) * power, self.term(before + 1) * power * x);
        last * x / (3 * self.terms) as f64
    }

    /// The largest k-th coefficient of the phases by x, that of χ weighed.
    fn term(&self, k: usize) -> f64 {
        let [alpha, beta] = &self.theta;
        let [chi, alpha, beta] = [&self.chi, alpha, beta].map(|rate| Float::abs(rate.get(k)));
        worse(self.weight * chi, worse(alpha, beta))
    }
}

/// start · e^{i ∫ rate}: z' = i z rate.
#[inline(never)]
fn exponential(rate: &Series, start: Complex<f64>, least: f64, [re, im]: [&mut Series; 2]) {
    re.set_constant(start.re);
    im.set_constant(start.im);
    let mut before = f64::INFINITY;
    for (k, per_power) in PER_POWER.iter().enumerate().take(TERMS - 1) {
        let next_re = -Series::product(rate, im, k) * per_power;
        let next_im = Series::product(rate, re, k) * per_power;
        re.put(k + 1, next_re);
        im.put(k + 1, next_im);
        let size = worse(Float::abs(next_re), Float::abs(next_im));
        if worse(size, before) < least {
            break;
        }
        before = size;
    }
}

impl Nutation<f64> {
    /// Expands around `point`, where the slopes are given, with `unit` of time to a unit of x; until two terms at x = 2
    /// are below `least`.
    #[inline(never)]
    pub(crate) fn expand(&self, point: &Point, slopes: &Slopes, unit: f64, least: f64, to: &mut Expansion) {
        let (point_sine, point_cosine) = point.sine_cosine();
        (to.origin, to.weight, to.terms) = (*point, slopes.weight, TERMS);
        // sin χ, cos χ, w = 1 - u, D = A/p + s (1 - u)(1 + u), and D dχ/dx
        let Expansion { chi, theta: [alpha, beta], room: [sine, cosine, w, d, drive], .. } = to;
        for series in [&mut *sine, cosine, chi, alpha, beta, w, d, drive] {
            series.0.fill(0.0);
        }
        sine.put(0, point_sine);
        cosine.put(0, point_cosine);
        chi.put(0, slopes.psi.nutation);
        alpha.put(0, slopes.psi.alpha);
        beta.put(0, slopes.psi.beta);
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * point_sine * point_sine;
        // ψ_A' and ψ_B' divide by combinations of D and D dχ/dx
        let alpha_divisor = [unit, self.alpha_smoothing];
        let beta_divisor = [unit * self.root_e3, self.beta_smoothing];
        let mut per_leading = [0.0; 3];
        let time_squared = unit * unit;
        // (dχ/dx)² D = unit² g (e₃ - u)/2, and the numerators of ψ_A' and ψ_B'
        let scales = [self.half_g, self.s * self.alpha_scale, -self.s_e3 * self.beta_scale];
        let [chi_scale, alpha_scale, beta_scale] = scales.map(|scale| scale * time_squared);
        let (mut power, mut before) = (1.0, f64::INFINITY);
        for (k, per_power) in PER_POWER.iter().enumerate() {
            let swing = self.e2_minus_e1 * Series::square(cosine, k);
            if k == 0 {
                let one_minus_u = swing + self.one_minus_e2;
                w.put(0, one_minus_u);
                d.put(0, self.a_over_p + self.s * one_minus_u * one_plus_u);
                drive.put(0, d.get(0) * chi.get(0));
            } else {
                w.put(k, swing);
                // 1 + u = 2 - w; only its constant term could cancel
                d.put(k, self.s * (2.0 * swing - Series::square(w, k)));
                // (D dχ/dx) dχ/dx is known; what is not known is χₖ in both factors, times D₀ χ₀
                let known = Series::rest(d, chi, k, k);
                let [per_drive, ..] = per_leading;
                let rest = chi_scale * swing - Series::rest(drive, chi, k, k - 1) - chi.get(0) * known;
                chi.put(k, rest * per_drive);
                drive.put(k, known + d.get(0) * chi.get(k));
            }
            if k == 0 {
                let leading = |[of_d, of_drive]: [f64; 2]| of_d * d.get(0) + of_drive * drive.get(0);
                per_leading =
                    [2.0 * drive.get(0), leading(alpha_divisor), leading(beta_divisor)].map(|x| 1.0 / x);
            } else {
                let rest = |[of_d, of_drive]: [f64; 2], rate: &Series| {
                    of_d * Series::rest(d, rate, k, k) + of_drive * Series::rest(drive, rate, k, k)
                };
                let [_, per_alpha, per_beta] = per_leading;
                alpha.put(k, (alpha_scale * swing - rest(alpha_divisor, alpha)) * per_alpha);
                beta.put(k, (beta_scale * swing - rest(beta_divisor, beta)) * per_beta);
            }
            let next = [Series::product(chi, cosine, k), -Series::product(chi, sine, k)];
            let [next_sine, next_cosine] = next.map(|sum| sum * per_power);
            sine.put(k + 1, next_sine);
            cosine.put(k + 1, next_cosine);
            let found = [next_sine, next_cosine, slopes.weight * chi.get(k), alpha.get(k), beta.get(k)];
            let size = power * found.into_iter().map(Float::abs).fold(0.0, worse);
            if worse(size, before) < least {
                to.terms = k + 1;
                break;
            }
            (power, before) = (2.0 * power, size);
        }
        let [alpha_slope, beta_slope] = slopes.theta;
        let [alpha, beta] = &mut to.theta;
        alpha.put(0, alpha_slope);
        beta.put(0, beta_slope);
    }
}

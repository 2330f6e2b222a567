//! Power series of the motion in time around any of its points, with at most sixteen terms.
//!
//! Every quantity of the law is a product, a quotient or a root of earlier ones, so its coefficients follow one after
//! the other from convolutions. The series of χ itself is not needed: sin χ, cos χ and e^{i(θ ± χ)} satisfy linear
//! equations.

use crate::complex::Complex;
use crate::law::{Law, PhaseRates};
use crate::phase::Phase;
use crate::scalar::{Float, Scalar};

/// Largest number of terms of a series; fewer are computed where the terms fall below the resolution of the scalar.
/// The segments of a table are short compared with the radius of convergence: where degree 5 leaves an error of 3e-8,
/// sixteen terms leave 1e-10; where degree 9 or more leaves 1e-16, they leave only rounding.
pub(crate) const TERMS: usize = 16;

/// Factors 1/(k + 1) for the integration of x^k: a product costs much less than a division on a chip without a
/// divider.
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

/// Phases of a point of the motion. They are integers, so that the steps from point to point add without rounding,
/// and the cosine of χ near a quarter turn keeps its digits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PhasePoint {
    pub(crate) chi: Phase,
    /// Phases θ of α and of β: the slow phases minus their mean rotation.
    pub(crate) theta: [Phase; 2],
}

/// Derivatives of χ, ψ_A and ψ_B, and θ_A and θ_B with respect to x, at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes {
    pub(crate) psi: PhaseRates<f64>,
    /// Derivatives ψ' minus their mean. They are stored separately, because the difference may be small.
    pub(crate) theta: [f64; 2],
    /// Weight of an error of χ relative to one of θ. It is large where χ changes slowly, because the error is a delay
    /// of all that follows.
    pub(crate) weight: f64,
}

/// Expansion of the motion around a point, as functions of x = (t - t₀)/unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Expansion {
    /// Derivative dχ/dx.
    chi: Series,
    /// Derivatives dθ/dx of α and of β.
    theta: [Series; 2],
    origin: PhasePoint,
    /// Weight of an error of χ relative to one of θ.
    weight: f64,
    /// Magnitude of the terms whose difference is the variation of dψ/dx. Their rounding errors are errors of θ.
    variation_size: f64,
    /// Number of terms computed, at most [`TERMS`].
    terms: usize,
    /// Scratch series for intermediate results, stored here once so that the stack stays small.
    scratch: [Series; 5],
}

impl Series {
    const ZERO: Self = Self([0.0; TERMS]);

    fn set_constant(&mut self, value: f64) {
        self.0.fill(0.0);
        self.put(0, value);
    }

    /// Coefficient of x^k.
    fn get(&self, k: usize) -> f64 {
        self.0.get(k).copied().unwrap_or(0.0)
    }

    fn put(&mut self, k: usize, value: f64) {
        if let Some(coefficient) = self.0.get_mut(k) {
            *coefficient = value;
        }
    }

    /// Integral from 0 to x of the first `terms` terms.
    fn integral(&self, x: f64, terms: usize) -> f64 {
        let terms = self.0.iter().zip(&PER_POWER).take(terms).rev();
        x * terms.fold(0.0, |sum, (c, per_power)| sum * x + c * per_power)
    }

    /// Coefficient of x^k of a product.
    fn product(a: &Self, b: &Self, k: usize) -> f64 {
        a.0.iter().take(k + 1).zip(b.0.iter().take(k + 1).rev()).fold(0.0, |sum, (x, y)| sum + x * y)
    }

    /// Coefficient of x^k of a square.
    fn square(a: &Self, k: usize) -> f64 {
        folded(a.0.get(..=k).unwrap_or_default())
    }

    /// Sum a₁ bₖ₋₁ + ... + aₙ bₖ₋ₙ, the part of the k-th coefficient of a product with n = `last`.
    fn rest(a: &Self, b: &Self, k: usize, last: usize) -> f64 {
        let pairs = a.0.iter().skip(1).take(last).zip(b.0.iter().take(k).rev());
        pairs.fold(0.0, |sum, (x, y)| sum + x * y)
    }
}

/// Larger of two numbers, or NaN if one of them is NaN.
pub(crate) fn larger_or_nan(a: f64, b: f64) -> f64 {
    if b <= a || a.is_nan() { a } else { b }
}

/// Sum Σ cᵢ cₙ₋₁₋ᵢ, with each pair of equal products computed once.
fn folded(c: &[f64]) -> f64 {
    let half = c.len() / 2;
    let pairs = c.iter().zip(c.iter().rev()).take(half);
    let sum = 2.0 * pairs.fold(0.0, |sum, (x, y)| sum + x * y);
    match c.get(half) {
        Some(middle) if c.len() % 2 == 1 => sum + middle * middle,
        _ => sum,
    }
}

impl PhasePoint {
    /// sin χ and cos χ.
    pub(crate) fn sine_cosine(&self) -> (f64, f64) {
        f64::sine_cosine(self.chi)
    }
}

impl Expansion {
    /// Expansion before its first use.
    pub(crate) const EMPTY: Self = Self {
        chi: Series::ZERO,
        theta: [Series::ZERO; 2],
        origin: PhasePoint { chi: Phase::ZERO, theta: [Phase::ZERO; 2] },
        weight: 1.0,
        variation_size: 0.0,
        terms: 0,
        scratch: [Series::ZERO; 5],
    };

    /// Phases at x.
    pub(crate) fn point(&self, x: f64) -> PhasePoint {
        PhasePoint { chi: self.chi_at(x), theta: self.theta_at(x) }
    }

    /// Half phase χ at x.
    pub(crate) fn chi_at(&self, x: f64) -> Phase {
        self.origin.chi + Phase::from_radians(self.chi.integral(x, self.terms))
    }

    /// Derivative dχ/dx at x.
    pub(crate) fn chi_slope(&self, x: f64) -> f64 {
        self.chi.0.iter().take(self.terms).rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// Magnitudes of the terms that add up to the changes of χ and of θ at x > 0, rad; rounding errors are relative
    /// to them.
    pub(crate) fn sizes(&self, x: f64) -> [f64; 2] {
        let size = |rate: &Series| {
            x * rate.0.iter().take(self.terms).rev().fold(0.0, |sum, c| sum * x + Float::abs(*c))
        };
        let [alpha, beta] = &self.theta;
        [size(&self.chi), larger_or_nan(size(alpha), size(beta)) + x * self.variation_size]
    }

    /// Upper bound on |dθ/dx| of α and of β for x in [-1, 1], without the truncation error of the series.
    pub(crate) fn greatest_theta_slope(&self) -> f64 {
        let bound = |rate: &Series| rate.0.iter().take(self.terms).fold(0.0, |sum, c| sum + Float::abs(*c));
        let [alpha, beta] = &self.theta;
        larger_or_nan(bound(alpha), bound(beta))
    }

    /// Phases θ of α and of β at x.
    pub(crate) fn theta_at(&self, x: f64) -> [Phase; 2] {
        let [alpha, beta] = self.origin.theta;
        let [alpha_rate, beta_rate] = &self.theta;
        let change = |rate: &Series| Phase::from_radians(rate.integral(x, self.terms));
        [alpha + change(alpha_rate), beta + change(beta_rate)]
    }

    /// Writes the bracket p e^{iχ} + q e^{-iχ} times e^{iθ}, of α (`which` = 0) or of β (1), as real and imaginary
    /// part; the series end where their terms fall below `least`.
    #[inline(never)] // set-up's frames should not add up on a small stack
    pub(crate) fn turned(&mut self, which: usize, [p, q]: [f64; 2], least: f64) -> [&mut [f64; TERMS]; 2] {
        let slow = self.theta.get(which).unwrap_or(&Series::ZERO);
        let theta = self.origin.theta.get(which).copied().unwrap_or_default();
        let [sum_re, sum_im, re, im, rate] = &mut self.scratch;
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

    /// Estimate of the truncation error of the phases at x > 0, rad. It is made from the larger of the last two terms
    /// of their rates, and assumes that each further term is at most a quarter of the one before. Where sixteen terms
    /// leave a small error, the terms decrease by a factor of ten.
    pub(crate) fn left_out(&self, x: f64) -> f64 {
        let before = self.terms.saturating_sub(2);
        let power = (0..before).fold(1.0, |power, _| power * x);
        let last = larger_or_nan(self.term(before) * power, self.term(before + 1) * power * x);
        last * x / (3 * self.terms) as f64
    }

    /// Largest k-th coefficient of the rates of the phases, with the weight of χ.
    fn term(&self, k: usize) -> f64 {
        let [alpha, beta] = &self.theta;
        let [chi, alpha, beta] = [&self.chi, alpha, beta].map(|rate| Float::abs(rate.get(k)));
        larger_or_nan(self.weight * chi, larger_or_nan(alpha, beta))
    }
}

/// Series of start · e^{i ∫ rate}, the solution of z' = i z rate.
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
        let size = larger_or_nan(Float::abs(next_re), Float::abs(next_im));
        if larger_or_nan(size, before) < least {
            break;
        }
        before = size;
    }
}

impl Law<f64> {
    /// Expands the law around `point` with the given derivatives, where `unit` is the time that corresponds to x = 1.
    /// Terms are computed until two in succession are below `least` at x = 2.
    #[inline(never)]
    pub(crate) fn expand(
        &self,
        point: &PhasePoint,
        slopes: &Slopes,
        unit: f64,
        least: f64,
        to: &mut Expansion,
    ) {
        let (point_sine, point_cosine) = point.sine_cosine();
        (to.origin, to.weight, to.terms) = (*point, slopes.weight, TERMS);
        // sin χ, cos χ, w = 1 - u, D = A/p + s (1 - u)(1 + u), and D dχ/dx
        let Expansion { chi, theta: [alpha, beta], scratch: [sine, cosine, w, d, drive], .. } = to;
        for series in [&mut *sine, cosine, chi, alpha, beta, w, d, drive] {
            series.0.fill(0.0);
        }
        sine.put(0, point_sine);
        cosine.put(0, point_cosine);
        chi.put(0, slopes.psi.nutation);
        alpha.put(0, slopes.psi.alpha);
        beta.put(0, slopes.psi.beta);
        let one_plus_u = self.one_plus_e1 + self.e2_minus_e1 * point_sine * point_sine;
        // denominators of ψ_A' and ψ_B': combinations of D and D dχ/dx
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
                // 1 + u = 2 - w; only its constant term could have cancellation
                d.put(k, self.s * (2.0 * swing - Series::square(w, k)));
                // (D dχ/dx) dχ/dx is known; the unknown χₖ occurs in both factors, multiplied by D₀ χ₀
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
            let size = power * found.into_iter().map(Float::abs).fold(0.0, larger_or_nan);
            if larger_or_nan(size, before) < least {
                to.terms = k + 1;
                break;
            }
            (power, before) = (2.0 * power, size);
        }
        let varying = d.0.iter().skip(1).take(to.terms).fold(0.0, |sum, term| sum + Float::abs(*term));
        let psi = larger_or_nan(Float::abs(slopes.psi.alpha), Float::abs(slopes.psi.beta));
        to.variation_size = psi * larger_or_nan(0.0, varying / d.get(0));
        let [alpha_slope, beta_slope] = slopes.theta;
        let [alpha, beta] = &mut to.theta;
        alpha.put(0, alpha_slope);
        beta.put(0, beta_slope);
    }
}

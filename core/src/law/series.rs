//! Power series of the motion in time around any of its points, with at most sixteen terms.
//!
//! Every quantity of the law is a product, a quotient or a root of earlier ones, so its coefficients follow one after
//! the other from convolutions. Each quantity is written as its value at the point times 1 plus a variation, and only
//! the variations are series: D = D₀ (1 + δ), χ' = χ'₀ (1 + ξ), e₃ - u = (e₃ - u₀) (1 + η). Then no division is left,
//! and the coefficients are integers. The series of χ itself is not needed: sin χ, cos χ and e^{i(θ ± χ)} satisfy
//! linear equations.

use crate::law::PhaseRates;
use crate::law::block::{BITS, Block, Factor, in_range, integrated, power_of_two, scaled, sum_in_range};
use crate::law::rate::{Rate, negligible};
use crate::law::recurrence::Recurrence;
use crate::law::turning::{FRACTION, sine_cosine};
use crate::phase::Phase;
use crate::scalar::{Float, Scalar};

pub(crate) use crate::law::block::{Split, TERMS, over_power, scaled_product};

/// Unit of the coefficients of α and β, 2^-62.
pub(crate) const UNIT: f64 = power_of_two(-UNIT_BITS);

/// Number in units of [`UNIT`], as which errors of coefficients are estimated in `f32`: their squares neither overflow nor
/// vanish. It is finite for every x but NaN.
pub(crate) fn in_units(x: f64) -> f32 {
    ((x * power_of_two(UNIT_BITS)) as f32).clamp(f32::MIN, f32::MAX)
}

const UNIT_BITS: i32 = 62;

/// Coefficient of x^k in units of 2^-62, from that of yᵏ = (x/4)^k in units of 2^-56.
fn of_x(coefficient: i64, k: usize) -> i64 {
    match 2 * k as i32 - (UNIT_BITS - BITS) {
        shift @ 2.. => (over_power(coefficient, shift - 1) + 1) >> 1,
        1 => (coefficient + 1) >> 1,
        shift => coefficient << -shift,
    }
}

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
    /// sin χ and cos χ at the point.
    pub(crate) sine_cosine: (f64, f64),
    pub(crate) psi: PhaseRates<f64>,
    /// Derivatives ψ' minus their mean. They are stored separately, because the difference may be small.
    pub(crate) theta: [f64; 2],
    /// Weight of an error of χ relative to one of θ. It is large where χ changes slowly, because the error is a delay
    /// of all that follows.
    pub(crate) weight: f64,
}

/// Expansion of the motion around a point, as functions of x = (t - t₀)/unit. The series are in y = x/4: steps go up to
/// x = 3, and the rounding errors of the coefficients must not grow on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Expansion {
    pub(super) chi: Rate,
    pub(super) theta: [Rate; 2],
    pub(super) origin: PhasePoint,
    /// Weight of an error of χ relative to one of θ.
    pub(super) weight: f64,
    /// Magnitude of the terms whose difference is the variation of dψ/dx. Their rounding errors are errors of θ.
    pub(super) variation_size: f64,
    /// Number of terms computed, at most [`TERMS`]; 0 where the series do not converge.
    pub(super) terms: usize,
    /// Recurrence that computes the coefficients.
    pub(super) recurrence: Recurrence,
    /// Scratch series for intermediate results, stored here once so that the stack stays small.
    pub(super) scratch: [Block; 5],
}

/// Larger of two numbers, or NaN if one of them is NaN.
pub(crate) fn larger_or_nan<F: Float>(a: F, b: F) -> F {
    if b <= a || a.partial_cmp(&a).is_none() { a } else { b }
}

impl Slopes {
    /// Slopes before they are computed.
    pub(crate) const ZERO: Self = Self {
        sine_cosine: (0.0, 1.0),
        psi: PhaseRates { nutation: 0.0, alpha: 0.0, beta: 0.0 },
        theta: [0.0; 2],
        weight: 1.0,
    };
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
        chi: Rate::ZERO,
        theta: [Rate::ZERO; 2],
        origin: PhasePoint { chi: Phase::ZERO, theta: [Phase::ZERO; 2] },
        weight: 1.0,
        variation_size: 0.0,
        terms: 0,
        recurrence: Recurrence::ENDED,
        scratch: [Block::ZERO; 5],
    };

    /// Phases at a whole x.
    pub(crate) fn point(&self, x: i64) -> PhasePoint {
        let moved = |origin: Phase, rate: &Rate| origin + Phase::from_radians(rate.integral(x, self.terms));
        let ([alpha, beta], [alpha_rate, beta_rate]) = (self.origin.theta, &self.theta);
        PhasePoint {
            chi: moved(self.origin.chi, &self.chi),
            theta: [moved(alpha, alpha_rate), moved(beta, beta_rate)],
        }
    }

    /// Half phase χ at x, and dχ/dx.
    pub(crate) fn chi_and_slope(&self, x: f64) -> (Phase, f64) {
        let (slope, change) = self.chi.between(0.25 * x, self.terms);
        (self.origin.chi + Phase::from_radians(change), 0.25 * slope)
    }

    /// Magnitudes of the terms that add up to the changes of χ and of θ at a whole x > 0, to which rounding errors are relative: of χ
    /// as a change of x, and of θ in rad.
    pub(crate) fn sizes(&self, x: i64) -> [f32; 2] {
        let [alpha, beta] = &self.theta;
        let size = |rate: &Rate| rate.size(x, self.terms);
        // the slope may be below the range of f32, but not the quotient; it is by y = x/4
        let delay = 4.0 * self.chi.relative_size(x, self.terms) / self.chi.relative(x, self.terms);
        [delay, larger_or_nan(size(alpha), size(beta)) + 0.25 * x as f32 * self.variation_size as f32]
    }

    /// Upper bound on |dθ/dx| of α and of β for x in [-1, 1], without the truncation error of the series.
    pub(crate) fn greatest_theta_slope(&self) -> f32 {
        let [alpha, beta] = &self.theta;
        0.25 * larger_or_nan(alpha.greatest(self.terms), beta.greatest(self.terms))
    }

    /// Phases θ of α and of β at x.
    pub(crate) fn theta_at(&self, x: f64) -> [Phase; 2] {
        let ([alpha, beta], [alpha_rate, beta_rate]) = (self.origin.theta, &self.theta);
        let change = |rate: &Rate| Phase::from_radians(rate.between(0.25 * x, self.terms).1);
        [alpha + change(alpha_rate), beta + change(beta_rate)]
    }

    /// Bracket p e^{iχ} + q e^{-iχ} times e^{iθ}, of α (`which` = 0) or of β (1), as the series of its real and
    /// imaginary part in units of 2^-62; the series end where their terms fall below `least`. The result is `None`
    /// where they do not converge.
    #[inline(never)] // set-up's frames should not add up on a small stack
    pub(crate) fn turned(
        &mut self,
        which: usize,
        [p, q]: [f64; 2],
        least: f64,
        [sum_re, sum_im]: [&mut [i64; TERMS]; 2],
    ) -> Option<()> {
        let slow = self.theta.get(which)?;
        let theta = self.origin.theta.get(which).copied().unwrap_or_default();
        let [rate, re, im, ..] = &mut self.scratch;
        (*sum_re, *sum_im) = ([0; TERMS], [0; TERMS]);
        for (forwards, scale) in [(true, p), (false, q)] {
            let (sense, chi) = if forwards { (1.0, self.origin.chi) } else { (-1.0, -self.origin.chi) };
            let slopes = slow.slope + sense * self.chi.slope;
            let slow_size = slow.scale * slow.variation.unit();
            let chi_size = Float::abs(self.chi.slope) * self.chi.variation.unit();
            let size = power_of_two(BITS) * (slow_size + chi_size);
            rate.clear(larger_or_nan(Float::abs(slopes), size));
            let from_chi = Factor::new(sense * self.chi.slope, self.chi.variation.exponent, rate.exponent);
            let from_slow = Factor::new(slow.scale, slow.variation.exponent, rate.exponent);
            let mut converges = rate.put(0, scaled(slopes, rate.exponent));
            for k in 1..self.terms {
                let [chi, slow] = [&self.chi, slow].map(|rate| rate.variation.get(k));
                converges &= rate.put(k, sum_in_range([from_chi.times(chi), from_slow.times(slow)])?);
            }
            let (sine, cosine) = sine_cosine(theta + chi);
            let scale = Split::of(scaled(scale, -FRACTION));
            let part = |part: i64| scaled_product::<{ (2 * FRACTION - BITS) as u32 }>(Split::of(part), scale);
            let start = [part(cosine), part(sine)];
            let terms = exponential(rate, start, least, [re, im])?;
            for (k, (sum_re, sum_im)) in sum_re.iter_mut().zip(sum_im.iter_mut()).enumerate().take(terms) {
                *sum_re += of_x(re.get(k), k);
                *sum_im += of_x(im.get(k), k);
            }
            converges.then_some(())?;
        }
        Some(())
    }

    /// Estimate of the truncation error of the phases at a whole x > 0, rad. It is made from the larger of the last
    /// two terms of their rates, and assumes that each further term is at most a quarter of the one before. Where
    /// sixteen terms leave a small error, the terms decrease by a factor of ten.
    pub(crate) fn truncation_error(&self, x: i64) -> f64 {
        if self.terms == 0 {
            return f64::INFINITY;
        }
        let y = 0.25 * x as f32;
        let before = self.terms.saturating_sub(2);
        let power = (0..before).fold(1.0, |power, _| power * y);
        let last = larger_or_nan(self.term(before) * power, self.term(before + 1) * power * y);
        (last * y / (3 * self.terms) as f32).into()
    }

    /// Largest k-th coefficient of the rates of the phases, with the weight of χ.
    fn term(&self, k: usize) -> f32 {
        let [alpha, beta] = &self.theta;
        larger_or_nan(self.chi.term(k, self.weight), larger_or_nan(alpha.term(k, 1.0), beta.term(k, 1.0)))
    }
}

/// Series of start · e^{i ∫ rate}, the solution of z' = i z rate, in units of 2^-56 like the start. Returns the number of its terms,
/// or `None` where it does not converge.
#[inline(never)]
fn exponential(
    rate: &Block,
    [start_re, start_im]: [i64; 2],
    least: f64,
    [re, im]: [&mut Block; 2],
) -> Option<usize> {
    re.clear_to(-BITS);
    im.clear_to(-BITS);
    let least = negligible(least, UNIT);
    let mut converges = re.put(0, start_re) & im.put(0, start_im);
    let mut before = i64::MAX;
    for k in 0..TERMS - 1 {
        let next = |part: &Block| {
            in_range(rate.product(part, 0..=k, k, -rate.exponent)).map(|next| integrated(next, k))
        };
        let (next_re, next_im) = (-next(im)?, next(re)?);
        converges &= re.put(k + 1, next_re) & im.put(k + 1, next_im);
        if !converges {
            return None;
        }
        let size = of_x(next_re.abs().max(next_im.abs()), k + 1);
        if size.max(before) <= least {
            return Some(k + 2);
        }
        before = size;
    }
    Some(TERMS)
}

//! Power series of the motion in time around any of its points, with at most sixteen terms.
//!
//! Each quantity of the phase equations is its value at the point times 1 plus a variation: D = D₀ (1 + δ), χ' = χ'₀ (1 + ξ),
//! e₃ - u = (e₃ - u₀) (1 + η). The coefficients of the variations follow one after the other from convolutions without divisions.
//! sin χ, cos χ and e^{i(θ ± χ)} satisfy linear equations.

use crate::motion::phase_equations::PhaseRates;
use crate::phase::Phase;
use crate::scalar::{Float, Scalar, power_of_two, times_power_of_two};
use crate::table::series::block::{Block, Factor, integrated};
use crate::table::series::integers::{BITS, Split, in_range, scaled, scaled_product};
use crate::table::series::rate::Rate;
use crate::table::series::sincos::{FRACTION, sine_cosine};

pub(crate) use crate::table::series::integers::TERMS;

/// Unit of the coefficients of α and β, 2^-62.
pub(crate) const UNIT: f64 = power_of_two(-UNIT_BITS);

/// Number in units of [`UNIT`], finite for every x but NaN.
pub(crate) fn in_units(x: f64) -> f32 {
    ((x * power_of_two(UNIT_BITS)) as f32).clamp(f32::MIN, f32::MAX)
}

const UNIT_BITS: i32 = 62;

/// Coefficient of x^k in units of 2^-62, from that of yᵏ = (x/4)^k in units of 2^-56.
fn of_x(coefficient: i64, k: usize) -> i64 {
    match 2 * k as i32 - (UNIT_BITS - BITS) {
        shift @ 1.. => ((coefficient >> (shift - 1)) + 1) >> 1,
        shift => coefficient << -shift,
    }
}

/// Phases of a point of the motion, to which steps add without rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PhasePoint {
    pub(crate) chi: Phase,
    /// Phases θ of α and of β: the slow phases minus their mean rotation.
    pub(crate) theta: [Phase; 2],
}

/// Derivatives of the five phases χ, ψ_A, ψ_B, θ_A and θ_B with respect to x, at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes {
    /// sin χ and cos χ at the point.
    pub(crate) sine_cosine: (f64, f64),
    pub(crate) psi: PhaseRates<f64>,
    /// Derivatives ψ' minus their mean.
    pub(crate) theta: [f64; 2],
    /// Weight of an error of χ relative to one of θ, large where χ changes slowly.
    pub(crate) weight: f64,
}

/// Expansion of the motion around a point, as functions of x = (t - t₀)/unit up to x = 3. The series are in y = x/4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Expansion {
    pub(super) chi: Rate,
    pub(super) theta: [Rate; 2],
    pub(super) origin: PhasePoint,
    /// Weight of an error of χ relative to one of θ.
    pub(super) weight: f64,
    /// Magnitude of the terms whose difference is the variation of dψ/dx.
    pub(super) variation_size: f32,
    /// Number of terms computed, at most [`TERMS`]; 0 where the series do not converge.
    pub(super) terms: usize,
    /// Largest coefficients of the rates in the last two terms: see [`Expansion::term`].
    pub(super) last_terms: [f32; 2],
    /// Scratch series.
    pub(super) scratch: [Block; 5],
}

/// Larger of two numbers, or NaN if one of them is NaN.
pub(crate) fn larger_or_nan<F: Float>(a: F, b: F) -> F {
    if b <= a || a.partial_cmp(&a).is_none() { a } else { b }
}

impl PhasePoint {
    /// sin χ and cos χ. Error: below 2^-53, relative to the result near its zeros.
    pub(crate) fn sine_cosine(&self) -> (f64, f64) {
        /// Least result of the integer arithmetic, which costs a chip a fifth of that in `f64`.
        const LEAST: i64 = 1 << (FRACTION - 3);
        let (sine, cosine) = sine_cosine(self.chi);
        if self.chi == Phase::ZERO {
            (0.0, 1.0)
        } else if sine.abs().min(cosine.abs()) < LEAST {
            f64::sine_cosine(self.chi)
        } else {
            let number = |part: i64| part as f64 * power_of_two(-FRACTION);
            (number(sine), number(cosine))
        }
    }
}

impl Expansion {
    /// Expansion before its first use.
    pub(crate) const EMPTY: Self = Self {
        chi: Rate::ZERO,
        theta: [Rate::ZERO; 2],
        origin: PhasePoint { chi: Phase::ZERO, theta: [Phase::ZERO; 2] },
        weight: 0.0,
        variation_size: 0.0,
        terms: 0,
        last_terms: [0.0; 2],
        scratch: [Block::ZERO; 5],
    };

    /// Phases after these changes, rad.
    fn moved(&self, chi: f64, [alpha_change, beta_change]: [f64; 2]) -> PhasePoint {
        let PhasePoint { chi: origin, theta: [alpha, beta] } = self.origin;
        let moved = |origin: Phase, change: f64| origin + Phase::from_radians(change);
        PhasePoint { chi: moved(origin, chi), theta: [moved(alpha, alpha_change), moved(beta, beta_change)] }
    }

    /// Phases at a whole x.
    pub(crate) fn point(&self, x: u32) -> PhasePoint {
        let change = |rate: &Rate| rate.integral(x, self.terms);
        self.moved(change(&self.chi), self.theta.each_ref().map(change))
    }

    /// Phases at any x, and dχ/dx.
    pub(crate) fn point_and_slope(&self, x: f64) -> (PhasePoint, f64) {
        let at = |rate: &Rate| rate.at(0.25 * x, self.terms);
        let (slope, chi) = at(&self.chi);
        (self.moved(chi, self.theta.each_ref().map(|rate| at(rate).1)), 0.25 * slope)
    }

    /// Upper bounds on the magnitudes of the terms of the changes at a whole x > 0: of χ as a change of x, and of θ in rad.
    pub(crate) fn sizes(&self, x: u32) -> [f32; 2] {
        let y = 0.25 * x as f32;
        let [size, rate] = [Rate::varied_size, Rate::variation].map(|of| 1.0 + of(&self.chi, x, self.terms));
        let delay = 4.0 * y * size / rate;
        let [alpha, beta] = self.theta.each_ref().map(|rate| rate.size(x, self.terms));
        [delay, larger_or_nan(alpha, beta) + y * self.variation_size]
    }

    /// Upper bound on |dθ/dx| of α and of β for x in [-1, 1], without the truncation error of the series.
    pub(crate) fn greatest_theta_slope(&self) -> f32 {
        let [alpha, beta] = self.theta.each_ref().map(|rate| rate.greatest(self.terms));
        0.25 * larger_or_nan(alpha, beta)
    }

    /// Ellipse p e^{iχ} + q e^{-iχ} times e^{iθ}, of α (`which` = 0) or of β (1), as the series of its real and imaginary part in units
    /// of 2^-62, in arrays of zeros. Returns the number of terms that are not below `least`, or `None` where they do not converge.
    #[inline(never)] // set-up's frames should not add up on a small stack
    pub(crate) fn turned(
        &mut self,
        which: usize,
        [p, q]: [f64; 2],
        least: i64,
        [sum_re, sum_im]: [&mut [i64; TERMS]; 2],
    ) -> Option<usize> {
        let Self { chi: fast, theta, origin, scratch: [forwards, backwards, re, im, _], terms, .. } = self;
        let slow = theta.get(which)?;
        let theta = origin.theta.get(which).copied().unwrap_or_default();
        // θ' + χ' and θ' - χ' in a common unit
        let size = |rate: &Rate| times_power_of_two(Float::abs(rate.scale), rate.variation.exponent + BITS);
        let slopes = Float::abs(slow.slope) + Float::abs(fast.slope);
        forwards.scale_for(larger_or_nan(slopes, size(slow) + size(fast)));
        let exponent = forwards.exponent;
        backwards.exponent = exponent;
        let mut is_in_range = true;
        let mut put = |k: usize, slow: i64, fast: i64| {
            is_in_range &= forwards.put(k, slow + fast) & backwards.put(k, slow - fast);
        };
        let [slow_slope, fast_slope] = [slow, fast].map(|rate| scaled(rate.slope, exponent));
        put(0, slow_slope, fast_slope);
        let factors = [slow, fast].map(|rate| Factor::new(rate.scale, rate.variation.exponent, exponent));
        for k in 1..*terms {
            let [slow_factor, fast_factor] = &factors;
            put(k, slow_factor.times(slow.variation.get(k)), fast_factor.times(fast.variation.get(k)));
        }
        is_in_range.then_some(())?;
        let mut most = 0;
        for (rate, chi, scale) in [(&*forwards, origin.chi, p), (&*backwards, -origin.chi, q)] {
            let (sine, cosine) = sine_cosine(theta + chi);
            let scale = Split::of(scaled(scale, -FRACTION));
            let part = |part: i64| scaled_product::<{ (2 * FRACTION - BITS) as u32 }>(Split::of(part), scale);
            let start = [part(cosine), part(sine)];
            let computed = exponential(rate, *terms, start, least, [&mut *re, &mut *im])?;
            for (k, (sum_re, sum_im)) in sum_re.iter_mut().zip(sum_im.iter_mut()).enumerate().take(computed) {
                (*sum_re, *sum_im) = (*sum_re + re.get(k), *sum_im + im.get(k));
            }
            most = most.max(computed);
        }
        for (k, (sum_re, sum_im)) in sum_re.iter_mut().zip(sum_im.iter_mut()).enumerate().take(most) {
            (*sum_re, *sum_im) = (of_x(*sum_re, k), of_x(*sum_im, k));
        }
        Some(most)
    }

    /// Estimate of the truncation error of the phases at a whole x > 0, rad: the larger of the last two terms of their rates, each further
    /// term being at most a quarter of the one before.
    pub(crate) fn truncation_error(&self, x: u32) -> f64 {
        if self.terms == 0 {
            return f64::INFINITY;
        }
        let y = 0.25 * x as f32;
        let power = (2..self.terms).fold(1.0, |power, _| power * y);
        let [before, last] = self.last_terms;
        let last = larger_or_nan(before * power, last * power * y);
        (last * y / (3 * self.terms) as f32).into()
    }

    /// Largest k-th coefficient of the rates of the phases, with the weight of χ.
    pub(super) fn term(&self, k: usize) -> f32 {
        let [alpha, beta] = &self.theta;
        larger_or_nan(
            self.chi.term(k, self.weight as f32),
            larger_or_nan(alpha.term(k, 1.0), beta.term(k, 1.0)),
        )
    }
}

/// Series of start · e^{i ∫ rate}, the solution of z' = i z rate, in units of 2^-56 like the start. It ends where two terms in succession
/// are at most `least` units of 2^-62 at x = 1. Returns the number of its terms, or `None` where it does not converge.
#[inline(never)]
fn exponential(
    rate: &Block,
    terms: usize,
    [start_re, start_im]: [i64; 2],
    least: i64,
    [re, im]: [&mut Block; 2],
) -> Option<usize> {
    re.exponent = -BITS;
    im.exponent = -BITS;
    let mut converges = re.put(0, start_re) & im.put(0, start_im);
    // the limit of a coefficient of yᵏ, in units of 2^-62: four times that of the one before
    let (mut limit, mut before) = (least, false);
    for k in 0..TERMS - 1 {
        let next = |part: &Block| {
            in_range(rate.product(part, 0..terms.min(k + 1), k, -rate.exponent))
                .map(|next| integrated(next, k))
        };
        let (next_re, next_im) = (-next(im)?, next(re)?);
        converges &= re.put(k + 1, next_re) & im.put(k + 1, next_im);
        if !converges {
            return None;
        }
        if limit < i64::MAX >> 3 {
            limit <<= 2;
        }
        let negligible = next_re.abs().max(next_im.abs()) <= limit >> (UNIT_BITS - BITS);
        if negligible && before {
            return Some(k + 2);
        }
        before = negligible;
    }
    Some(TERMS)
}

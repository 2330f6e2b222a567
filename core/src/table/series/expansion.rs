//! Power series of the motion in time around any of its points, with at most sixteen terms.
//!
//! Each quantity of the phase equations is its value at the point times 1 plus a variation: D = D₀ (1 + δ), χ' = χ'₀ (1 + ξ),
//! e₃ - u = (e₃ - u₀) (1 + η). The coefficients of the variations follow one after the other from convolutions without divisions.
//! sin χ, cos χ and e^{i(θ ± χ)} satisfy linear equations.

use crate::phase::Phase;
use crate::scalar::{Float, Scalar, power_of_two};
use crate::table::series::integers::{
    BITS, Factor, Split, TERMS, in_range, integrated, scaled, scaled_product,
};
use crate::table::series::rate::{Block, Rate};
use crate::table::series::sincos::{FRACTION, sine_cosine};

/// Unit of the coefficients of α and β, 2^-62.
pub(crate) const TABLE_UNIT: f64 = power_of_two(-TABLE_BITS);

const TABLE_BITS: i32 = 62;

/// Coefficient of x^k in units of 2^-62, from that of yᵏ = (x/4)^k in units of 2^-56.
fn of_x(coefficient: i64, k: usize) -> i64 {
    match 2 * k as i32 - (TABLE_BITS - BITS) {
        shift @ 1.. => ((coefficient >> (shift - 1)) + 1) >> 1,
        shift => coefficient << -shift,
    }
}

/// Larger of two numbers, or NaN if one of them is NaN.
pub(crate) fn larger_or_nan<F: Float>(a: F, b: F) -> F {
    if b <= a || a.partial_cmp(&a).is_none() { a } else { b }
}

/// Phases of a point of the motion, to which steps add without rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PhasePoint {
    pub(crate) chi: Phase,
    /// Phases θ of α and of β: the slow phases minus their mean rotation.
    pub(crate) theta: [Phase; 2],
}

impl PhasePoint {
    pub(crate) const ZERO: Self = Self { chi: Phase::ZERO, theta: [Phase::ZERO; 2] };

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

/// Derivatives of the phases with respect to x at a point. The pairs are those of α and β.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slopes {
    /// sin χ and cos χ at the point.
    pub(crate) sine_cosine: (f64, f64),
    pub(crate) chi: f64,
    pub(crate) psi: [f64; 2],
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
    pub(super) weight: f32,
    /// Magnitude of the terms whose difference is the variation of dψ/dx.
    pub(super) variation_size: f32,
    /// Number of terms computed, at most [`TERMS`]; 0 where the series do not converge.
    pub(super) terms: usize,
    /// Scratch series.
    pub(super) scratch: [Block; 5],
}

impl Expansion {
    /// Expansion before its first use.
    pub(crate) const EMPTY: Self = Self {
        chi: Rate::ZERO,
        theta: [Rate::ZERO; 2],
        origin: PhasePoint::ZERO,
        weight: 0.0,
        variation_size: 0.0,
        terms: 0,
        scratch: [Block::ZERO; 5],
    };

    /// Phases at x, and dχ/dx.
    pub(crate) fn at(&self, x: f64) -> (PhasePoint, f64) {
        let y = 0.25 * x;
        let after = |origin: Phase, rate: &Rate| origin + Phase::from_radians(rate.integral(y, self.terms));
        let PhasePoint { chi, mut theta } = self.origin;
        theta.iter_mut().zip(&self.theta).for_each(|(theta, rate)| *theta = after(*theta, rate));
        (PhasePoint { chi: after(chi, &self.chi), theta }, 0.25 * self.chi.value(y, self.terms))
    }

    /// Upper bounds on the magnitudes of the terms of the changes of χ and of θ at a whole x > 0, rad.
    pub(crate) fn sizes(&self, x: u32) -> [f32; 2] {
        let [alpha, beta] = self.theta.each_ref().map(|rate| rate.size(x, self.terms));
        let theta = larger_or_nan(alpha, beta) + 0.25 * x as f32 * self.variation_size;
        [self.chi.size(x, self.terms), theta]
    }

    /// Upper bound on |dθ/dx| of α and of β for x in [-1, 1], without the truncation error of the series.
    pub(crate) fn greatest_theta_slope(&self) -> f32 {
        let [alpha, beta] = self.theta.each_ref().map(|rate| rate.greatest(self.terms));
        0.25 * larger_or_nan(alpha, beta)
    }

    /// Estimate of the truncation error of the phases at a whole x > 0, rad: the larger of the last two terms of their rates, each further
    /// term being at most a quarter of the one before.
    pub(crate) fn truncation_error(&self, x: u32) -> f64 {
        let Some(before) = self.terms.checked_sub(2) else { return f64::INFINITY };
        let y = 0.25 * x as f32;
        let power = (0..before).fold(1.0, |power, _| power * y);
        let term = |k: usize| {
            let [alpha, beta] = self.theta.each_ref().map(|rate| rate.term(k, 1.0));
            larger_or_nan(self.chi.term(k, self.weight), larger_or_nan(alpha, beta))
        };
        let last = larger_or_nan(term(before) * power, term(before + 1) * power * y);
        (last * y / (3 * self.terms) as f32).into()
    }

    /// Ellipse p e^{iχ} + q e^{-iχ} times e^{iθ}, of α (`which` = 0) or of β (1), as coefficients of their real and imaginary part that were 0. Returns the number of terms
    /// that are not below `least`, or `None` where they do not converge.
    #[inline(never)] // set-up's frames should not add up on a small stack
    pub(crate) fn turned(
        &mut self,
        which: usize,
        [p, q]: [f64; 2],
        least: i64,
        mut sums: [&mut [i64; TERMS]; 2],
    ) -> Option<usize> {
        let Self { chi: fast, theta, origin, scratch: [forwards, backwards, re, im, _], terms, .. } = self;
        let (slow, theta) = (theta.get(which)?, *origin.theta.get(which)?);
        // θ' + χ' and θ' - χ' in a common unit
        let size = |rate: &Rate| rate.variation.magnitude_times(Float::abs(rate.scale));
        let slopes = Float::abs(slow.slope) + Float::abs(fast.slope);
        forwards.scale_for(larger_or_nan(slopes, size(slow) + size(fast)));
        let exponent = forwards.exponent;
        backwards.exponent = exponent;
        let rates =
            [slow, fast].map(|rate| (rate, Factor::new(rate.scale, rate.variation.exponent, exponent)));
        for k in 0..*terms {
            let [slow, fast] = rates.each_ref().map(|(rate, factor)| match k {
                0 => scaled(rate.slope, exponent),
                _ => factor.times(rate.variation.get(k)),
            });
            forwards.put(k, slow + fast)?;
            backwards.put(k, slow - fast)?;
        }
        let mut most = 0;
        for (rate, chi, scale) in [(&*forwards, origin.chi, p), (&*backwards, -origin.chi, q)] {
            let (sine, cosine) = sine_cosine(theta + chi);
            let scale = Split::of(scaled(scale, -FRACTION));
            let start = [cosine, sine]
                .map(|part| scaled_product::<{ (2 * FRACTION - BITS) as u32 }>(Split::of(part), scale));
            let computed = exponential(rate, *terms, start, least, [&mut *re, &mut *im])?;
            for (sum, part) in sums.iter_mut().zip([&*re, &*im]) {
                for (k, sum) in sum.iter_mut().enumerate().take(computed) {
                    *sum += part.get(k);
                }
            }
            most = most.max(computed);
        }
        for sum in sums {
            sum.iter_mut().enumerate().take(most).for_each(|(k, sum)| *sum = of_x(*sum, k));
        }
        Some(most)
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
    (re.exponent, im.exponent) = (-BITS, -BITS);
    re.put(0, start_re)?;
    im.put(0, start_im)?;
    // the limit of a coefficient of yᵏ, in units of 2^-62: four times that of the one before
    let (mut limit, mut before) = (least, false);
    for k in 0..TERMS - 1 {
        let next = |part: &Block| {
            in_range(rate.product(part, 0..terms.min(k + 1), k, -rate.exponent))
                .map(|next| integrated(next, k))
        };
        let (next_re, next_im) = (-next(im)?, next(re)?);
        re.put(k + 1, next_re)?;
        im.put(k + 1, next_im)?;
        if limit < i64::MAX >> 3 {
            limit <<= 2;
        }
        let negligible = next_re.abs().max(next_im.abs()) <= limit >> (TABLE_BITS - BITS);
        if negligible && before {
            return Some(k + 2);
        }
        before = negligible;
    }
    Some(TERMS)
}

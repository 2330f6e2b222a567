//! Power series of the motion in time around any of its points.
//!
//! Each quantity of the phase equations is its value at the point times 1 plus a variation: D = D₀ (1 + δ), χ' = χ'₀ (1 + ξ),
//! e₃ - u = (e₃ - u₀) (1 + η). The coefficients follow one after the other from convolutions. sin χ, cos χ and e^{i(θ ± χ)} satisfy linear
//! equations.

mod recurrence;

mod turned;

use super::sincos::{FRACTION, sine_cosine};
use super::{Block, integrated};
use crate::phase::Phase;
use crate::scalar::{Float, Scalar, power_of_two, short_power_of_two};

/// Larger of two numbers, or NaN if one of them is NaN.
pub(crate) fn larger_or_nan<F: Float>(a: F, b: F) -> F {
    if b <= a || a.partial_cmp(&a).is_none() { a } else { b }
}

/// Largest rounding error of a coefficient, in units of its series.
const NOISE: i64 = 4;

/// Rate of a phase along y = x/4: slope + variation. The variation of χ is relative to its slope.
#[derive(Debug)]
struct Rate {
    slope: f64,
    /// Factor of the variation: 1, or the slope.
    scale: f64,
    variation: Block,
    /// Relative variation of the denominator of a slow phase's rate.
    divisor: Block,
}

impl Rate {
    const ZERO: Self = Self { slope: 0.0, scale: 0.0, variation: Block::ZERO, divisor: Block::ZERO };

    /// Rate at y in [-1, 1].
    fn value(&self, y: f64, terms: usize) -> f64 {
        self.slope + y * (self.variation.sum(y, terms, |c, _| c) * self.scale)
    }

    /// Integral from 0 to y.
    fn integral(&self, y: f64, terms: usize) -> f64 {
        y * (self.slope + y * (self.variation.sum(y, terms, integrated) * self.scale))
    }

    /// Upper bound on the rate, from that on the variation.
    fn bound(&self, varied: f32) -> f32 {
        Float::abs(self.slope) as f32 + varied * Float::abs(self.scale) as f32
    }

    /// Magnitude of the k-th coefficient; 0 where it is a rounding error.
    fn term(&self, k: usize, weight: f32) -> f32 {
        let size = self.variation.get(k).abs();
        match k {
            0 => Float::abs(weight * self.slope as f32),
            _ if size <= NOISE => 0.0,
            _ => {
                size as f32
                    * short_power_of_two(self.variation.exponent)
                    * Float::abs(weight * self.scale as f32)
            }
        }
    }
}

/// Phases of a point of the motion, to which steps add without rounding.
#[derive(Clone, Copy, Debug)]
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
        if sine.abs().min(cosine.abs()) < LEAST {
            f64::sine_cosine(self.chi)
        } else {
            let number = |part: i64| part as f64 * power_of_two(-FRACTION);
            (number(sine), number(cosine))
        }
    }
}

/// Derivatives of the phases by y = x/4 at a point. The pairs are those of α and β.
pub(crate) struct Slopes {
    pub(crate) point: PhasePoint,
    /// sin χ and cos χ.
    pub(crate) sine: f64,
    pub(crate) cosine: f64,
    /// Time of y = 1.
    pub(crate) unit: f64,
    pub(crate) chi: f64,
    pub(crate) psi: [f64; 2],
    /// Derivatives ψ' minus their mean.
    pub(crate) theta: [f64; 2],
    /// Weight of an error of χ over one of θ, large where χ changes slowly.
    pub(crate) weight: f64,
    /// Magnitude below which a term at x = 2 is negligible.
    pub(crate) least: f64,
}

/// Expansion of the motion around a point, in y = x/4. One unit of x is half a span, and x is at most 3.
#[derive(Debug)]
pub(crate) struct Expansion {
    chi: Rate,
    theta: [Rate; 2],
    origin: PhasePoint,
    weight: f32,
    /// Magnitude of the terms whose difference is the variation of dψ/dx.
    variation_size: f32,
    /// Number of terms, at most sixteen; 0 where the series do not converge.
    terms: usize,
    scratch: [Block; 5],
}

impl Expansion {
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
        // a rounding error of the coefficients counts as the term of which it would be the rounding in f64
        let noise = (NOISE as f64 / f64::ROUNDING) as f32;
        let y = 0.25 * x as f32;
        let size = |rate: &Rate| y * rate.bound(rate.variation.size(x, self.terms, noise));
        let [alpha, beta] = self.theta.each_ref().map(size);
        [size(&self.chi), larger_or_nan(alpha, beta) + y * self.variation_size]
    }

    /// Whether the coefficients of an expansion over twice the distance should be in range.
    pub(crate) fn may_double(&self) -> bool {
        /// Greatest relative change of dχ/dy at y = 1 by its first power.
        const GREATEST_CHANGE: f32 = 1.25;
        self.chi.term(1, 1.0) <= GREATEST_CHANGE * self.chi.term(0, 1.0)
    }

    /// Upper bound on |dθ/dx| for x in [-1, 1], without the truncation error.
    pub(crate) fn greatest_theta_slope(&self) -> f32 {
        let greatest = |rate: &Rate| rate.bound(rate.variation.size(1, self.terms, 0.0));
        let [alpha, beta] = self.theta.each_ref().map(greatest);
        0.25 * larger_or_nan(alpha, beta)
    }

    /// Estimate of the truncation error of the phases at a whole x > 0, rad: a further term is at most a quarter of the one before.
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
}

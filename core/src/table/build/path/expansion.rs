//! Expansion of the motion around a point of its path, in y = x/4, where x goes from -1 to 1 along a span.
//!
//! In a series that converges within sixteen terms, a coefficient of x^k is at most about a quarter of the one before. As y = x/4, the coefficients
//! of y^k then do not grow, and one exponent fits all. Index 0: at the point. v and the Greek letters: power series in y.
//!
//! ```text
//! v = cos²χ - cos²χ₀
//! D        = D₀ (1 + δ)             δ = 2 c (u₀ v) - c e v²     with e = e₂ - e₁ and c = s e/D₀
//! e₃ - u   = (e₃ - u₀) (1 + η)      η = e/(e₃ - u₀) v
//! dχ/dy    = (dχ/dy)₀ (1 + ξ)       (1 + ξ)² (1 + δ) = 1 + η
//! D dχ/dy  = D₀ (dχ/dy)₀ (1 + μ)    1 + μ = (1 + ξ) (1 + δ)
//! ```
//!
//! The rate of a ψ is linear in v, over a combination of D and D dχ/dy:
//!
//! ```text
//! dψ/dy = (dψ/dy)₀ + σ              (1 + κ) ((dψ/dy)₀ + σ) = (dψ/dy)₀ + f v,    κ = g δ + h μ
//! ```
//!
//! Each coefficient follows from those before. The residual phase is ρ = λ - Λ, with the mean phase Λ.

mod recurrence;

mod cayley_klein;

use super::series::{MAX_TERMS, PowerSeries, integrated};
use crate::integer::power_of_two;
use crate::phase::Phase;
use crate::scalar::{Float, Ring};

/// Largest rounding error of a coefficient, in units of its series.
const NOISE: i64 = 4;

/// Rate of a phase along y: `at_origin` + `scale` · `variation`.
#[derive(Debug)]
struct RateSeries {
    at_origin: f64,
    /// 1, or for χ the rate at the origin.
    scale: f64,
    variation: PowerSeries,
}

impl RateSeries {
    const ZERO: Self = Self { at_origin: 0.0, scale: 0.0, variation: PowerSeries::ZERO };

    /// Rate at y in [-1, 1].
    fn value(&self, y: f64, terms: usize) -> f64 {
        self.at_origin + y * (self.variation.sum(y, terms, |c, _| c) * self.scale)
    }

    /// Integral from 0 to y.
    fn integral(&self, y: f64, terms: usize) -> f64 {
        y * (self.at_origin + y * (self.variation.sum(y, terms, integrated) * self.scale))
    }

    /// Expected magnitude of the coefficients of the variation.
    fn magnitude_of_variation(&self) -> f64 {
        self.variation.magnitude_times(self.scale.abs())
    }

    /// Magnitude of the k-th coefficient; 0 where it is a rounding error.
    fn term_size(&self, k: usize, factor: f32) -> f32 {
        let size = self.variation.coefficient(k).abs();
        match k {
            0 => (factor * self.at_origin as f32).abs(),
            _ if size <= NOISE => 0.0,
            _ => {
                size as f32
                    * power_of_two(self.variation.exponent) as f32
                    * (factor * self.scale as f32).abs()
            }
        }
    }
}

/// Phases at a point of the path. Steps add to them without rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathPhases {
    pub(super) chi: Phase,
    /// Residual phases ρ of α and β.
    pub(super) residual: [Phase; 2],
}

impl PathPhases {
    pub(super) const ZERO: Self = Self { chi: Phase::ZERO, residual: [Phase::ZERO; 2] };
}

/// Point around which the motion is expanded, with derivatives by y. A pair belongs to α and β.
pub(super) struct ExpansionPoint {
    pub(super) phases: PathPhases,
    pub(super) sine: f64,
    pub(super) cosine: f64,
    /// Time of one unit of y, s.
    pub(super) time_per_y: f64,
    pub(super) chi_rate: f64,
    pub(super) psi_rates: [f64; 2],
    pub(super) residual_rates: [f64; 2],
    /// Rotation of the body by an error of χ, over that by an equal error of ρ.
    pub(super) rotation_per_chi_error: f64,
    /// Magnitude below which a term at x = 1 is negligible, rad.
    pub(super) negligible: f64,
}

/// Expansion of the motion around a point.
#[derive(Debug)]
pub(super) struct Expansion {
    origin: PathPhases,
    chi: RateSeries,
    residual: [RateSeries; 2],
    /// Series κ of ψ_α and ψ_β.
    kappa: [PowerSeries; 2],
    sine: PowerSeries,
    cosine: PowerSeries,
    v: PowerSeries,
    delta: PowerSeries,
    mu: PowerSeries,
    rotation_per_chi_error: f32,
    /// Number of terms; 0 where the series do not converge.
    pub(super) terms: usize,
}

impl Expansion {
    pub(super) const ZERO: Self = Self {
        origin: PathPhases::ZERO,
        chi: RateSeries::ZERO,
        residual: [RateSeries::ZERO; 2],
        kappa: [PowerSeries::ZERO; 2],
        sine: PowerSeries::ZERO,
        cosine: PowerSeries::ZERO,
        v: PowerSeries::ZERO,
        delta: PowerSeries::ZERO,
        mu: PowerSeries::ZERO,
        rotation_per_chi_error: 0.0,
        terms: 0,
    };

    /// Phases at x, and dχ/dx.
    pub(super) fn at(&self, x: f64) -> (PathPhases, f64) {
        let y = 0.25 * x;
        let after =
            |origin: Phase, rate: &RateSeries| origin + Phase::from_radians(rate.integral(y, self.terms));
        let PathPhases { chi, mut residual } = self.origin;
        residual.iter_mut().zip(&self.residual).for_each(|(phase, rate)| *phase = after(*phase, rate));
        (PathPhases { chi: after(chi, &self.chi), residual }, 0.25 * self.chi.value(y, self.terms))
    }

    /// Rounding error of the phases at x = 1, rad.
    pub(super) fn rounding_error(&self) -> f64 {
        /// Roundings of the terms of a rate.
        const ROUNDINGS: f64 = 2.0;
        let size = |rate: &RateSeries| rate.at_origin.abs() + 0.25 * rate.magnitude_of_variation();
        let [alpha, beta] = self.residual.each_ref().map(size);
        let chi = f64::from(self.rotation_per_chi_error) * size(&self.chi);
        ROUNDINGS * f64::OPERATION_ERROR * 0.25 * chi.larger_or_nan(alpha.larger_or_nan(beta))
    }

    /// Upper bound on the rates of the residual phases by x in [-1, 1].
    pub(super) fn greatest_residual_rate(&self) -> f32 {
        let greatest =
            |rate: &RateSeries| rate.at_origin.abs() as f32 + rate.variation.bound_at_quarter(self.terms);
        let [alpha, beta] = self.residual.each_ref().map(greatest);
        0.25 * alpha.larger_or_nan(beta)
    }

    /// Estimated truncation error of the phases at x = 1, rad, if each term is a quarter of the one before; infinite where the series do not
    /// converge.
    pub(super) fn truncation_error(&self) -> f64 {
        let Some(before) = self.terms.checked_sub(2) else { return f64::INFINITY };
        let term = |k: usize| {
            let [alpha, beta] = self.residual.each_ref().map(|rate| rate.term_size(k, 1.0));
            self.chi.term_size(k, self.rotation_per_chi_error).larger_or_nan(alpha.larger_or_nan(beta))
        };
        let last =
            term(before).larger_or_nan(0.25 * term(before + 1)) * power_of_two(-2 * before as i32) as f32;
        (0.25 * last / (3 * self.terms) as f32).into()
    }
}

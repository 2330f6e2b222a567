//! Rate of a phase as a power series, and the size of its negligible terms.

use crate::law::block::{Block, Split, scaled, scaled_product};
use crate::scalar::{Float, Scalar};

/// Largest rounding error of a coefficient, in units of its series: the sum of some roundings of half a unit.
const NOISE: i64 = 4;

/// Whether the k-th coefficient is a rounding error, or its term at y = 1/2 is below `least` units.
pub(super) fn is_negligible(coefficient: i64, k: usize, least: i64) -> bool {
    let size = coefficient.abs();
    size <= NOISE || size >> k < least
}

/// Magnitude below which a term of a series is negligible, in its units.
pub(super) fn negligible(least: f64, unit: f64) -> i64 {
    libm::round(least / unit).clamp(0.0, (1_i64 << 62) as f64) as i64
}

/// Rate of a phase along y = x/4: slope · 1 + variation, and the integral of the variation. The variation of χ is
/// relative to its slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rate {
    pub(super) slope: f64,
    /// Value of the variation's unit: 1, or the slope for a relative variation.
    pub(super) scale: f64,
    /// Coefficients of y, y², ...
    pub(super) variation: Block,
    /// Coefficients of y², y³, ..., stored with the indices 1, 2, ....
    pub(super) integral: Block,
}

impl Rate {
    pub(super) const ZERO: Self =
        Self { slope: 0.0, scale: 0.0, variation: Block::ZERO, integral: Block::ZERO };

    /// Integral from 0 to y = `quarters`/4.
    pub(super) fn integral(&self, quarters: i64, terms: usize) -> f64 {
        let varied = self.integral.at_quarters(quarters, terms, |c| c).unwrap_or_default();
        let y = 0.25 * quarters as f64;
        y * (self.slope + y * (varied as f64 * self.integral.unit() * self.scale))
    }

    /// Value at y = `quarters`/4.
    pub(super) fn at(&self, quarters: i64, terms: usize) -> f64 {
        let varied = self.variation.at_quarters(quarters, terms, |c| c).unwrap_or_default();
        self.slope + 0.25 * quarters as f64 * (varied as f64 * self.variation.unit() * self.scale)
    }

    /// Sum of the magnitudes of the terms of the integral from 0 to y = `quarters`/4 > 0.
    pub(super) fn size(&self, quarters: i64, terms: usize) -> f64 {
        let varied = self.integral.at_quarters(quarters, terms, i64::abs).unwrap_or(i64::MAX);
        let y = 0.25 * quarters as f64;
        // a rounding error of the coefficients counts as the term of which it would be the rounding in f64
        let noise = NOISE as f64 / f64::ROUNDING;
        y * (Float::abs(self.slope)
            + y * ((varied as f64 + noise) * self.integral.unit() * Float::abs(self.scale)))
    }

    /// Value, and integral from 0, at a fractional y in [-1, 1].
    pub(super) fn between(&self, y: f64, terms: usize) -> (f64, f64) {
        let place = Split::of(scaled(y, -60));
        let sum = |series: &Block| {
            let sum = (1..terms).rev().fold(0, |sum, k| {
                // beyond the range only where the series does not converge
                scaled_product::<60>(Split::of(sum), place) + series.get(k)
            });
            sum as f64 * series.unit() * self.scale
        };
        let [value, integral] = [&self.variation, &self.integral].map(sum);
        (self.slope + y * value, y * (self.slope + y * integral))
    }

    /// Magnitude of the k-th coefficient; 0 where it is a rounding error.
    pub(super) fn term(&self, k: usize) -> f64 {
        match k {
            0 => Float::abs(self.slope),
            _ if self.variation.get(k).abs() <= NOISE => 0.0,
            _ => Float::abs(self.variation.number(k) * self.scale),
        }
    }
}

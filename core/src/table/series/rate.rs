//! Rate of a phase as a power series, and the size of its negligible terms.

use crate::scalar::{Float, Scalar, times_power_of_two};
use crate::table::series::block::Block;
use crate::table::series::integers::{Split, scaled, scaled_product};

/// Largest rounding error of a coefficient, in units of its series: the sum of some roundings of half a unit.
const NOISE: i64 = 4;

/// Whether the k-th coefficient is a rounding error, or its term at y = 1/2 is below `least` units.
pub(super) fn is_negligible(coefficient: i64, k: usize, least: i64) -> bool {
    let size = coefficient.abs();
    size <= NOISE || size >> k < least
}

/// Magnitude below which a term of a series with this exponent is negligible, in its units.
pub(super) fn negligible(least: f64, exponent: i32) -> i64 {
    scaled(least, exponent)
}

/// Rate of a phase along y = x/4: slope + variation. The variation of χ is relative to its slope.
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

    /// Variation at y = `quarters`/4.
    pub(super) fn variation(&self, quarters: u32, terms: usize) -> f32 {
        let varied = self.variation.at_quarters(quarters, terms);
        0.25 * quarters as f32 * (varied as f32 * self.variation.short_unit())
    }

    /// Sum of the magnitudes of the terms of the integral from 0 to y = `quarters`/4 > 0.
    pub(super) fn size(&self, quarters: u32, terms: usize) -> f32 {
        0.25 * quarters as f32 * self.bound(self.varied_size(quarters, terms))
    }

    /// Sum of the magnitudes of the terms of the mean variation from 0 to y = `quarters`/4.
    pub(super) fn varied_size(&self, quarters: u32, terms: usize) -> f32 {
        // a rounding error of the coefficients counts as the term of which it would be the rounding in f64
        let noise = (NOISE as f64 / f64::ROUNDING) as f32;
        let varied = self.integral.size_at_quarters(quarters, terms) + noise;
        0.25 * quarters as f32 * (varied * self.integral.short_unit())
    }

    /// Upper bound on the rate for y in [-1/4, 1/4].
    pub(super) fn greatest(&self, terms: usize) -> f32 {
        let varied = self.variation.size_at_quarters(1, terms);
        self.bound(0.25 * (varied * self.variation.short_unit()))
    }

    /// Integral from 0 to y = `quarters`/4.
    pub(super) fn integral(&self, quarters: u32, terms: usize) -> f64 {
        let y = 0.25 * f64::from(quarters);
        let varied =
            times_power_of_two(self.integral.at_quarters(quarters, terms) as f64, self.integral.exponent);
        y * (self.slope + y * (varied * self.scale))
    }

    fn bound(&self, varied: f32) -> f32 {
        Float::abs(self.slope) as f32 + varied * Float::abs(self.scale) as f32
    }

    /// Value, and integral from 0, at y in [-1, 1].
    pub(super) fn at(&self, y: f64, terms: usize) -> (f64, f64) {
        let place = Split::of(scaled(y, -60));
        let sum = |series: &Block| {
            let sum = (1..terms).rev().fold(0, |sum, k| {
                // beyond the range only where the series does not converge
                scaled_product::<60>(Split::of(sum), place) + series.get(k)
            });
            times_power_of_two(sum as f64, series.exponent) * self.scale
        };
        let [value, integral] = [&self.variation, &self.integral].map(sum);
        (self.slope + y * value, y * (self.slope + y * integral))
    }

    /// Magnitude of the k-th coefficient times a weight; 0 where it is a rounding error.
    pub(super) fn term(&self, k: usize, weight: f32) -> f32 {
        let size = self.variation.get(k).abs();
        match k {
            0 => Float::abs(weight * self.slope as f32),
            _ if size <= NOISE => 0.0,
            _ => size as f32 * self.variation.short_unit() * Float::abs(weight * self.scale as f32),
        }
    }
}

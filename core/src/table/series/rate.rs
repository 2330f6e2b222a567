//! Power series with integer coefficients of a common exponent, and the rate of a phase as such a series.
//!
//! A sum of products is exact and costs a 32-bit processor four multiplications for each pair of coefficients. The coefficients of a
//! converging series do not grow, so that all of them share an exponent.

use core::ops::Range;

use crate::scalar::{Float, Scalar, exponent, short_power_of_two, times_power_of_two};
use crate::table::series::integers::{
    BITS, Factor, LOW_BITS, Split, TERMS, in_range, inner, scaled, scaled_product, sum_in_range,
};

/// Coefficients of 1, y, y², ..., in units of 2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Block {
    coefficients: [Split; TERMS],
    pub(super) exponent: i32,
}

impl Block {
    pub(super) const ZERO: Self = Self { coefficients: [Split::ZERO; TERMS], exponent: 0 };

    /// Sets the exponent for coefficients that are expected to be at most `magnitude`.
    pub(super) fn scale_for(&mut self, magnitude: f64) {
        self.exponent = exponent(magnitude).max(-900) - BITS;
    }

    /// Product of a factor and the expected magnitude of a coefficient.
    pub(super) fn magnitude_times(&self, factor: f64) -> f64 {
        times_power_of_two(factor, self.exponent + BITS)
    }

    pub(super) fn get(&self, k: usize) -> i64 {
        self.coefficients.get(k).map_or(0, |coefficient| coefficient.value())
    }

    /// Stores a coefficient; `None` where it is out of range, so that the series does not converge.
    pub(super) fn put(&mut self, k: usize, value: i64) -> Option<()> {
        let value = Split::of(in_range(value)?);
        if let Some(coefficient) = self.coefficients.get_mut(k) {
            *coefficient = value;
        }
        Some(())
    }

    /// Unit of the coefficients; 0 or infinity beyond the range of `f32`.
    pub(super) fn short_unit(&self) -> f32 {
        short_power_of_two(self.exponent)
    }

    /// Coefficient of y^k of a product of two series, from these terms of the first one, divided by 2^shift.
    #[inline(never)] // a call: set-up multiplies series in a dozen places
    pub(super) fn product(&self, other: &Self, terms: Range<usize>, k: usize, shift: i32) -> i64 {
        let first = terms.start;
        let ours = self.coefficients.get(terms).unwrap_or_default();
        // the iteration ends with the terms of the first series
        let theirs = other.coefficients.get(..=k.saturating_sub(first)).unwrap_or_default();
        inner(ours.iter().zip(theirs.iter().rev()), shift)
    }

    /// Sum Σ c yᵏ⁻¹ over the coefficients k from 1 to `terms` - 1, at y in [-1, 1].
    fn sum(&self, y: f64, terms: usize) -> f64 {
        let y = Split::of(scaled(y, -60));
        // beyond the range only where the series does not converge
        let next = |sum, k| scaled_product::<60>(Split::of(sum), y) + self.get(k);
        times_power_of_two((1..terms).rev().fold(0, next) as f64, self.exponent)
    }

    /// Upper bound on the sum Σ |c| yᵏ over these coefficients at y = `quarters`/4, from their upper words. The first one counts as larger
    /// by `noise`.
    pub(super) fn size(&self, quarters: u32, terms: usize, noise: f32) -> f32 {
        let coefficients = self.coefficients.get(1..terms).unwrap_or_default().iter().rev();
        let sum = coefficients.fold(0, |sum: u32, c| ((sum * quarters + 3) >> 2) + c.high.unsigned_abs() + 1);
        0.25 * quarters as f32 * (((1_u32 << LOW_BITS) as f32 * sum as f32 + noise) * self.short_unit())
    }
}

/// Largest rounding error of a coefficient, in units of its series: the sum of some roundings of half a unit.
const NOISE: i64 = 4;

/// Whether the k-th coefficient is a rounding error, or its term at y = 1/2 is below `least` units.
pub(super) fn is_negligible(coefficient: i64, k: usize, least: i64) -> bool {
    let size = coefficient.abs();
    size <= NOISE || size >> k < least
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

    /// Rate at y in [-1, 1].
    pub(super) fn value(&self, y: f64, terms: usize) -> f64 {
        self.slope + y * (self.variation.sum(y, terms) * self.scale)
    }

    /// Integral from 0 to y.
    pub(super) fn integral(&self, y: f64, terms: usize) -> f64 {
        y * (self.slope + y * (self.integral.sum(y, terms) * self.scale))
    }

    /// Upper bound on the rate for y in [-1/4, 1/4].
    pub(super) fn greatest(&self, terms: usize) -> f32 {
        self.bound(self.variation.size(1, terms, 0.0))
    }

    /// Sum of the magnitudes of the terms of the integral from 0 to y = `quarters`/4.
    pub(super) fn size(&self, quarters: u32, terms: usize) -> f32 {
        // a rounding error of the coefficients counts as the term of which it would be the rounding in f64
        let noise = (NOISE as f64 / f64::ROUNDING) as f32;
        0.25 * quarters as f32 * self.bound(self.integral.size(quarters, terms, noise))
    }

    fn bound(&self, varied: f32) -> f32 {
        Float::abs(self.slope) as f32 + varied * Float::abs(self.scale) as f32
    }

    /// Magnitude of the k-th coefficient; 0 where it is a rounding error.
    pub(super) fn term(&self, k: usize, weight: f32) -> f32 {
        let size = self.variation.get(k).abs();
        match k {
            0 => Float::abs(weight * self.slope as f32),
            _ if size <= NOISE => 0.0,
            _ => size as f32 * self.variation.short_unit() * Float::abs(weight * self.scale as f32),
        }
    }
}

/// Constant factors of the recurrence for one slow phase, whose denominator is in the memory of the rate's integral until that is computed.
pub(super) struct SlowFactors {
    /// Factor of cos²χ in the rate.
    square: Factor,
    /// Factor of the denominator in the rate.
    divisor: Factor,
    /// Factors of D and of D dχ/dx in the denominator.
    delta: Factor,
    drive: Factor,
    negligible: i64,
}

impl SlowFactors {
    /// Factors for a rate with these factors of cos²χ, D and D dχ/dx. It sets the exponents of the rate's series.
    pub(super) fn new(
        rate: &mut Rate,
        slope: f64,
        [of_square, of_delta, of_drive]: [f64; 3],
        [square, delta, drive]: [&Block; 3],
        least: f64,
    ) -> Self {
        let Rate { variation, integral: divisor, scale, .. } = rate;
        divisor.scale_for(delta.magnitude_times(of_delta) + drive.magnitude_times(of_drive));
        variation.scale_for(
            divisor.magnitude_times(Float::abs(slope)) + square.magnitude_times(Float::abs(of_square)),
        );
        *scale = 1.0;
        Self {
            square: Factor::new(of_square, square.exponent, variation.exponent),
            divisor: Factor::new(slope, divisor.exponent, variation.exponent),
            delta: Factor::new(of_delta, delta.exponent, divisor.exponent),
            drive: Factor::new(of_drive, drive.exponent, divisor.exponent),
            negligible: scaled(least, variation.exponent),
        }
    }

    /// Computes the k-th coefficients. Returns whether the rate's is negligible, or `None` where one is out of range.
    pub(super) fn advance(
        &self,
        rate: &mut Rate,
        k: usize,
        [square, delta, drive]: [i64; 3],
    ) -> Option<bool> {
        let Rate { variation, integral: divisor, .. } = rate;
        let of_divisor = sum_in_range([self.delta.times(delta), self.drive.times(drive)])?;
        let known = divisor.product(variation, 1..k, k, -divisor.exponent);
        let of_rate = sum_in_range([self.square.times(square), -self.divisor.times(of_divisor), -known])?;
        divisor.put(k, of_divisor)?;
        variation.put(k, of_rate)?;
        Some(is_negligible(of_rate, k, self.negligible))
    }
}

//! Sums over the residuals of a pass.

use crate::scalar::Real;

/// Sums over the residuals of a pass.
#[derive(Clone, Copy)]
pub(super) struct Sums<F> {
    pub(super) cost: Sum<F>,
    pub(super) squares: Sum<F>,
    pub(super) largest: F,
    /// Numbers of the components that were used, that were not used, and whose weight was reduced.
    pub(super) used: u32,
    pub(super) unused: u32,
    pub(super) outliers: u32,
}

impl<F: Real> Default for Sums<F> {
    fn default() -> Self {
        let zero = Sum { high: F::ZERO, low: F::ZERO };
        Self { cost: zero, squares: zero, largest: F::ZERO, used: 0, unused: 0, outliers: 0 }
    }
}

impl<F: Real> Sums<F> {
    /// Adds a residual in standard deviations; returns the square root of its weight.
    pub(super) fn add(&mut self, residual: F, huber: F) -> F {
        let size = residual.abs();
        let outlier = size > huber;
        let weight = if outlier { (huber / size).sqrt() } else { F::ONE };
        let limited = if outlier { huber } else { size };
        self.cost.add(limited * (size.doubled() - limited));
        self.squares.add(limited.squared());
        self.largest = if size > self.largest { size } else { self.largest };
        self.used += 1;
        self.outliers += u32::from(outlier);
        weight
    }
}

/// Compensated sum of many numbers, in two parts, so that it keeps the digits of each. On a chip without a unit for
/// `f64`, an addition in `f64` takes longer.
#[derive(Clone, Copy)]
pub(super) struct Sum<F> {
    high: F,
    low: F,
}

impl<F: Real> Sum<F> {
    /// Adds a number, which is not negative; the rounding error of the high part goes to the low one.
    pub(super) fn add(&mut self, x: F) {
        let high = self.high + x;
        let taken = high - self.high;
        self.low = self.low + ((self.high - (high - taken)) + (x - taken));
        self.high = high;
    }

    pub(super) fn to_f64(self) -> f64 {
        self.high.to_f64() + self.low.to_f64()
    }
}

//! Sums over the residuals of a pass.

use crate::scalar::Real;

/// Sums over the residuals of a pass.
#[derive(Clone, Copy)]
pub(super) struct Sums<F> {
    pub(super) cost: Sum<F>,
    pub(super) squares: Sum<F>,
    pub(super) largest: F,
}

impl<F: Real> Default for Sums<F> {
    fn default() -> Self {
        let zero = Sum { high: F::ZERO, low: F::ZERO };
        Self { cost: zero, squares: zero, largest: F::ZERO }
    }
}

/// Sum of many numbers in two parts, so that it keeps the digits of each: a chip without `f64` takes longer for an
/// addition in it.
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

//! Error bound of a table.

use crate::scalar::Float;

/// Upper bound on an error at any tick: `constant` plus `per_tick` for each tick from the launch.
///
/// That of the orientation is 2 √(|Δα|² + |Δβ|²), relative to the exact motion of the numbers that were launched. It counts the worst case
/// of integer roundings, six standard deviations of those in `f64`, and an estimate of the series' remainders.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// Error at the tick of the launch, rad (rad per unit time for rates).
    pub constant: f64,
    /// Growth of the error per tick from the launch, rad (rad per unit time for rates).
    pub per_tick: f64,
}

impl ErrorBound {
    /// Bound of a table before its set-up.
    pub(crate) const ZERO: Self = Self { constant: 0.0, per_tick: 0.0 };

    /// Upper bound on the error at a number of ticks from the launch, of either sign.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * Float::abs(ticks)
    }

    pub(super) const fn numbers(self) -> [f64; 2] {
        [self.constant, self.per_tick]
    }
}

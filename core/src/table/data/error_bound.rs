//! Error bound of a table.

/// Upper bound on an error: `constant` plus `per_tick` for each tick from the launch.
///
/// The error of an orientation is 2 √(|Δα|² + |Δβ|²). Roundings count at their worst case; the remainders of series, and the roundings along the
/// path, are estimated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// Error at the launch, rad (rad/s for rates).
    pub constant: f64,
    /// Growth of the error per tick.
    pub per_tick: f64,
}

impl ErrorBound {
    pub(crate) const ZERO: Self = Self { constant: 0.0, per_tick: 0.0 };

    /// Upper bound on the error at a number of ticks from the launch, of either sign: the tick minus the epoch.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * ticks.abs()
    }

    pub(super) const fn numbers(self) -> [f64; 2] {
        [self.constant, self.per_tick]
    }
}

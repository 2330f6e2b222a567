//! Bound on an error of a table, which grows with the number of ticks.

/// Stated bound on an error: `constant` plus `per_tick` for each tick from the launch.
///
/// The error of an orientation is 2 √(|Δα|² + |Δβ|²). For orientations in `f32` and fixed point the roundings of a tick are proved. Those of `f64`, of
/// rates and of a set-up are counted. Truncation errors of series and the roundings of their steps are estimated. See [the error bound](crate::error_bound).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorBound {
    /// Error at the launch, rad (rad/s for rates).
    pub constant: f64,
    /// Growth of the error per tick, rad (rad/s for rates).
    pub per_tick: f64,
}

impl ErrorBound {
    pub(crate) const ZERO: Self = Self { constant: 0.0, per_tick: 0.0 };

    /// Upper bound on the error at this number of ticks after the launch, or before it if negative.
    #[must_use]
    pub fn after(&self, ticks: f64) -> f64 {
        self.constant + self.per_tick * ticks.abs()
    }

    pub(super) const fn numbers(self) -> [f64; 2] {
        [self.constant, self.per_tick]
    }
}

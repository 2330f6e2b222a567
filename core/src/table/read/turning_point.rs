//! Turning points of the nutation, at which u is least or greatest.

use crate::phase::{Phase, PhaseFraction};
use crate::table::data::storage::EphemerisView;
use crate::table::scalar::EphemerisScalar;

/// Turning point of u.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TurningPoint {
    /// First tick at or after the turning point.
    pub tick: i64,
    /// Whether u = e₂ at the turning point; otherwise u = e₁.
    pub upper: bool,
}

/// Phase difference below which a phase counts as that of an event, such as a turning point: 2^-50 turns, the rounding
/// of a start.
pub(crate) const PHASE_TOLERANCE: Phase = Phase::from_bits(1 << 46);

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Next turning point of u at tick n or later; `None` where u has no further turning point, is constant, or has
    /// more than one turning point per tick. Cost: a division of 128 bits.
    #[must_use]
    pub fn next_turning_point(&self, n: i64) -> Option<TurningPoint> {
        let [turns_per_tick, ..] = self.clock.turns_per_tick();
        if !(self.clock.has_turning_points && turns_per_tick > 0.0 && turns_per_tick < 0.5) {
            return None;
        }
        let before = n.saturating_sub(1);
        let ([step, ..], [nutation, ..]) = (self.clock.steps(), self.clock.at(before));
        // a phase just before the turning point counts as the point itself, so the next turning point is half a
        // period later
        let (halves, rest) = (nutation.to_phase() + PHASE_TOLERANCE).halves();
        let ticks = ticks_to(Phase::HALF - rest + PHASE_TOLERANCE, step);
        Some(TurningPoint { tick: before.saturating_add(ticks), upper: halves.rem_euclid(2) == 0 })
    }
}

/// Number of ticks until a phase difference `ahead` is reached, or almost reached; both arguments are positive.
fn ticks_to(ahead: Phase, step: PhaseFraction) -> i64 {
    let (ahead, step) = ((ahead - PHASE_TOLERANCE).to_bits().max(0), step.to_phase().to_bits().max(1));
    i64::try_from((ahead + step - 1) / step).unwrap_or(i64::MAX)
}

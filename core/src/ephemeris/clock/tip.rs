//! Mean tip angle of an ephemeris at any tick, and at any time between two ticks.

use crate::ephemeris::clock::{Instant, whole_ticks};
use crate::ephemeris::mean_rates::MeanRates;
use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::{Extended, Float};

/// Mean tip angle at any tick, whole turns included, as plain numbers: see `core/docs/table_format.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct TipClock {
    /// Mean tip angle at tick 0, in units of 2^-96 turns: words of 32 bits, the least significant first.
    pub start: [u32; 4],
    /// Increment of the mean tip angle per tick, in units of 2^-96 turns: words of 32 bits, the least significant
    /// first.
    pub step: [u32; 4],
    /// Quarter turns of the argument of the tabulated αβ at u = e₁: 0, or 1 or -1 where α passes through 0 there (e₁
    /// = -1).
    pub quarter: i8,
    /// Number of the parameters α and β that pass through 0 instead of winding around it: 0, 1 or 2.
    pub passes: u8,
    /// Whether the tip angle exists; false where the axis is vertical at all times.
    pub exists: bool,
}

impl TipClock {
    /// Placeholder for a clock before set-up.
    pub(super) const STOPPED: Self =
        Self { start: [0; 4], step: [0; 4], quarter: 0, passes: 0, exists: false };

    /// Mean tip angle at tick n.
    #[inline(always)]
    pub(crate) fn at(&self, n: i64) -> Phase {
        Phase::from_words(self.start) + Phase::from_words(self.step).times(n)
    }

    /// Mean tip angle at an instant.
    #[inline(always)]
    pub(crate) fn at_instant(&self, instant: Instant) -> Phase {
        self.at(instant.tick) + Phase::from_words(self.step).share(instant.share)
    }

    /// Mean tip angle after `whole` ticks, given as the sum of two numbers, and a fraction `share` in [0, 1) of the
    /// next tick.
    pub(crate) fn between(&self, whole: [f64; 2], share: Extended) -> Phase {
        let turned = Phase::from_words(self.step).to_bits().wrapping_mul(whole_ticks(whole));
        Phase::from_words(self.start)
            + Phase::from_bits(turned)
            + Phase::new(Phase::from_words(self.step).to_f64() * share.to_f64())
    }

    /// Mean tip angle of a motion that starts at angle 0.
    pub(super) fn new(motion: &Motion, rates: &MeanRates, exact_step: [Extended; 3]) -> Self {
        let [alpha, beta] = motion.windings();
        let passes = if rates.is_periodic { u8::from(alpha == 0) + u8::from(beta == 0) } else { 0 };
        Self {
            start: [0; 4],
            step: Self::increment(exact_step, passes),
            quarter: if alpha == 0 { motion.signs().l_plus_n.factor() as i8 } else { 0 },
            passes,
            exists: !motion.regime().is_vertical(),
        }
    }

    /// Increment of the mean tip angle per tick. The mean rates of A and B include half a turn per period for a parameter
    /// that passes through 0; that of the tip angle does not.
    pub(crate) fn increment([nutation, a, b]: [Extended; 3], passes: u8) -> [u32; 4] {
        let halves = nutation * Extended::from(0.5 * f64::from(passes));
        (a + b - halves).to_phase().words()
    }
}

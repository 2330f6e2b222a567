//! Mean tip angle of an ephemeris at any tick, and at any time between two ticks.

use crate::motion::Motion;
use crate::phase::Phase;
use crate::scalar::Extended;

/// Mean tip angle at any tick, whole turns included, as plain numbers: see `core/docs/table_format.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct TipClock {
    /// Mean tip angle at tick 0, in units of 2^-96 turns, the least significant word first.
    pub start: [u32; 4],
    /// Increment of the mean tip angle per tick, in units of 2^-96 turns, the least significant word first.
    pub step: [u32; 4],
    /// Quarter turns of the argument of the tabulated αβ at u = e₁: 0; 1 or -1 where e₁ = -1.
    pub quarter: i8,
    /// Number of the parameters α and β that pass through 0: 0, 1 or 2.
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

    /// Mean tip angle between ticks n and n + 1, with the time since tick n in units of 2^-64 ticks.
    #[inline(always)]
    pub(crate) fn between(&self, n: i64, share: u64) -> Phase {
        self.at(n) + Phase::from_words(self.step).share(share)
    }

    /// Mean tip angle after a whole number of ticks.
    pub(crate) fn after(&self, ticks: i128) -> Phase {
        Phase::from_words(self.start)
            + Phase::from_bits(Phase::from_words(self.step).to_bits().wrapping_mul(ticks))
    }

    /// Increment of the mean tip angle per tick in turns. Those of A and B include half a turn per period for a parameter that passes
    /// through 0; that of the tip angle does not.
    pub(super) fn exact_step(&self, steps: [Extended; 3]) -> Extended {
        exact_step(steps, self.passes)
    }

    /// Mean tip angle of a motion that starts at angle 0.
    pub(super) fn new(motion: &Motion, exact_step: [Extended; 3]) -> Self {
        let [alpha, beta] = motion.windings();
        let passes = u8::from(alpha == 0) + u8::from(beta == 0);
        Self {
            start: [0; 4],
            step: Self::increment(exact_step, passes),
            quarter: if alpha == 0 { motion.signs().l_plus_n.factor() as i8 } else { 0 },
            passes,
            exists: !motion.regime().is_vertical(),
        }
    }

    /// Increment of the mean tip angle per tick, in units of 2^-96 turns.
    pub(crate) fn increment(steps: [Extended; 3], passes: u8) -> [u32; 4] {
        exact_step(steps, passes).to_phase().words()
    }
}

fn exact_step([nutation, a, b]: [Extended; 3], passes: u8) -> Extended {
    a + b - nutation * Extended::from(0.5 * f64::from(passes))
}

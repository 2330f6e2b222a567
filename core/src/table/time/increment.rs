//! Increment of a phase per tick.

use crate::integer::product_u64;
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::Extended;
use crate::table::time::Instant;

/// Increment of a phase per tick, in turns: a whole number plus a fraction in [0, 1).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Increment {
    pub(crate) whole_turns: i64,
    pub(crate) fraction: WrappedPhase,
}

impl Increment {
    /// Increment modulo 2^32 turns.
    pub(crate) fn to_phase(self) -> Phase {
        Phase::TURN * self.whole_turns + self.fraction.to_phase()
    }

    pub(crate) fn to_turns(self) -> Extended {
        Extended::from(self.whole_turns) + self.fraction.to_phase().into()
    }

    /// Advance of the phase until an instant, without the whole turns of whole ticks. Error below 2^-62 turns, and 0 at a tick.
    #[inline(always)]
    pub(crate) fn advance(self, Instant { tick, fraction }: Instant) -> Phase {
        let in_whole_ticks = self.fraction.to_phase().to_bits().wrapping_mul(tick);
        Phase::from_bits(in_whole_ticks) + self.advance_in_tick(fraction)
    }

    /// Advance of the phase in a fraction of a tick, modulo 2^32 turns. Error below 2^-62 turns.
    #[inline(always)]
    pub(crate) fn advance_in_tick(self, fraction: Phase) -> Phase {
        let [leading, _] = product_u64(self.fraction.leading_bits(), fraction.leading_bits());
        fraction * self.whole_turns + Phase::from_leading_bits(leading)
    }
}

/// Increment of a number of turns, rounded to 2^-96 turns.
impl From<Extended> for Increment {
    fn from(turns: Extended) -> Self {
        let Instant { tick, fraction } = turns.into();
        Self { whole_turns: tick as i64, fraction: WrappedPhase::from_phase(fraction) }
    }
}

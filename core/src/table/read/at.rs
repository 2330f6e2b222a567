//! Samples of a table at a tick and at a time.

use crate::phase::WrappedPhase;
use crate::table::data::Table;
use crate::table::evaluation::TableScalar;
use crate::table::read::sample::Sample;
use crate::table::time::{Instant, Phases};

impl<R: TableScalar> Table<R> {
    /// Sample of the motion at tick n, of either sign.
    #[inline(always)]
    #[must_use]
    pub fn at_tick(&self, n: i64) -> Sample<'_, R> {
        let phases = self.clock.phases_at_tick(n).map(WrappedPhase::leading_bits);
        Sample::new(self, phases, Instant::at_tick(n))
    }

    /// Sample of the motion t seconds after tick 0. With an epoch, t = 0 is not the launch.
    ///
    /// * t is taken as exact; a t that is not finite counts as 0.
    /// * Resolution: 2^-96 ticks. Beyond 2^96 ticks no digit of the orientation is correct, and the tick number wraps.
    /// * It has the bits of [`Table::at_tick`] where t times the tick rate is exactly a whole number, and the rate a multiple of 1/2.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, t: f64) -> Sample<'_, R> {
        self.at_instant(Instant::at_time(t, self.clock.ticks_per_time))
    }

    /// Sample at an instant, also beyond the ticks of `i64`.
    #[inline(always)]
    pub(crate) fn at_instant(&self, instant: Instant) -> Sample<'_, R> {
        let since_first = Instant { tick: instant.tick.wrapping_sub(i64::MIN.into()), ..instant };
        let phases = Phases::from_array(self.clock.first_phases)
            .zip_map(self.clock.increments(), |first, increment| {
                first.wrapping_add(since_first.advance(increment).leading_bits())
            });
        Sample::new(self, phases, instant)
    }

    /// Time of tick 2^63, the end of the range of ticks, s.
    #[must_use]
    pub fn end_time(&self) -> f64 {
        let [ticks_per_time, _] = self.clock.ticks_per_time;
        (1_u64 << 63) as f64 / ticks_per_time
    }
}

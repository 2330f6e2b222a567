//! Samples of a table at a tick, at a time, and at a number of ticks with a fraction.

use crate::integer::{ldexp_i128, mantissa_and_exponent};
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::Extended;
use crate::table::data::Phases;
use crate::table::data::{Clock, Table};
use crate::table::evaluation::TableScalar;
use crate::table::read::sample::Sample;

impl<R: TableScalar> Table<R> {
    /// Sample of the motion at tick n, of either sign.
    #[inline(always)]
    #[must_use]
    pub fn at_tick(&self, n: i64) -> Sample<'_, R> {
        let phases = self.clock.phases_at_tick(n).map(WrappedPhase::leading_bits);
        Sample { table: self, phases, tick: n.into(), fraction: Phase::ZERO }
    }

    /// Sample of the motion t (s) after tick 0, taken as exact; 0 if it is not finite. With an epoch, t = 0 is not the launch.
    ///
    /// * Resolution: 2^-64 ticks up to 2^62 ticks.
    /// * It has the bits of [`Table::at_tick`] where t times the tick rate is exactly a whole number, and the rate a multiple of 1/2.
    /// * It is slower beyond 2^62 ticks, and if a phase turns by half a turn or more a tick.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, t: f64) -> Sample<'_, R> {
        let clock = &self.clock;
        let Some((tick, fraction)) = clock.tick_and_fraction(t) else {
            let t = if t.is_finite() { t } else { 0.0 };
            return self.at_ticks(clock.tick_rate() * t.into());
        };
        let phases = clock.phases_after_tick(tick, fraction);
        Sample { table: self, phases, tick: tick.into(), fraction: Phase::from_leading_bits(fraction) }
    }

    /// Sample at any number of ticks, with a fraction. Resolution: 2^-128 of the number.
    #[cold]
    pub(crate) fn at_ticks(&self, ticks: Extended) -> Sample<'_, R> {
        let (tick, fraction) = ticks.floor_and_fraction();
        let phases = self.clock.phases_at_fraction(tick, fraction);
        Sample { table: self, phases, tick, fraction: fraction.to_phase() }
    }

    /// Time of tick 2^63, the end of the range of ticks, s.
    #[must_use]
    pub fn end_time(&self) -> f64 {
        let [ticks_per_time, _] = self.clock.ticks_per_time;
        (1_u64 << 63) as f64 / ticks_per_time
    }
}

impl<W: Copy> Clock<W> {
    /// Phases at tick n.
    #[inline(always)]
    pub(crate) fn phases_at_tick(&self, n: i64) -> Phases<WrappedPhase> {
        let since_first = n.wrapping_sub(i64::MIN) as u64;
        let after =
            |first: u64, step: [u32; 3]| WrappedPhase::new(step).times(since_first).plus_leading_bits(first);
        let [nutation, alpha, beta] = &self.first_phases;
        // by reference: an array of all steps would take nine registers at once
        let [nutation_step, alpha_step, beta_step] = &self.step;
        Phases {
            nutation: after(*nutation, *nutation_step),
            alpha: after(*alpha, *alpha_step),
            beta: after(*beta, *beta_step),
        }
    }

    /// Tick at or before a time (0 if not finite), and the fraction of a tick after it in units of 2^-64.
    ///
    /// `None` beyond 2^62 ticks, and where a phase turns by half a turn or more a tick.
    #[inline(always)]
    fn tick_and_fraction(&self, t: f64) -> Option<(i64, u64)> {
        const MAX_TICKS: f64 = (1_u64 << 62) as f64;
        let [hi, lo] = self.ticks_per_time;
        let near = (t * hi).abs() < MAX_TICKS || !t.is_finite();
        let less_than_half_a_turn = self.step_turns.iter().all(|[turns, _]| turns.abs() < 0.5);
        if !(near && less_than_half_a_turn) {
            return None;
        }
        let (time, exponent) = mantissa_and_exponent(t);
        let product = |rate: f64| {
            let (rate, rate_exponent) = mantissa_and_exponent(rate);
            ldexp_i128(i128::from(time) * i128::from(rate), exponent + rate_exponent + 64)
        };
        let ticks = if lo == 0.0 { product(hi) } else { product(hi).wrapping_add(product(lo)) };
        Some(((ticks >> 64) as i64, ticks as u64))
    }

    /// 64 leading bits of the phases at a fraction of a tick after tick n.
    #[inline(always)]
    fn phases_after_tick(&self, n: i64, fraction: u64) -> Phases<u64> {
        let since_first = n.wrapping_sub(i64::MIN) as u64;
        Phases::from_array(self.first_phases).zip_map(self.steps(), |first, step| {
            first.wrapping_add(step.leading_bits_after(since_first, fraction))
        })
    }

    /// 64 leading bits of the phases at a fraction of a tick after any tick.
    #[cold]
    fn phases_at_fraction(&self, tick: i128, fraction: Extended) -> Phases<u64> {
        let since_first = tick.wrapping_sub(i64::MIN.into());
        let advances = self.steps().zip_map(self.steps_in_turns(), |step, turns| {
            let whole = Phase::from_bits(step.to_phase().to_bits().wrapping_mul(since_first));
            (whole + (turns * fraction).to_phase()).leading_bits()
        });
        Phases::from_array(self.first_phases).zip_map(advances, u64::wrapping_add)
    }
}

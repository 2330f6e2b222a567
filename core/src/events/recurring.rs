//! Instants at which the nutation phase has one of several values.

use crate::phase::{Phase, PhaseFraction};
use crate::scalar::{Extended, Ring};
use crate::table::{EphemerisScalar, EphemerisView};

/// Phase difference below which a phase counts as that of an event: 2^-50 turns, the rounding of a start.
const TOLERANCE: Phase = Phase::from_bits(1 << 46);

/// Next instants of up to four nutation phases, in ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recurring {
    next: [Option<Extended>; 4],
    /// Nutation period, in ticks; `None` where u is constant.
    pub(super) period: Option<Extended>,
}

impl Recurring {
    /// Instants at tick `from` or later. There are none where u is constant.
    pub(super) fn new<R: EphemerisScalar>(
        view: &EphemerisView<R>,
        phases: [Option<Phase>; 4],
        from: i64,
    ) -> Self {
        let nowhere = Self { next: [None; 4], period: None };
        let [step, ..] = view.clock.exact_steps();
        if !(view.clock.has_turning_points && step > Extended::ZERO) {
            return nowhere;
        }
        let start = Extended::from(from);
        let [now, ..] = view.clock.at(from).map(PhaseFraction::to_phase);
        let ahead = |phase: Phase| {
            let ahead = PhaseFraction::from_phase(phase - now + TOLERANCE).to_phase() - TOLERANCE;
            if ahead <= TOLERANCE { start } else { start + Extended::from(ahead) / step }
        };
        Self { next: phases.map(|phase| phase.map(ahead)), period: Some(Extended::ONE / step) }
    }

    /// Next instant, with the index of its phase.
    pub(super) fn peek(&self) -> Option<(usize, Extended)> {
        let instants = self.next.iter().enumerate().filter_map(|(index, next)| Some((index, (*next)?)));
        instants.reduce(|earliest, other| if other.1 < earliest.1 { other } else { earliest })
    }

    /// Next instant, with the index of its phase. It is replaced by the instant one period later.
    pub(super) fn pop(&mut self) -> Option<(usize, Extended)> {
        let (index, ticks) = self.peek()?;
        if let Some(next) = self.next.get_mut(index) {
            *next = self.period.map(|period| ticks + period);
        }
        Some((index, ticks))
    }

    /// Advances all instants by a number of ticks that is a whole number of periods.
    pub(super) fn skip(&mut self, ticks: Extended) {
        self.next = self.next.map(|next| next.map(|next| next + ticks));
    }
}

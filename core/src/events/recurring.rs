//! Instants at which the nutation phase has one of several values.

use crate::ephemeris::{AT_THE_POINT, EphemerisScalar, EphemerisView};
use crate::phase::{Phase, PhaseFraction};
use crate::scalar::{Extended, Float, Ring};

/// Next instants of N nutation phases, in ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recurring<const N: usize> {
    next: [Option<Extended>; N],
    /// Nutation period, in ticks; `None` where each phase is passed once.
    period: Option<Extended>,
}

impl<const N: usize> Recurring<N> {
    /// Instants at tick `from` or later. There are none where u is constant.
    pub(super) fn new<R: EphemerisScalar>(
        view: &EphemerisView<R>,
        phases: [Option<Phase>; N],
        from: i64,
    ) -> Self {
        let nowhere = Self { next: [None; N], period: None };
        let [step, ..] = view.clock.exact_steps();
        if !(view.clock.turns && step > Extended::ZERO) {
            return nowhere;
        }
        let start = Extended::from(from);
        let not_before = |ticks: Extended| if ticks < start { start } else { ticks };
        if let Some([first, last]) = view.clock.nutation_interval() {
            // an aperiodic motion passes each phase once, on either side of its lowest point
            let lowest = (first + last).halved();
            let margin = Extended::from(AT_THE_POINT) / step;
            let at = |phase: Phase| lowest + Extended::from(phase.principal()) / step;
            let next = phases.map(|phase| phase.map(at).filter(|t| *t + margin > start).map(not_before));
            return Self { next, period: None };
        }
        let [now, ..] = view.clock.unstopped(from.into(), Extended::ZERO).map(PhaseFraction::to_phase);
        let ahead = |phase: Phase| {
            // a phase that differs from that of the event by at most `AT_THE_POINT` counts as equal
            let ahead = PhaseFraction::of(phase - now + AT_THE_POINT).to_phase() - AT_THE_POINT;
            if ahead <= AT_THE_POINT { start } else { start + Extended::from(ahead) / step }
        };
        Self { next: phases.map(|phase| phase.map(ahead)), period: Some(Extended::ONE / step) }
    }

    /// Nutation period, in ticks.
    pub(super) fn period(&self) -> Option<Extended> {
        self.period
    }

    /// Next instant, with the index of its phase.
    pub(super) fn peek(&self) -> Option<(usize, Extended)> {
        let mut earliest: Option<(usize, Extended)> = None;
        for (index, next) in self.next.iter().enumerate() {
            if let Some(ticks) = *next
                && earliest.is_none_or(|(_, before)| ticks < before)
            {
                earliest = Some((index, ticks));
            }
        }
        earliest
    }

    /// Next instant, with the index of its phase. It is replaced by the instant one period later, or removed if each
    /// phase is passed once.
    pub(super) fn pop(&mut self) -> Option<(usize, Extended)> {
        let (index, ticks) = self.peek()?;
        if let Some(next) = self.next.get_mut(index) {
            *next = self.period.map(|period| ticks + period);
        }
        Some((index, ticks))
    }

    /// Removes the instants of the phase with this index.
    pub(super) fn drop(&mut self, index: usize) {
        if let Some(next) = self.next.get_mut(index) {
            *next = None;
        }
    }

    /// Advances all instants by a number of ticks that is a whole number of periods.
    pub(super) fn skip(&mut self, ticks: Extended) {
        self.next = self.next.map(|next| next.map(|next| next + ticks));
    }
}

//! Instants at which a nutation has given phases, period after period.

use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Ring};
use crate::table::{Table, TableScalar};

/// Tolerance of the nutation phase, 2^-50 turns: an instant within it of the start counts as the start.
const PHASE_TOLERANCE: Phase = Phase::from_bits(1 << 46);

/// Next instants of up to four nutation phases, in ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct RecurringInstants {
    next: [Option<Extended>; 4],
    /// Time between two instants of a phase, in ticks; `None` where there are none.
    pub(super) period: Option<Extended>,
}

impl RecurringInstants {
    /// Instants at tick `from` or later. There are none without turning points.
    pub(super) fn new<R: TableScalar>(table: &Table<R>, phases: [Option<Phase>; 4], from: i64) -> Self {
        let nowhere = Self { next: [None; 4], period: None };
        let increment = Extended::from(table.clock.increments().nutation);
        if !(table.clock.has_turning_points && increment > Extended::ZERO) {
            return nowhere;
        }
        let start = Extended::from(from);
        let now = table.clock.phases_at_tick(from).nutation.to_phase();
        let ahead = |phase: Phase| {
            let ahead = WrappedPhase::from_phase(phase - now + PHASE_TOLERANCE).to_phase() - PHASE_TOLERANCE;
            if ahead <= PHASE_TOLERANCE { start } else { start + Extended::from(ahead) / increment }
        };
        Self { next: phases.map(|phase| phase.map(ahead)), period: Some(Extended::ONE / increment) }
    }

    /// One instant per period, the first of them a period after the start.
    pub(super) fn every(period: Extended, start: Extended) -> Self {
        Self { next: [Some(start + period), None, None, None], period: Some(period) }
    }

    /// Next instant, with the index of its phase.
    pub(super) fn peek(&self) -> Option<(usize, Extended)> {
        let instants = self.next.iter().enumerate().filter_map(|(index, next)| Some((index, (*next)?)));
        instants.reduce(|earliest, other| if other.1 < earliest.1 { other } else { earliest })
    }

    /// Next instant, with the index of its phase. The instant one period later takes its place.
    pub(super) fn pop(&mut self) -> Option<(usize, Extended)> {
        let (index, ticks) = self.peek()?;
        if let Some(next) = self.next.get_mut(index) {
            *next = self.period.map(|period| ticks + period);
        }
        Some((index, ticks))
    }

    /// Advances all instants by whole periods, given in ticks.
    pub(super) fn skip(&mut self, ticks: Extended) {
        self.next = self.next.map(|next| next.map(|next| next + ticks));
    }
}

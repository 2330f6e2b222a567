//! Search for the instants of a tip angle.
//!
//! Between the turning points of u and, on a curve with loops, the phases of u = l/n, the tip angle is monotone: a bisection finds the instant.
//! Whole periods that do not reach the angle are skipped.

use crate::events::event::Event;
use crate::events::recurring_instants::RecurringInstants;
use crate::events::rising_half::{LAST_RISING, at_phase, bisect};
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float, Ring};
use crate::table::{Table, TableScalar};

/// Instants of one tip angle in order.
#[derive(Clone, Copy, Debug)]
pub(super) struct TipAngleSearch<'a, R: TableScalar> {
    table: &'a Table<R>,
    /// Ends of the monotone pieces.
    ends: RecurringInstants,
    /// Tip angle that is searched, modulo a turn.
    target: Phase,
    /// Instant up to which the tip angle was searched, in ticks.
    at: Extended,
    /// Tip angle at this instant; after an event the target, without rounding.
    angle: Phase,
}

/// Rounding of a tip angle, within which the start is an event.
const START_TOLERANCE: Phase = Phase::from_bits(1 << 48);
/// Number of consecutive pieces after which every phase of a period was searched.
const PIECES_OF_A_PERIOD: usize = 5;
/// Greatest number of skips. A skip covers all but 1e-9 of the way, so that three are enough for 2^63 ticks.
const MAX_SKIPS: usize = 8;

impl<R: TableScalar> Table<R> {
    /// Tip angle at a number of ticks, with a fraction.
    fn tip_angle_at(&self, ticks: Extended) -> Phase {
        self.at_instant(ticks.into()).tip_angle_unchecked()
    }

    /// Nutation phase in (0, 1/2) turn at which φ' changes its sign; at most one, as |c|² φ' = s² (l - n u)/A.
    fn reversal(&self) -> Option<Phase> {
        /// Part of the greatest |c| |c'| that counts as 0, in roundings.
        const NOISE: f64 = 64.0;
        // |c|² φ' and |c| |c'|
        let turning = |nutation| {
            let sample = at_phase(self, nutation);
            let tip = sample.tip();
            let velocity = sample.tip_velocity();
            let size = tip.norm_squared().to_f64() * velocity.norm_squared().to_f64();
            ((tip.re * velocity.im - tip.im * velocity.re).to_f64(), Float::sqrt(size))
        };
        let [(lowest, least), (_, middle), (highest, greatest)] =
            [0, LAST_RISING / 2, LAST_RISING].map(turning);
        let noise = NOISE * (R::ROUNDING + R::Quantity::OPERATION_ERROR) * least.max(middle).max(greatest);
        let changes = lowest * highest < 0.0 && lowest.abs() > noise && highest.abs() > noise;
        changes.then(|| Phase::from_leading_bits(bisect(|nutation| turning(nutation).0 * lowest <= 0.0)))
    }
}

impl<'a, R: TableScalar> TipAngleSearch<'a, R> {
    /// Search from tick `from` on.
    pub(super) fn new(table: &'a Table<R>, target: Phase, from: i64) -> Self {
        let reversal = table.reversal();
        let phases = [Some(Phase::ZERO), Some(Phase::HALF), reversal, reversal.map(|phase| -phase)];
        let mut ends = RecurringInstants::new(table, phases, from);
        let at = from.into();
        if ends.period.is_none() {
            // where u is constant, a piece is a turn
            ends = RecurringInstants::every(
                Extended::ONE / Extended::from(table.clock.tip_increment()).abs(),
                at,
            );
        }
        Self { table, ends, target, at, angle: table.tip_angle_at(at) }.including_start()
    }

    /// Moves the start back by a rounding, so that an event at the start counts.
    fn including_start(mut self) -> Self {
        let mut after = Phase::ZERO;
        for _ in 0..PIECES_OF_A_PERIOD {
            let Some((_, end)) = self.ends.peek() else {
                break;
            };
            after = if end > self.at { self.table.tip_angle_at(end) - self.angle } else { Phase::ZERO };
            // a change by a rounding has no direction, as at a cusp
            if !(-START_TOLERANCE..=START_TOLERANCE).contains(&after) {
                break;
            }
            self.ends.pop();
        }
        self.angle = self.angle - if after < Phase::ZERO { -START_TOLERANCE } else { START_TOLERANCE };
        self
    }

    /// Rotation from an angle to the next target angle, in (0, 1] turn or in [-1, 0).
    fn turn_to_target(&self, angle: Phase, upward: bool) -> Phase {
        let distance = if upward { self.target - angle } else { angle - self.target };
        let distance = WrappedPhase::from_phase(distance).to_phase();
        let distance = if distance == Phase::ZERO { Phase::TURN } else { distance };
        if upward { distance } else { -distance }
    }

    /// Event on the piece until `end`, on which φ is monotone and reaches `after`.
    fn find_on_piece(&mut self, end: Extended, after: Phase) -> Option<Event> {
        let change = after - self.angle;
        let upward = change > Phase::ZERO;
        let ahead = self.turn_to_target(self.angle, upward);
        let is_past = |change: Phase| if upward { change >= ahead } else { change <= ahead };
        if change == Phase::ZERO || !is_past(change) {
            return None;
        }
        let Self { at, angle, .. } = *self;
        let instant = |part: u64| at + ((end - at) * Extended::from(part as i64)).ldexp(1 - u64::BITS as i32);
        let first_past = bisect(|part| is_past(self.table.tip_angle_at(instant(part)) - angle));
        (self.at, self.angle) = (instant(first_past), angle + ahead);
        Event::from_ticks(self.at, upward)
    }

    /// Skips periods that do not reach the target, from the least and greatest change of the angle in the last one.
    fn skip_periods(&mut self, period: Extended, [least, greatest]: [Phase; 2]) -> Option<()> {
        /// Part of the periods skipped at once; the rest allows for roundings.
        const SKIPPED_PART: f64 = 1.0 - 1e-9;
        let per_period = Extended::from(self.table.clock.tip_increment()) * period;
        let upward = per_period > Extended::ZERO;
        let edge = self.angle + if upward { greatest } else { least };
        let periods =
            Extended::from(self.turn_to_target(edge, upward)) / per_period * Extended::from(SKIPPED_PART);
        let (_, fraction) = periods.floor_and_fraction();
        let periods = periods - fraction - Extended::ONE;
        if periods > Extended::ZERO {
            let ticks = periods * period;
            Event::from_ticks(self.at + ticks, true)?;
            self.ends.skip(ticks);
            self.at = self.at + ticks;
            self.angle = self.table.tip_angle_at(self.at);
        }
        Some(())
    }

    /// Next instant at which the tip angle is the target.
    pub(super) fn next(&mut self) -> Option<Event> {
        if !self.table.clock.tip_exists {
            return None;
        }
        let period = self.ends.period?;
        for _ in 0..MAX_SKIPS {
            let start = self.angle;
            let mut least = Phase::ZERO;
            let mut greatest = Phase::ZERO;
            for _ in 0..PIECES_OF_A_PERIOD {
                let (_, end) = self.ends.peek()?;
                let after = self.table.tip_angle_at(end);
                if let Some(event) = self.find_on_piece(end, after) {
                    return Some(event);
                }
                self.ends.pop();
                (self.at, self.angle) = (end, after);
                least = least.min(after - start);
                greatest = greatest.max(after - start);
            }
            let change = self.angle - start;
            self.skip_periods(period, [least - change, greatest - change])?;
        }
        None
    }
}

//! Turning points, crossings of a level, and instants of a tip angle.
//!
//! Between the turning points of u and, on a curve with loops, the phases of u = l/n, the tip angle is monotone: a bisection finds the instant.
//! Whole periods that do not reach the angle are skipped.

use crate::events::bisection::{LAST_RISING, at_phase, bisect};
use crate::events::recurring_instants::RecurringInstants;
use crate::events::{Event, Level};
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float, Ring, Scalar};
use crate::table::{EphemerisScalar, EphemerisView};

/// Events of one kind in order, up to the last tick of `i64`.
#[derive(Clone, Copy, Debug)]
pub struct Events<'a, R: EphemerisScalar> {
    view: &'a EphemerisView<R>,
    /// Instants of the events, or of the ends of monotone pieces.
    instants: RecurringInstants,
    /// Tip angle that is searched, modulo a turn. `None`: the instants themselves are the events.
    target: Option<Phase>,
    /// Instant up to which the tip angle was searched, in ticks.
    at: Extended,
    /// Tip angle at this instant; after an event the target, without rounding.
    angle: Phase,
}

impl<R: EphemerisScalar> Iterator for Events<'_, R> {
    type Item = Event;

    fn next(&mut self) -> Option<Event> {
        if self.target.is_some() {
            return self.next_tip_angle();
        }
        let (index, ticks) = self.instants.pop()?;
        Event::at(ticks, index == 0)
    }
}

/// Rounding of a tip angle, within which the start is an event.
const START_TOLERANCE: Phase = Phase::from_bits(1 << 48);
/// Number of consecutive pieces that contain a whole period.
const PIECES_OF_A_PERIOD: usize = 5;
/// Greatest number of skips. A skip leaves 1e-9 of the way, so that three skips reach 2^63 ticks; five are in reserve.
const MOST_SKIPS: usize = 8;

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Events at these nutation phases; only those at the first one are upward.
    fn events(&self, phases: [Option<Phase>; 4], from: i64) -> Events<'_, R> {
        let instants = RecurringInstants::new(self, phases, from);
        Events { view: self, instants, target: None, at: from.into(), angle: Phase::ZERO }
    }

    /// Turning points of u at tick `from` or later. There are none where u is constant to 2^-49.
    #[must_use]
    pub fn turning_points(&self, from: i64) -> Events<'_, R> {
        self.events([Some(Phase::HALF), Some(Phase::ZERO), None, None], from)
    }

    /// Instants at tick `from` or later at which u crosses a level. Roundings decide whether a level within the error bound of e₁ or e₂ is reached.
    ///
    /// Error of the time: the orientation's error bound over the tilt's rate |u'|/√(1 - u²), and 2^-54 ticks. Cost: 65 orientations, once.
    #[must_use]
    pub fn crossings(&self, level: Level, from: i64) -> Events<'_, R> {
        let rising = level.phase(self);
        self.events([rising, rising.map(|phase| -phase), None, None], from)
    }

    /// Instants at tick `from` or later at which [`Sample::tip_angle`](crate::Sample::tip_angle) is `angle`, whole turns aside.
    ///
    /// Error of the time: the orientation's error bound over 2|αβφ'|, and 2^-54 ticks. Cost: some 100 tip angles.
    #[must_use]
    pub fn tip_angles(&self, angle: Phase, from: i64) -> Events<'_, R> {
        let reversal = self.reversal();
        let phases = [Some(Phase::ZERO), Some(Phase::HALF), reversal, reversal.map(|phase| -phase)];
        let mut events = self.events(phases, from);
        if events.instants.period.is_none() {
            // where u is constant, a piece is a turn
            let turn = Extended::ONE / Extended::from(self.clock.tip_step()).abs();
            events.instants = RecurringInstants::every(turn, events.at);
        }
        events.target = Some(angle);
        events.angle = self.tip_angle_at(events.at);
        events.including_start()
    }

    /// Tip angle at a number of ticks, with a fraction.
    fn tip_angle_at(&self, ticks: Extended) -> Phase {
        self.at_ticks(ticks).tip_angle_unchecked()
    }

    /// Nutation phase in (0, 1/2) turn at which φ' changes its sign; at most one, as |c|² φ' = s² (l - n u)/A.
    fn reversal(&self) -> Option<Phase> {
        /// Part of the greatest |c| |c'| that counts as 0, in roundings.
        const NOISE: f64 = 64.0;
        // |c|² φ' and |c| |c'|
        let turning = |nutation| {
            let sample = at_phase(self, nutation);
            let (tip, velocity) = (sample.tip(), sample.tip_velocity());
            let size = tip.norm_squared().to_f64() * velocity.norm_squared().to_f64();
            ((tip.re * velocity.im - tip.im * velocity.re).to_f64(), Float::sqrt(size))
        };
        let [(lowest, least), (_, middle), (highest, greatest)] =
            [0, LAST_RISING / 2, LAST_RISING].map(turning);
        let noise = NOISE * (R::ROUNDING + R::Quantity::ROUNDING) * least.max(middle).max(greatest);
        let changes = lowest * highest < 0.0 && lowest.abs() > noise && highest.abs() > noise;
        changes.then(|| bisect(|nutation| turning(nutation).0 * lowest <= 0.0))
    }
}

impl<R: EphemerisScalar> Events<'_, R> {
    /// Moves the start back by a rounding, so that an event at the start counts.
    fn including_start(mut self) -> Self {
        let mut after = Phase::ZERO;
        for _ in 0..PIECES_OF_A_PERIOD {
            let Some((_, end)) = self.instants.peek() else {
                break;
            };
            after = if end > self.at { self.view.tip_angle_at(end) - self.angle } else { Phase::ZERO };
            // a change by a rounding has no direction, as at a cusp
            if !(-START_TOLERANCE..=START_TOLERANCE).contains(&after) {
                break;
            }
            self.instants.pop();
        }
        self.angle = self.angle - if after < Phase::ZERO { -START_TOLERANCE } else { START_TOLERANCE };
        self
    }

    /// Rotation from an angle to the next target angle, in (0, 1] turn or in [-1, 0).
    fn turn_to_target(&self, angle: Phase, upward: bool) -> Phase {
        let target = self.target.unwrap_or_default();
        let distance = if upward { target - angle } else { angle - target };
        let distance = WrappedPhase::from_phase(distance).to_phase();
        let distance = if distance == Phase::ZERO { Phase::TURN } else { distance };
        if upward { distance } else { -distance }
    }

    /// Event on the piece until `end`, on which φ is monotone and reaches `after`.
    fn find_on_piece(&mut self, end: Extended, after: Phase) -> Option<Event> {
        let turned = after - self.angle;
        let upward = turned > Phase::ZERO;
        let ahead = self.turn_to_target(self.angle, upward);
        let passed = |turned: Phase| if upward { turned >= ahead } else { turned <= ahead };
        if turned == Phase::ZERO || !passed(turned) {
            return None;
        }
        let (start, mut low, mut high) = (self.angle, self.at, end);
        for _ in 0..u64::BITS {
            let middle = (low + high).halved();
            if passed(self.view.tip_angle_at(middle) - start) { high = middle } else { low = middle }
        }
        (self.at, self.angle) = (high, start + ahead);
        Event::at(high, upward)
    }

    /// Skips periods that do not reach the target, from the least and greatest change of the angle in the last one.
    fn skip_periods(&mut self, period: Extended, [least, greatest]: [Phase; 2]) -> Option<()> {
        /// Part of the periods skipped at once; the rest allows for roundings.
        const SKIPPED_PART: f64 = 1.0 - 1e-9;
        let per_period = Extended::from(self.view.clock.tip_step()) * period;
        let upward = per_period > Extended::ZERO;
        let edge = self.angle + if upward { greatest } else { least };
        let periods =
            Extended::from(self.turn_to_target(edge, upward)) / per_period * Extended::from(SKIPPED_PART);
        let (_, fraction) = periods.floor_and_fraction();
        let periods = periods - fraction - Extended::ONE;
        if periods > Extended::ZERO {
            let ticks = periods * period;
            Event::at(self.at + ticks, true)?;
            self.instants.skip(ticks);
            self.at = self.at + ticks;
            self.angle = self.view.tip_angle_at(self.at);
        }
        Some(())
    }

    /// Next instant at which the tip angle is the target.
    fn next_tip_angle(&mut self) -> Option<Event> {
        if !self.view.clock.tip_exists {
            return None;
        }
        let period = self.instants.period?;
        for _ in 0..MOST_SKIPS {
            let start = self.angle;
            let (mut least, mut greatest) = (Phase::ZERO, Phase::ZERO);
            for _ in 0..PIECES_OF_A_PERIOD {
                let (_, end) = self.instants.peek()?;
                let after = self.view.tip_angle_at(end);
                if let Some(event) = self.find_on_piece(end, after) {
                    return Some(event);
                }
                self.instants.pop();
                (self.at, self.angle) = (end, after);
                least = least.min(after - start);
                greatest = greatest.max(after - start);
            }
            let turned = self.angle - start;
            self.skip_periods(period, [least - turned, greatest - turned])?;
        }
        None
    }
}

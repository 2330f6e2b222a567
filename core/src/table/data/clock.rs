//! Clock of a table: the numbers that give the phases at any time.

use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float};
use crate::table::time::{Instant, Phases};

/// Numbers of a table that do not depend on the segment, as in [the table format](crate::table_format).
///
/// | for | fields |
/// |---|---|
/// | orientation at a tick | `first_phases`, `increments` |
/// | orientation at a time | also `ticks_per_time` |
/// | tip, angular velocity | `twice_tip_scale`; `x_rate`, `mean_sum_rate`, `spin` |
/// | tip angle | `mean_tip_at_tick_0`, `ab_quarter_turns_at_e1`, `tip_passages`, `tip_exists` |
/// | events, error bounds | `has_turning_points`; `epoch` |
///
/// `x_rate` and `mean_sum_rate` follow from the increments and `ticks_per_time`. They are stored because a conversion at each tick would
/// take too many cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // the increments first, in reach of the smallest chip's load instructions
pub struct Clock<W> {
    /// Increments per tick of the nutation phase and of the mean phases Λ_α and Λ_β, with whole turns, in units of 2^-96 turns, lowest word first.
    pub increments: [[u32; 4]; 3],
    /// Argument of the tabulated ab at u = e₁ in quarter turns: 0, or ±1 for e₁ = -1.
    pub ab_quarter_turns_at_e1: i8,
    /// Number of passages of the tip through the centre in a period: one for each of α and β that passes through 0.
    pub tip_passages: u8,
    /// Whether the tip angle exists: the axis does not stay vertical.
    pub tip_exists: bool,
    /// Whether u has turning points: false where the tilt is constant to 2^-49 rad.
    pub has_turning_points: bool,
    /// Twice [`Top::tip_scale`](crate::Top::tip_scale), 2 s, m; 2 for another support. The tip is at c = 2 s αβ.
    pub twice_tip_scale: W,
    /// Rate dx/dt on a segment of an eighth of half a period, /s.
    pub x_rate: W,
    /// Rate of Λ_α + Λ_β, rad/s.
    pub mean_sum_rate: W,
    /// Angular velocity (n - K)/C about the axis, rad/s.
    pub spin: W,
    /// Nutation phase and mean phases at tick `i64::MIN`, in units of 2^-64 turns.
    pub first_phases: [u64; 3],
    /// Number of ticks in a unit of time, as the sum of two `f64`.
    pub ticks_per_time: [f64; 2],
    /// Mean tip angle at tick 0, with whole turns, in units of 2^-96 turns, lowest word first.
    pub mean_tip_at_tick_0: [u32; 4],
    /// Tick of the launch, from which the error bounds grow.
    pub epoch: i64,
}

impl<W: Float> Clock<W> {
    pub(crate) const ZERO: Self = Self {
        increments: [[0; 4]; 3],
        ab_quarter_turns_at_e1: 0,
        tip_passages: 0,
        tip_exists: false,
        has_turning_points: false,
        twice_tip_scale: W::ZERO,
        x_rate: W::ZERO,
        mean_sum_rate: W::ZERO,
        spin: W::ZERO,
        first_phases: [0; 3],
        ticks_per_time: [0.0; 2],
        mean_tip_at_tick_0: [0; 4],
        epoch: 0,
    };
}

impl<W: Copy> Clock<W> {
    /// Rates of x on a segment of an eighth of half a period, of Λ_α + Λ_β, and about the axis.
    #[inline(always)]
    pub(crate) const fn rates(&self) -> [W; 3] {
        [self.x_rate, self.mean_sum_rate, self.spin]
    }

    #[inline(always)]
    pub(crate) fn increments(&self) -> Phases<Phase> {
        Phases::from_array(self.increments).map(Phase::from_words)
    }

    /// Increments without whole turns.
    #[inline(always)]
    pub(crate) fn wrapped_increments(&self) -> Phases<WrappedPhase> {
        Phases::from_array(self.increments).map(WrappedPhase::from_words)
    }

    /// Phases at tick n.
    #[inline(always)]
    pub(crate) fn phases_at_tick(&self, n: i64) -> Phases<WrappedPhase> {
        let since_first = n.wrapping_sub(i64::MIN) as u64;
        let after = |first: u64, increment: [u32; 4]| {
            WrappedPhase::from_words(increment).times(since_first).plus_leading_bits(first)
        };
        let [nutation, alpha, beta] = &self.first_phases;
        // by reference: an array of all increments would take nine registers at once
        let [nutation_increment, alpha_increment, beta_increment] = &self.increments;
        Phases {
            nutation: after(*nutation, *nutation_increment),
            alpha: after(*alpha, *alpha_increment),
            beta: after(*beta, *beta_increment),
        }
    }

    /// Number of ticks in a unit of time.
    pub(crate) fn tick_rate(&self) -> Extended {
        Extended::from_f64_pair(self.ticks_per_time)
    }

    /// Increment of the mean tip angle per tick.
    pub(crate) fn tip_increment(&self) -> Phase {
        self.mean_tip_advance(self.increments())
    }

    /// Advance of the mean tip angle from those of the phases. Each zero of α or β replaces half a turn a period by a passage.
    fn mean_tip_advance(&self, Phases { nutation, alpha, beta }: Phases<Phase>) -> Phase {
        alpha + beta - Phase::from_bits(nutation.to_bits() >> 1) * self.tip_passages.into()
    }

    /// Mean tip angle at an instant.
    ///
    /// * `nutation`: 64 leading bits of the nutation phase then
    pub(in crate::table) fn mean_tip(&self, Instant { tick, fraction }: Instant, nutation: u64) -> Phase {
        let in_whole_ticks = Phase::from_bits(self.tip_increment().to_bits().wrapping_mul(tick));
        let in_tick = self.increments().map(|increment| increment.times_fraction(fraction));
        let passages = Phase::from_bits(i128::from(nutation as i64) << 31) * self.tip_passages.into();
        Phase::from_words(self.mean_tip_at_tick_0)
            + in_whole_ticks
            + self.mean_tip_advance(in_tick)
            + passages
    }
}

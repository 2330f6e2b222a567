//! Clock from the mean rates of a motion and its phases at the launch.

use crate::body::{ParameterError, check};
use crate::constants::Regime;
use crate::motion::Motion;
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float};
use crate::table::data::cell::MIN_SEGMENTS;
use crate::table::data::{Clock, Table};
use crate::table::evaluation::TableScalar;
use crate::table::time::{Instant, Phases, Tick, is_falling};

impl<W: Float> Clock<W> {
    /// Clock of a motion; `set_tip_angle_at_launch` adds [`Clock::mean_tip_at_tick_0`].
    ///
    /// * `epoch`: tick of the launch
    /// * `rates`: mean rates, turns/s
    /// * `launch`: phases at the launch
    ///
    /// # Errors
    /// `tick`: a phase advances by 2^31 turns or more in a tick.
    pub(super) fn new(
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        rates: Phases<Extended>,
        launch: Phases<Phase>,
    ) -> Result<Self, ParameterError> {
        const MOST_TURNS: f64 = (1_u32 << 31) as f64;
        let length = tick.length();
        // in `u64`, because LLVM 22 compiles a product of `i128` wrongly for RISC-V where the epoch is a constant
        let ticks = epoch.wrapping_sub(i64::MIN) as u64;
        let turns = rates.map(|rate| rate * length);
        let is_short = turns.into_array().into_iter().all(|turns| turns.to_f64().abs() < MOST_TURNS);
        check(is_short, "tick", "shorter than 2^31 turns of each phase")?;
        let increments = turns.map(Extended::to_phase);
        let first_phases = launch.zip_map(increments, |phase, increment| {
            WrappedPhase::from_phase(phase).minus(WrappedPhase::from_phase(increment).times(ticks))
        });
        let [alpha_winding, beta_winding] = motion.windings();
        let tip_passages = u8::from(alpha_winding == 0) + u8::from(beta_winding == 0);
        Ok(Self {
            increments: increments.map(Phase::words).into_array(),
            ab_quarter_turns_at_e1: if alpha_winding == 0 {
                motion.signs().l_plus_n.as_i32() as i8
            } else {
                0
            },
            tip_passages,
            tip_exists: !motion.regime().is_vertical(),
            has_turning_points: motion.regime() == Regime::Nutating,
            twice_tip_scale: W::from_f64(2.0 * motion.top().tip_scale()),
            // x changes by 2 over each segment
            x_rate: W::from_f64(4.0 * MIN_SEGMENTS as f64 * rates.nutation.to_f64()),
            mean_sum_rate: W::from_f64(((rates.alpha + rates.beta) * Extended::TWO_PI).to_f64()),
            spin: W::from_f64(motion.first_integrals().spin),
            first_phases: first_phases.map(WrappedPhase::leading_bits).into_array(),
            ticks_per_time: tick.rate().to_f64_pair(),
            epoch,
            ..Self::ZERO
        })
    }
}

impl<R: TableScalar> Table<R> {
    /// Sets the mean tip angle so that the tip angle at the launch is the argument of c in (-1/2, 1/2] turn.
    ///
    /// * `launch`: phases at the launch
    pub(super) fn set_tip_angle_at_launch(
        &mut self,
        motion: &Motion,
        launch: Phases<Phase>,
        pause: &mut dyn FnMut(),
    ) {
        let Phases { nutation, alpha, beta } = launch;
        let nutation = nutation.leading_bits();
        let clock = &self.clock;
        let quarter_turn = Phase::QUARTER * i64::from(clock.ab_quarter_turns_at_e1);
        // whole turns, or half turns of a curve through the centre, such that φ begins in (-1/2, 1/2] turn
        let mean = alpha + beta + if is_falling(nutation) { -quarter_turn } else { quarter_turn };
        let offset = motion.tip_angle_at_launch() - mean - self.tabulated_tip_angle(nutation, pause);
        let principal = if clock.tip_passages > 0 {
            Phase::from_bits((offset * 2).principal().to_bits() >> 1)
        } else {
            offset.principal()
        };
        let mean_from_0 = clock.mean_tip(Instant::at_tick(clock.epoch), nutation);
        self.clock.mean_tip_at_tick_0 = (mean + offset - principal - mean_from_0).words();
    }
}

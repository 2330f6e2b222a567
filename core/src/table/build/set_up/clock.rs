//! Clock of a table: the rates of a motion, and its phases at the launch.

use crate::constants::Regime;
use crate::motion::Motion;
use crate::phase::{Phase, WrappedPhase};
use crate::scalar::{Extended, Float};
use crate::table::data::cell::{LEAST_SEGMENTS, is_falling};
use crate::table::data::{Clock, EphemerisView, Tick};
use crate::table::evaluation::EphemerisScalar;

impl<W: Float> Clock<W> {
    /// Clock of a motion that is launched at tick `epoch`, without [`Clock::tip_start`].
    ///
    /// * `turns`: nutation frequency and rates of the mean phases, turns/s
    /// * `start`: nutation phase and mean phases at the launch
    pub(super) fn new(
        motion: &Motion,
        tick: Tick,
        epoch: i64,
        turns: [Extended; 3],
        start: [Phase; 3],
    ) -> Self {
        let length = tick.length();
        let [frequency, alpha, beta] = turns;
        // LLVM 22 compiles a product of `i128` wrongly for RISC-V where the epoch is known
        let ticks = epoch.wrapping_sub(i64::MIN) as u64;
        let (mut first_phases, mut step) = ([0; 3], [[0; 3]; 3]);
        let step_turns = turns.map(|turns| turns * length);
        for (((first, words), start), turns) in
            first_phases.iter_mut().zip(&mut step).zip(start).zip(step_turns)
        {
            let step = WrappedPhase::from_phase(turns.to_phase());
            *words = step.words();
            *first = WrappedPhase::from_phase(start).minus(step.times(ticks)).leading_bits();
        }
        let [alpha_winding, beta_winding] = motion.windings();
        let mut clock = Self {
            step,
            tip_start_quarter_turns: if alpha_winding == 0 {
                motion.signs().l_plus_n.as_i32() as i8
            } else {
                0
            },
            tip_sign_changes: u8::from(alpha_winding == 0) + u8::from(beta_winding == 0),
            tip_exists: !motion.regime().is_vertical(),
            has_turning_points: motion.regime() == Regime::Nutating,
            twice_tip_scale: W::from_f64(2.0 * motion.top().tip_scale()),
            // x changes by 2 over each segment
            x_rate: W::from_f64(4.0 * LEAST_SEGMENTS as f64 * frequency.to_f64()),
            mean_sum_rate: W::from_f64(((alpha + beta) * Extended::TWO_PI).to_f64()),
            axial_rate: W::from_f64(motion.first_integrals().spin),
            first_phases,
            step_turns: step_turns.map(Extended::to_f64_pair),
            ticks_per_time: tick.rate().to_f64_pair(),
            epoch,
            ..Self::ZERO
        };
        clock.tip_step = clock.exact_tip_step().to_phase().words();
        clock
    }
}

impl<R: EphemerisScalar> EphemerisView<R> {
    /// Sets the mean tip angle so that the tip angle at the launch is the argument of c in (-1/2, 1/2] turn.
    ///
    /// * `start`: nutation phase and mean phases at the launch
    pub(super) fn start_tip_angle(&mut self, motion: &Motion, start: [Phase; 3], pause: &mut dyn FnMut()) {
        let [nutation, a, b] = start;
        let nutation = nutation.leading_bits();
        let clock = &self.clock;
        let quarter_turn = Phase::QUARTER * i64::from(clock.tip_start_quarter_turns);
        let tabulated = self.tabulated_tip_angle(nutation, pause);
        // whole turns from the table; the remainder from the motion, which is exact near the centre
        let argument = motion.tip_angle_at_start();
        let required = argument - a - b - if is_falling(nutation) { -quarter_turn } else { quarter_turn };
        let off = required - tabulated;
        // modulo half a turn where the curve passes through the centre, because the radius then has a sign
        let off = if clock.tip_sign_changes > 0 {
            Phase::from_bits((off * 2).principal().to_bits() >> 1)
        } else {
            off.principal()
        };
        let at_launch = argument - self.passage_angle(nutation) - tabulated - off;
        self.clock.tip_start = (at_launch - clock.tip_step() * clock.epoch).words();
    }
}

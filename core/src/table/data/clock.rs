//! Clock of an ephemeris: the phases at any tick, and at any time between two ticks.

use crate::constants::Regime;
use crate::motion::Motion;
use crate::phase::{Phase, PhaseFraction, integer_parts, shifted};
use crate::scalar::{Extended, Float};
use crate::table::build::MeanRates;
use crate::table::cell::LONGEST;
use crate::table::data::tip_clock::TipClock;
use crate::table::tick::Tick;

/// Phases at tick `i64::MIN`, their increments per tick, and the scales of lengths and rates, as plain numbers: see
/// `core/docs/table_format.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // the increments lie first, within the short address range of the smallest chip's load instructions
pub struct Clock<W> {
    /// Increments per tick of nutation phase, A and B, in units of 2^-96 turns, the least significant word first.
    pub step: [[u32; 3]; 3],
    /// Scale of the tip curve, 2 s in m; 2 for a fixed tip.
    pub tip_scale: W,
    /// Nutation phase, A and B at tick `i64::MIN`, in units of 2^-64 turns.
    pub first: [u64; 3],
    /// Increments per tick of nutation phase, A and B in turns, whole turns included, each as the sum of two `f64`.
    pub exact_step: [[f64; 2]; 3],
    /// Number of ticks in a unit of time, as the sum of two `f64`.
    pub ticks_per_time: [f64; 2],
    /// Three rates: dx/dt on a segment of an eighth of half a period, per unit time; the mean rate of A + B, rad per unit time; the axial
    /// component (n - K)/C of the angular velocity, rad per unit time.
    pub rates: [W; 3],
    /// Clock of the mean tip angle.
    pub tip: TipClock,
    /// Whether u has turning points; false where u is constant to 2^-49.
    pub has_turning_points: bool,
}

/// Time between two ticks: the tick before it, and the time since that tick in units of 2^-64 ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Instant {
    pub(crate) tick: i64,
    pub(crate) share: u64,
}

impl<W: Float> Clock<W> {
    /// Placeholder for a clock before set-up; all increments are 0.
    pub(crate) const STOPPED: Self = Self {
        step: [[0; 3]; 3],
        tip_scale: W::ZERO,
        first: [0; 3],
        exact_step: [[0.0; 2]; 3],
        ticks_per_time: [0.0; 2],
        rates: [W::ZERO; 3],
        tip: TipClock::STOPPED,
        has_turning_points: false,
    };

    /// Clock of a motion that is launched at tick `epoch`; [`TipClock::start`] is not set yet.
    pub(crate) fn new(motion: &Motion, tick: Tick, epoch: i64, rates: &MeanRates, start: [Phase; 3]) -> Self {
        let length = tick.length();
        let exact_step = rates.turns.map(|turns| turns * length);
        let [frequency, alpha, beta] = rates.turns;
        let mean = ((alpha + beta) * Extended::TWO_PI).to_f64();
        let axial = motion.axial_rate();
        // x changes by 2 over each segment
        let x_rate = 4.0 * LONGEST as f64 * frequency.to_f64();
        Self {
            first: first_phases(start, epoch, exact_step),
            step: exact_step.map(|step| PhaseFraction::from_phase(step.to_phase()).words()),
            exact_step: exact_step.map(Extended::parts),
            ticks_per_time: tick.rate().parts(),
            tip_scale: W::from_f64(2.0 * motion.top().tip_scale()),
            rates: [x_rate, mean, axial].map(W::from_f64),
            tip: TipClock::new(motion, exact_step),
            has_turning_points: motion.regime() == Regime::Nutating,
        }
    }
}

impl<W> Clock<W> {
    /// Increments per tick of nutation phase, A and B.
    #[inline(always)]
    pub(crate) fn steps(&self) -> [PhaseFraction; 3] {
        self.step.map(PhaseFraction::new)
    }

    /// Increments per tick of nutation phase, A and B in turns, whole turns included.
    pub(crate) fn exact_steps(&self) -> [Extended; 3] {
        self.exact_step.map(|[hi, lo]| Extended::sum(hi, lo))
    }

    /// Increments per tick of nutation phase, A and B in turns, rounded to `f64`.
    pub(crate) fn turns_per_tick(&self) -> [f64; 3] {
        self.exact_steps().map(Float::to_f64)
    }

    /// Number of ticks until a time; a time that is not finite counts as 0.
    pub(crate) fn ticks(&self, t: f64) -> Extended {
        let [hi, lo] = self.ticks_per_time;
        Extended::sum(hi, lo) * if t.is_finite() { t } else { 0.0 }.into()
    }

    /// Instant of a time, rounded to 2^-64 ticks; `None` from 2^62 ticks on, and where this is too coarse because a phase turns by half a
    /// turn or more in a tick. A time that is not finite counts as 0.
    #[inline(always)]
    pub(crate) fn instant(&self, t: f64) -> Option<Instant> {
        const MOST_TICKS: f64 = (1_u64 << 62) as f64;
        let [hi, lo] = self.ticks_per_time;
        let (time, exponent) = integer_parts(t);
        let near = Float::abs(t * hi) < MOST_TICKS || !t.is_finite();
        let slow = |[turns, _]: [f64; 2]| Float::abs(turns) < 0.5;
        let [nutation_step, a_step, b_step] = self.exact_step;
        let exact = slow(nutation_step) && slow(a_step) && slow(b_step);
        (near && exact).then(|| {
            let product = |rate: f64| {
                let (rate, rate_exponent) = integer_parts(rate);
                shifted(i128::from(time) * i128::from(rate), exponent + rate_exponent + 64)
            };
            let ticks = if lo == 0.0 { product(hi) } else { product(hi).wrapping_add(product(lo)) };
            Instant { tick: (ticks >> 64) as i64, share: ticks as u64 }
        })
    }

    /// Leading 64 bits of nutation phase, A and B at an instant.
    #[inline(always)]
    pub(crate) fn at_instant(&self, Instant { tick, share }: Instant) -> [u64; 3] {
        let since_first = tick.wrapping_sub(i64::MIN) as u64;
        let ([nutation, a, b], [nutation_step, a_step, b_step]) = (self.first, self.steps());
        let after =
            |first: u64, step: PhaseFraction| first.wrapping_add(step.leading_after(since_first, share));
        [after(nutation, nutation_step), after(a, a_step), after(b, b_step)]
    }

    /// Nutation phase, A and B at tick n.
    #[inline(always)]
    pub(crate) fn at(&self, n: i64) -> [PhaseFraction; 3] {
        let since_first = n.wrapping_sub(i64::MIN) as u64;
        let after =
            |first: u64, step: [u32; 3]| PhaseFraction::new(step).times(since_first).plus_leading(first);
        let [nutation, a, b] = &self.first;
        // by reference: an array of all steps would take nine registers at once
        let [nutation_step, a_step, b_step] = &self.step;
        [after(*nutation, *nutation_step), after(*a, *a_step), after(*b, *b_step)]
    }

    /// Phases, and the mean tip angle, after any number of ticks. Whole turns are dropped.
    #[cold]
    #[inline(never)]
    pub(crate) fn after(&self, ticks: Extended) -> ([PhaseFraction; 3], Phase) {
        let (ticks, share) = ticks.floor_and_rest();
        let since_first = ticks.wrapping_sub(i64::MIN.into());
        let mut phases = self.steps();
        for ((phase, exact), first) in phases.iter_mut().zip(self.exact_steps()).zip(self.first) {
            let turned = Phase::from_bits(phase.to_phase().to_bits().wrapping_mul(since_first));
            let part = (exact * share).to_phase();
            *phase = PhaseFraction::from_phase(turned + part).plus_leading(first);
        }
        (phases, self.tip.after(ticks) + (self.tip.exact_step(self.exact_steps()) * share).to_phase())
    }
}

/// Phases at tick `i64::MIN`, in units of 2^-64 turns, from those at tick `epoch` and the increments in turns. The product is not one of
/// `i128`, which LLVM 22 compiles to a wrong one for RISC-V where the epoch is known.
fn first_phases(start: [Phase; 3], epoch: i64, exact_step: [Extended; 3]) -> [u64; 3] {
    let ticks = epoch.wrapping_sub(i64::MIN) as u64;
    let mut first = [0; 3];
    for ((first, start), step) in first.iter_mut().zip(start).zip(exact_step) {
        let before = PhaseFraction::from_phase(step.to_phase()).times(ticks);
        *first = PhaseFraction::from_phase(start).minus(before).leading();
    }
    first
}

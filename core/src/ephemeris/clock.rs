//! Clock of an ephemeris: the phases at any tick, and at any time between two ticks.

mod tip;

use crate::constants::Regime;
use crate::ephemeris::cell::PAIRS;
use crate::ephemeris::error_bound::increment_error;
use crate::ephemeris::mean_rates::MeanRates;
use crate::ephemeris::tabulated::Tabulated;
use crate::ephemeris::tick::Tick;
use crate::motion::Motion;
use crate::phase::{Phase, PhaseFraction, integer_parts, shifted, whole_number};
use crate::scalar::{Extended, Float, Ring};
pub use tip::TipClock;

/// Phases at tick 0, their increments per tick, and the scales of lengths and rates, as plain numbers: see
/// `core/docs/table_format.md`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // the increments lie first, within the short address range of the smallest chip's load instructions
pub struct Clock<W> {
    /// Increments per tick of nutation phase, A and B, in units of 2^-96 turns: words of 32 bits, the least
    /// significant first.
    pub step: [[u32; 3]; 3],
    /// Scale of the tip curve, 2 s in m; 2 for a fixed tip.
    pub tip_scale: W,
    /// Nutation phase, A and B at tick `i64::MIN`, from which ticks are counted by unsigned numbers; in units of
    /// 2^-64 turns.
    pub first: [u64; 3],
    /// First and last tick between which the phase of an aperiodic motion changes; `None` for other motions.
    pub horizon: Option<[i64; 2]>,
    /// Increments per tick of nutation phase, A and B in turns, whole turns included, each as the sum of two `f64`.
    pub exact_step: [[f64; 2]; 3],
    /// Number of ticks in a unit of time, as the sum of two `f64`.
    pub ticks_per_time: [f64; 2],
    /// Three rates: dx/dt on a pair of cells with one segment, per unit time; the mean rate of A + B, rad per unit time; the axial
    /// component (n - K)/C of the angular velocity, rad per unit time.
    pub rates: [W; 3],
    /// Clock of the mean tip angle.
    pub tip: TipClock,
    /// Whether u has turning points; false where u is constant to 2^-49.
    pub turns: bool,
}

/// Time between two ticks: the tick before it, and the time since that tick in units of 2^-64 ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Instant {
    tick: i64,
    share: u64,
}

impl Instant {
    /// Time since the tick, in ticks.
    fn exact_share(self) -> Extended {
        Extended::normalised(self.share.into(), -64)
    }
}

impl<W: Float> Clock<W> {
    /// Placeholder for a clock before set-up; all increments are 0.
    pub(crate) const STOPPED: Self = Self {
        step: [[0; 3]; 3],
        tip_scale: W::ZERO,
        first: [0; 3],
        horizon: None,
        exact_step: [[0.0; 2]; 3],
        ticks_per_time: [0.0; 2],
        rates: [W::ZERO; 3],
        tip: TipClock::STOPPED,
        turns: false,
    };

    pub(crate) fn new(motion: &Motion, tick: Tick, rates: &MeanRates, tabulated: &Tabulated) -> Self {
        let length = tick.length();
        let exact_step = rates.turns.map(|turns| turns * length);
        let [frequency, alpha, beta] = rates.turns;
        let mean = ((alpha + beta) * Extended::TWO_PI).to_f64();
        let axial = motion.axial_rate();
        // half a period has PAIRS pairs of cells, and x changes by 2 over a pair of one segment
        let x_rate = 4.0 * PAIRS as f64 * frequency.to_f64();
        let [start, ..] = tabulated.start;
        let [nutation_step, ..] = exact_step;
        Self {
            first: first_phases(tabulated.start, exact_step),
            step: exact_step.map(|step| PhaseFraction::of(step.to_phase()).words()),
            exact_step: exact_step.map(Extended::parts),
            ticks_per_time: tick.rate().parts(),
            horizon: (!rates.is_periodic).then(|| horizon(start, nutation_step)),
            tip_scale: W::from_f64(2.0 * motion.top().tip_scale()),
            rates: [x_rate, mean, axial].map(W::from_f64),
            tip: TipClock::new(motion, rates, exact_step),
            turns: matches!(motion.regime(), Regime::Nutating | Regime::Aperiodic),
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

    /// Rounding errors of the increments, in turns: exact minus rounded.
    pub(crate) fn increment_errors(&self) -> [f64; 3] {
        self.exact_steps().map(|exact| increment_error(exact.to_phase(), exact))
    }

    /// Increments per tick of nutation phase, A and B in turns, rounded to `f64`.
    pub(crate) fn turns_per_tick(&self) -> [f64; 3] {
        self.exact_steps().map(Float::to_f64)
    }

    /// Largest whole number of ticks until a time, as the sum of two `f64`, and the remainder in [0, 1). A time that
    /// is not finite counts as 0.
    pub(crate) fn ticks(&self, t: f64) -> ([f64; 2], Extended) {
        let [hi, lo] = self.ticks_per_time;
        let time = if t.is_finite() { t } else { 0.0 };
        (Extended::sum(hi, lo) * time.into()).floor_and_rest()
    }

    /// Instant of a time, rounded to 2^-64 ticks; `None` at 2^62 ticks and beyond. A time that is not finite counts as 0.
    #[inline(always)]
    pub(crate) fn instant(&self, t: f64) -> Option<Instant> {
        const MOST_TICKS: f64 = (1_u64 << 62) as f64;
        let [hi, lo] = self.ticks_per_time;
        let (time, exponent) = integer_parts(t);
        let near = Float::abs(t * hi) < MOST_TICKS || !t.is_finite();
        near.then(|| {
            let product = |rate: f64| {
                let (rate, rate_exponent) = integer_parts(rate);
                shifted(i128::from(time) * i128::from(rate), exponent + rate_exponent + 64)
            };
            let ticks = if lo == 0.0 { product(hi) } else { product(hi).wrapping_add(product(lo)) };
            Instant { tick: (ticks >> 64) as i64, share: ticks as u64 }
        })
    }

    /// Leading 64 bits of nutation phase, A and B at an instant; computed in integers where no increment exceeds half
    /// a turn.
    #[inline(always)]
    pub(crate) fn at_instant(&self, instant: Instant) -> [u64; 3] {
        let small = |[leading, _]: [f64; 2]| Float::abs(leading) < 0.5;
        let [nutation_step, a_step, b_step] = self.exact_step;
        if self.horizon.is_some() || !(small(nutation_step) && small(a_step) && small(b_step)) {
            return self.near(instant.tick, instant.exact_share()).map(PhaseFraction::leading);
        }
        let Instant { tick, share } = instant;
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
        let nutation = match self.horizon.and_then(|horizon| stopped(horizon, n)) {
            None => after(*nutation, *nutation_step),
            Some(stopped) => stopped,
        };
        [nutation, after(*a, *a_step), after(*b, *b_step)]
    }

    /// Phases after `whole` ticks, given as a sum of two numbers, and a fraction `share` in [0, 1) of the next tick.
    pub(crate) fn between(&self, whole: [f64; 2], share: Extended) -> [PhaseFraction; 3] {
        let ([leading, _], ticks) = (whole, whole_ticks(whole));
        // at 2^127 or more, the number modulo 2^128 no longer determines the sign
        let countable = Float::abs(leading) < TWO_TO_100;
        match i64::try_from(ticks) {
            Ok(n) if countable => self.near(n, share),
            _ => self.beyond(ticks, leading > 0.0, share),
        }
    }

    /// Phases at ticks outside the range of `i64`: the increments times the number of ticks modulo 2^96, which drops
    /// whole turns. An aperiodic motion keeps its last or first phases.
    #[cold]
    #[inline(never)]
    fn beyond(&self, ticks: i128, future: bool, share: Extended) -> [PhaseFraction; 3] {
        let [nutation, a, b] = self.unstopped(ticks, share);
        let nutation = match (self.horizon, future) {
            (None, _) => nutation,
            (Some(_), true) => PhaseFraction::ALMOST_HALF,
            (Some(_), false) => PhaseFraction::HALF,
        };
        [nutation, a, b]
    }

    /// Phases after any number of ticks and a fraction `share` in [0, 1) of the next; the nutation phase of an
    /// aperiodic motion wraps where it should stop.
    pub(crate) fn unstopped(&self, ticks: i128, share: Extended) -> [PhaseFraction; 3] {
        let since_first = ticks.wrapping_sub(i64::MIN.into());
        let mut phases = self.steps();
        for ((phase, exact), first) in phases.iter_mut().zip(self.exact_steps()).zip(self.first) {
            let turned = phase.to_phase().to_bits().wrapping_mul(since_first);
            let part = PhaseFraction::of((exact * share).to_phase());
            *phase = PhaseFraction::of(Phase::from_bits(turned)).plus_leading(first).plus(part);
        }
        phases
    }

    /// Phases at tick n plus a fraction `share` in [0, 1) of the next tick.
    #[cold]
    #[inline(never)]
    fn near(&self, n: i64, share: Extended) -> [PhaseFraction; 3] {
        let [nutation_part, a_part, b_part] = self.exact_steps().map(|step| (step * share).to_phase());
        let [nutation, a, b] = self.at(n);
        let nutation = match self.horizon {
            None => nutation.plus(PhaseFraction::of(nutation_part)),
            // the phase may begin to change between tick n and tick `first`, so it is computed backwards from `first`
            Some([first, _]) if n.saturating_add(1) == first => {
                let ([next, ..], [step, ..]) = (self.at(first), self.exact_steps());
                PhaseFraction::clamping(next.to_signed_phase() + (step * (share - Extended::ONE)).to_phase())
            }
            Some([first, _]) if n < first => nutation,
            Some(_) => PhaseFraction::clamping(nutation.to_signed_phase() + nutation_part),
        };
        [nutation, a.plus(PhaseFraction::of(a_part)), b.plus(PhaseFraction::of(b_part))]
    }
}

/// 2^100.
const TWO_TO_100: f64 = (1_u128 << 100) as f64;

/// Nutation phase of an aperiodic motion before and after its horizon; `None` between.
#[cold]
#[inline(never)]
fn stopped([first, last]: [i64; 2], n: i64) -> Option<PhaseFraction> {
    match n {
        _ if n < first => Some(PhaseFraction::HALF),
        _ if n > last => Some(PhaseFraction::ALMOST_HALF),
        _ => None,
    }
}

/// Phases at tick `i64::MIN`, in units of 2^-64 turns, from those at tick 0 and the increments in turns.
pub(crate) fn first_phases(start: [Phase; 3], exact_step: [Extended; 3]) -> [u64; 3] {
    let mut first = [0; 3];
    for ((first, start), step) in first.iter_mut().zip(start).zip(exact_step) {
        *first = (start + step.to_phase().times(i64::MIN)).fraction();
    }
    first
}

/// First and last tick at which a nutation phase that does not wrap is within half a turn of 0.
#[cold]
#[inline(never)] // a call, so that only aperiodic motions need stack for it
fn horizon(start: Phase, step: Extended) -> [i64; 2] {
    whole_between(interval_of_half_turns(start, step))
}

/// Instants at which a nutation phase that does not wrap leaves -1/2 turn and reaches 1/2 turn, in ticks after the
/// instant at which it is `phase`.
pub(crate) fn interval_of_half_turns(phase: Phase, step: Extended) -> [Extended; 2] {
    /// Half a turn, less a margin for the rounding of the quotient; a phase within the margin may count as the end.
    const HALF: f64 = 0.5 - 1e-15;
    [-HALF, HALF].map(|turns| Extended::from(turns - phase.to_f64()) / step)
}

/// First and last whole number between two numbers, within the range of `i64`.
pub(crate) fn whole_between([from, to]: [Extended; 2]) -> [i64; 2] {
    let floor = |x: Extended| match x.to_f64() as i64 {
        limit @ (i64::MIN | i64::MAX) => limit,
        _ => whole_ticks(x.floor_and_rest().0) as i64,
    };
    [floor(-from).saturating_neg(), floor(to)]
}

/// Sum of two whole numbers, modulo 2^128.
pub(crate) fn whole_ticks([leading, rest]: [f64; 2]) -> i128 {
    whole_number(leading).wrapping_add(whole_number(rest))
}

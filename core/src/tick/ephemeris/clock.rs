//! The three phases of any tick, and what lies between two.

use crate::cycle::Cycle;
use crate::launch::{Motion, Rates, Tabulated};
use crate::real::{DoubleDouble, Float, Ring};
use crate::tick::table::Tick;
use crate::turns::Turns;

/// The phases, what a tick adds to them, and the scales of what is derived.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(in crate::tick) struct Clock<W> {
    pub(super) step: [Cycle; 3],
    /// 2 s.
    pub(in crate::tick) tip_scale: W,
    /// At the very first tick, `i64::MIN`, from where ticks count up without a sign: in units of 2^-64 turns.
    pub(super) first: [u64; 3],
    /// The first and the last tick at which an aperiodic motion still moves; `None` for one that returns.
    pub(super) horizon: Option<[i64; 2]>,
    /// The steps in turns, whole ones included, for a part of a tick.
    pub(super) exact_step: [DoubleDouble; 3],
    /// Ticks in a unit of time.
    pub(super) ticks_per_time: DoubleDouble,
    /// dx/dt on a cell of one segment, and the mean rates of A and B in rad, per unit time.
    pub(in crate::tick) rates: [W; 3],
}

impl<W: Float> Clock<W> {
    pub(super) fn new(motion: &Motion, tick: Tick, rates: &Rates, tabulated: &Tabulated, cells: u32) -> Self {
        let length = tick.length();
        let exact_step = rates.turns.map(|turns| turns * length);
        let [frequency, alpha, beta] = rates.turns.map(Float::to_f64);
        let turn = 2.0 * core::f64::consts::PI;
        // half a period is `cells` cells, and x runs through 2 in one that is not cut
        let x_rate = 4.0 * f64::from(cells) * frequency;
        let step = exact_step.map(Turns::of);
        let [nutation, a, b] = tabulated.start;
        let [nutation_step, a_step, b_step] = step.map(|step| step.times(i64::MIN));
        Self {
            first: [nutation + nutation_step, a + a_step, b + b_step].map(Turns::fraction),
            step: step.map(Cycle::of),
            exact_step,
            ticks_per_time: tick.rate(),
            horizon: (!rates.returns).then(|| horizon(tabulated.start[0], exact_step[0])),
            tip_scale: W::from_f64(2.0 * motion.top().tip_scale()),
            rates: [x_rate, turn * alpha, turn * beta].map(W::from_f64),
        }
    }
}

impl<W> Clock<W> {
    /// Nutation phase, A and B of tick n.
    #[inline(always)]
    pub(super) fn at(&self, n: i64) -> [Cycle; 3] {
        let since_first = n.wrapping_sub(i64::MIN) as u64;
        let after = |first: u64, step: Cycle| step.times(since_first).plus_leading(first);
        let [nutation, a, b] = &self.first;
        let [nutation_step, a_step, b_step] = &self.step;
        let nutation = match self.horizon.and_then(|horizon| stopped(horizon, n)) {
            None => after(*nutation, *nutation_step),
            Some(stopped) => stopped,
        };
        [nutation, after(*a, *a_step), after(*b, *b_step)]
    }

    /// The phases of tick n and a share of the next, in [0, 1).
    pub(super) fn between(&self, n: i64, share: DoubleDouble) -> [Cycle; 3] {
        let [nutation_part, a_part, b_part] = self.exact_step.map(|step| Turns::of(step * share));
        let [nutation, a, b] = self.at(n);
        let nutation = match self.horizon {
            None => nutation.plus(Cycle::of(nutation_part)),
            // the moment may lie beyond the first tick's phase already: from there back
            Some([first, _]) if n.saturating_add(1) == first => {
                let ([next, ..], [step, ..]) = (self.at(first), self.exact_step);
                Cycle::clamping(next.to_signed_turns() + Turns::of(step * (share - DoubleDouble::ONE)))
            }
            Some([first, _]) if n < first => nutation,
            Some(_) => Cycle::clamping(nutation.to_signed_turns() + nutation_part),
        };
        [nutation, a.plus(Cycle::of(a_part)), b.plus(Cycle::of(b_part))]
    }
}

/// Where the nutation phase of an aperiodic motion stays, before and after its horizon.
#[cold]
#[inline(never)]
fn stopped([first, last]: [i64; 2], n: i64) -> Option<Cycle> {
    match n {
        _ if n < first => Some(Cycle::HALF),
        _ if n > last => Some(Cycle::ALMOST_HALF),
        _ => None,
    }
}

/// The first and the last tick at which a nutation phase that does not wrap is within half a turn of 0.
fn horizon(start: Turns, step: DoubleDouble) -> [i64; 2] {
    /// Room for what the quotient rounds off; a phase as near the end as that may count as the end.
    const HALF: f64 = 0.5 - 1e-15;
    let ticks = |turns: f64| (turns - start.to_f64()) / step.to_f64();
    [libm::ceil(ticks(-HALF)) as i64, libm::floor(ticks(HALF)) as i64]
}

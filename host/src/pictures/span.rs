//! Motion over a span of time, for pictures.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyEphemeris, furthest_time, smallest_ephemeris};
use crate::motion::propagate::{Sample, natural_time, period};
use crate::output::short;
use std::f64::consts::TAU;
use toytop::{Motion, Regime};

/// Motion between two times.
pub struct MotionSpan {
    table: Box<dyn AnyEphemeris>,
    /// First and last time, s.
    pub ends: [f64; 2],
    /// Number of nutation periods, where they determine the last time.
    pub periods: Option<u32>,
    /// Time in which the axis does the same again, s.
    cycle: f64,
}

/// Greatest number of nutation periods or turns in a picture: more would fill its frame.
pub const MOST_CYCLES: f64 = 1000.0;

impl MotionSpan {
    /// MotionSpan between two times, s. Without them it begins at 0 and is about one turn of the tip around the centre: a whole number of
    /// nutation periods, one turn where u is constant, or the time until the tip of an aperiodic motion is at the centre.
    ///
    /// * `most_cycles`: greatest number of nutation periods or turns
    ///
    /// # Errors
    /// [`Failure::Input`]: times beyond the reach of the ephemeris, or too many cycles. [`Failure::Method`]: no ephemeris is large
    /// enough.
    pub fn new(motion: &Motion, times: Option<[f64; 2]>, most_cycles: f64) -> Result<Self, Failure> {
        let (regime, cycle, furthest) = (motion.regime(), cycle(motion), furthest_time(motion));
        if let Some(t) = times.iter().flatten().find(|t| t.abs() > furthest) {
            return Err(Failure::Input(format!("--times: {t:e} must be within ±{furthest:.1e} s")));
        }
        let longest = most_cycles * cycle;
        if let Some([from, until]) = times.filter(|[from, until]| until - from > longest)
            && !regime.is_vertical()
        {
            let [from, until, longest] = [(from, 17), (until, 17), (longest, 4)].map(|(t, n)| short(t, n));
            let reason = format!("must span at most {longest} ({most_cycles} nutation periods or turns)");
            return Err(Failure::Input(format!("--times: {from}..{until}: {reason}")));
        }
        let table = smallest_ephemeris(Scalar::F64, motion)?;
        let periods = periods(motion).filter(|_| times.is_none());
        let ends = times.unwrap_or_else(|| match regime {
            Regime::Aperiodic => [0.0, time_to_vertical(motion, &*table)],
            _ => [0.0, cycle * periods.map_or(1.0, f64::from)],
        });
        Ok(Self { table, ends, periods, cycle })
    }

    /// Sample at a time.
    pub fn at(&self, t: f64) -> Sample {
        self.table.at(t).sample
    }

    /// Times of this number, evenly spread, both ends included.
    pub fn times(&self, count: u64) -> impl Iterator<Item = f64> {
        let [from, until] = self.ends;
        (0..count).map(move |i| from + (until - from) * i as f64 / (count.max(2) - 1) as f64)
    }

    /// Times of a curve: enough in each cycle of the motion that they show no alias of it.
    pub fn times_of_curve(&self) -> impl Iterator<Item = f64> {
        const LEAST: u64 = 1500;
        const IN_A_CYCLE: f64 = 64.0;
        let [from, until] = self.ends;
        let cycles = ((until - from) / self.cycle).ceil().min(MOST_CYCLES);
        self.times(LEAST.max((IN_A_CYCLE * cycles) as u64 + 1))
    }

    /// First and last time as text, with as many digits as distinguish a thousandth of the span.
    pub fn ends_as_text(&self) -> [String; 2] {
        let [from, until] = self.ends;
        let parts = from.abs().max(until.abs()) / (until - from);
        let digits = 4 + parts.log10().clamp(0.0, 13.0).ceil() as usize;
        self.ends.map(|t| short(t, digits))
    }
}

/// Time in which the axis does the same again, s: the nutation period, or a turn about the vertical where the tilt is constant. It is
/// the natural time of a motion that has neither.
fn cycle(motion: &Motion) -> f64 {
    let turn = || {
        let advance = motion.period_advance()?;
        let rate = advance.phi_per_period().abs() / advance.period;
        (rate > 0.0).then(|| TAU / rate)
    };
    match motion.regime() {
        Regime::Nutating => period(motion),
        regime if regime.is_regular_precession() => turn().unwrap_or_else(|| natural_time(motion)),
        _ => natural_time(motion),
    }
}

/// Number of nutation periods in which the tip goes round the centre once, within limits; `None` where the motion does not nutate. Where
/// the precession is very slow it is the least number, in which the tip makes a small part of a turn.
fn periods(motion: &Motion) -> Option<u32> {
    const LEAST: f64 = 3.0;
    const MOST: f64 = 24.0;
    let advance = motion.period_advance().filter(|_| motion.regime() == Regime::Nutating)?;
    let once_round = (TAU / advance.phi_per_period().abs()).ceil();
    Some(if once_round > 4.0 * MOST { LEAST } else { once_round.clamp(LEAST, MOST) } as u32)
}

/// Time until the tip of an aperiodic motion stays at the centre, s.
fn time_to_vertical(motion: &Motion, table: &dyn AnyEphemeris) -> f64 {
    const AT_THE_CENTRE: f64 = 4e-3;
    const MOST: u32 = 4096;
    let one_plus_e1 = motion.branch_points().one_plus_e1;
    let greatest = motion.top().tip_scale() * (one_plus_e1 * (2.0 - one_plus_e1)).sqrt();
    let is_at_rest = |t: &f64| {
        let now = table.at(*t).sample;
        now.udot >= 0.0 && now.tip.modulus() <= AT_THE_CENTRE * greatest
    };
    let step = 0.25 * natural_time(motion);
    (1..MOST).map(|n| step * f64::from(n)).find(is_at_rest).unwrap_or(step)
}

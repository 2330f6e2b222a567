//! Motion over a span of time, for pictures.

use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyEphemeris, furthest_time, smallest_ephemeris};
use crate::motion::propagate::{Sample, natural_time, period};
use crate::output::short;
use std::f64::consts::PI;
use toytop::{Motion, Regime};

/// Motion between two times.
pub struct Span {
    table: Box<dyn AnyEphemeris>,
    /// First and last time, s.
    pub ends: [f64; 2],
    /// Number of nutation periods, where they set the span.
    pub periods: Option<u32>,
    /// Length of a cycle, s; `None` where the axis is at rest.
    cycle: Option<f64>,
}

impl Span {
    /// Span between two times, s. Without them it begins at 0 and is about one turn of the tip around the centre: a whole number of
    /// nutation periods, one turn where u is constant, or the time until the tip of an aperiodic motion is at the centre.
    ///
    /// # Errors
    /// [`Failure::Input`]: times beyond the reach of the ephemeris. [`Failure::Method`]: no ephemeris is large enough.
    pub fn new(motion: &Motion, ends: Option<[f64; 2]>) -> Result<Self, Failure> {
        let furthest = furthest_time(motion);
        if let Some(t) = ends.iter().flatten().find(|t| t.abs() > furthest) {
            return Err(Failure::Input(format!("--times: {t:e} must be within ±{furthest:.1e} s")));
        }
        let table = smallest_ephemeris(Scalar::F64, motion)?;
        let periods = periods(motion).filter(|_| ends.is_none());
        let ends = ends.unwrap_or_else(|| {
            let time = match (periods, motion.regime()) {
                (Some(periods), _) => period(motion) * f64::from(periods),
                (None, Regime::Aperiodic) => rise(motion, &*table),
                _ => turn(motion).unwrap_or_else(|| natural_time(motion)),
            };
            [0.0, time]
        });
        Ok(Self { table, ends, periods, cycle: cycle(motion).map(|(time, _)| time) })
    }

    /// Time from which a chart counts, s: 0, or the first time where the labels of an axis would need more than a few digits.
    pub fn origin(&self) -> f64 {
        const FARTHEST: f64 = 1000.0;
        let [from, until] = self.ends;
        if from.abs() > FARTHEST * (until - from) { from } else { 0.0 }
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
        let cycles = self.cycle.map_or(0.0, |time| (until - from) / time);
        self.times(LEAST.max((IN_A_CYCLE * cycles.ceil()) as u64 + 1))
    }

    /// First and last time as text, with as many digits as distinguish a thousandth of the span.
    pub fn ends_as_text(&self) -> [String; 2] {
        let [from, until] = self.ends;
        let parts = from.abs().max(until.abs()) / (until - from);
        let digits = 4 + parts.log10().clamp(0.0, 13.0).ceil() as usize;
        self.ends.map(|t| short(t, digits))
    }
}

/// Number of nutation periods in which the tip goes round the centre once, within limits; `None` where the motion does not nutate. Where
/// the precession is very slow it is the least number, in which the tip makes a small part of a turn.
fn periods(motion: &Motion) -> Option<u32> {
    const LEAST: f64 = 3.0;
    const MOST: f64 = 24.0;
    let advance = motion.period_advance().filter(|_| motion.regime() == Regime::Nutating)?;
    let once_round = (2.0 * PI / advance.phi_per_period().abs()).ceil();
    Some(if once_round > 4.0 * MOST { LEAST } else { once_round.clamp(LEAST, MOST) } as u32)
}

/// Time until the tip of an aperiodic motion stays at the centre, s.
fn rise(motion: &Motion, table: &dyn AnyEphemeris) -> f64 {
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

/// Mean time in which the axis goes once round the vertical, s; `None` where it does not.
fn turn(motion: &Motion) -> Option<f64> {
    let advance = motion.period_advance()?;
    let rate = advance.phi_per_period().abs() / advance.period;
    (rate > 0.0 && !motion.regime().is_vertical()).then(|| 2.0 * PI / rate)
}

/// Time in which tilt and azimuth of the axis do the same again, s, with its name in the plural: the nutation period; a turn about the
/// vertical where the tilt is constant; the natural time of an aperiodic motion. `None` where the axis is at rest.
fn cycle(motion: &Motion) -> Option<(f64, &'static str)> {
    match motion.regime() {
        Regime::Nutating => Some((period(motion), "nutation periods")),
        Regime::Aperiodic => Some((natural_time(motion), "times 2 pi sqrt((A/p + s)/g)")),
        regime if regime.is_regular_precession() => Some((turn(motion)?, "turns about the vertical")),
        _ => None,
    }
}

/// Refuses times that span more than `most` cycles of a motion, which a picture cannot show; `kind` ends the message.
///
/// # Errors
/// [`Failure::Input`]: the times span more; the message states how long a span may be.
pub fn require_at_most(
    most: u32,
    scenario: &Scenario,
    [from, until]: [f64; 2],
    kind: &str,
) -> Result<(), Failure> {
    let Some((time, name)) = cycle(&scenario.motion) else { return Ok(()) };
    let longest = f64::from(most) * time;
    if until - from <= longest {
        return Ok(());
    }
    let [from, until] = [from, until].map(|t| short(t, 17));
    // rounded down, so that a span of that length is drawn
    let unit = 10_f64.powf(longest.log10().floor() - 3.0);
    let longest = short((longest / unit).floor() * unit, 4) + scenario.units.name(" s");
    Err(Failure::Input(format!(
        "--times: {from}..{until}: must span at most {most} {name} ({longest}){kind}"
    )))
}

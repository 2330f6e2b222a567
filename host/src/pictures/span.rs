//! Motion over a span of time, for pictures.

use crate::Failure;
use crate::input::scenario::Scenario;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, furthest_time, smallest};
use crate::motion::propagate::Sample;
use crate::output::short;
use crate::pictures::cycle::Cycle;
use crate::pictures::plot::Curve;
use toytop::Motion;

/// Motion between two times.
pub(crate) struct Span {
    table: Box<dyn AnyScalar>,
    ends: [f64; 2],
    cycle: Option<Cycle>,
}

impl Span {
    /// Span between two times, s; without them, the time of [`Curve::of`](crate::pictures::plot::Curve::of).
    ///
    /// # Errors
    /// [`Failure::Input`]: times beyond the reach of the ephemeris. [`Failure::Method`]: no ephemeris is large enough.
    pub(crate) fn new(motion: &Motion, ends: Option<[f64; 2]>) -> Result<Self, Failure> {
        let ends = match ends {
            Some(ends) => ends,
            None => [0.0, Curve::of(motion)?.time],
        };
        let furthest = furthest_time(motion);
        if let Some(t) = ends.iter().find(|t| t.abs() > furthest) {
            return Err(Failure::Input(format!("--times: {t:e} must be within ±{furthest:.1e} s")));
        }
        Ok(Self { table: smallest(Scalar::F64, motion)?, ends, cycle: Cycle::of(motion) })
    }

    /// First and last time, s.
    #[must_use]
    pub(crate) fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// Time from which a chart counts, s: 0, or the first time where the labels of an axis would need more than a few digits.
    #[must_use]
    pub(crate) fn origin(&self) -> f64 {
        const FARTHEST: f64 = 1000.0;
        let [from, until] = self.ends;
        if from.abs() > FARTHEST * (until - from) { from } else { 0.0 }
    }

    /// Sample at a time.
    #[must_use]
    pub(crate) fn at(&self, t: f64) -> Sample {
        self.table.at(t).sample
    }

    /// Times of this number, evenly spread, both ends included.
    pub(crate) fn times(&self, count: u64) -> impl Iterator<Item = f64> {
        let [from, until] = self.ends;
        (0..count).map(move |i| from + (until - from) * i as f64 / (count.max(2) - 1) as f64)
    }

    /// Times as [`Self::times`]: at least `least` of them, and at least `per_cycle` in a cycle of the motion, because fewer would
    /// show an alias of the motion.
    pub(crate) fn times_in_cycles(&self, least: u64, per_cycle: u64) -> impl Iterator<Item = f64> {
        let [from, until] = self.ends;
        let cycles = self.cycle.map_or(0.0, |cycle| (until - from) / cycle.time);
        self.times(least.max((per_cycle as f64 * cycles).ceil() as u64 + 1))
    }
}

/// First and last time of a span as text, with as many digits as distinguish a thousandth of it.
pub(crate) fn ends_as_text([from, until]: [f64; 2]) -> [String; 2] {
    let parts = from.abs().max(until.abs()) / (until - from);
    let digits = 4 + parts.log10().clamp(0.0, 13.0).ceil() as usize;
    [from, until].map(|t| short(t, digits))
}

/// Refuses times that span more than `most` cycles of a motion, which a picture cannot show; `kind` ends the message.
///
/// # Errors
/// [`Failure::Input`]: the times span more; the message states how long a span may be.
pub(crate) fn require_at_most(
    most: u32,
    scenario: &Scenario,
    [from, until]: [f64; 2],
    kind: &str,
) -> Result<(), Failure> {
    let Some(cycle) = Cycle::of(&scenario.motion) else { return Ok(()) };
    let longest = f64::from(most) * cycle.time;
    if until - from <= longest {
        return Ok(());
    }
    let [from, until] = [from, until].map(|t| short(t, 17));
    let longest = short(below(longest), 4) + scenario.units.name(" s");
    let name = cycle.name;
    Err(Failure::Input(format!(
        "--times: {from}..{until}: must span at most {most} {name} ({longest}){kind}"
    )))
}

/// Greatest number of four digits that is at most x, for x above 0.
fn below(x: f64) -> f64 {
    let unit = 10_f64.powf(x.log10().floor() - 3.0);
    (x / unit).floor() * unit
}

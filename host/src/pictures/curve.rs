//! Curve of the tip between its bounding circles.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyEphemeris, furthest_time, smallest_ephemeris};
use crate::motion::propagate::{natural_time, period};
use crate::output::short;
use std::f64::consts::TAU;
use toytop::{Motion, Regime, Support};

/// Curve of the tip (of the axis, if the tip is held) and the circles between which it stays.
pub struct Curve {
    /// Points (x, y), m (without unit for a fixed tip).
    pub points: Vec<[f64; 2]>,
    /// Circles at e₁ and e₂, and at u = 0 if that is between them; none where the tip stays at the centre.
    pub circles: Vec<Circle>,
    /// First and last time, s.
    pub ends: [f64; 2],
    /// Number of nutation periods, where they determine the last time.
    pub periods: Option<u32>,
}

/// Circle of radius ρ(u) = s √(1 - u²), a bound on the distance from the centre.
pub struct Circle {
    /// Height of the axis in words, and its tilt.
    pub name: String,
    /// Radius, in the unit of the curve.
    pub radius: f64,
}

impl Curve {
    /// Curve between two times, s. Without them it begins at 0 and is about one turn around the centre: a whole number of nutation
    /// periods, one turn where u is constant, or the time until the tip of an aperiodic motion is at the centre.
    ///
    /// # Errors
    /// [`Failure::Input`]: times beyond the reach of the ephemeris, or too many cycles for a picture. [`Failure::Method`]: no
    /// ephemeris is large enough.
    pub fn new(motion: &Motion, times: Option<[f64; 2]>) -> Result<Self, Failure> {
        let (circles, cycle) = (circles(motion), cycle(motion));
        if let Some(times) = times {
            require_drawable(motion, times, if circles.is_empty() { f64::INFINITY } else { cycle })?;
        }
        let table = smallest_ephemeris(Scalar::F64, motion)?;
        let periods = periods(motion).filter(|_| times.is_none());
        let ends = times.unwrap_or_else(|| match motion.regime() {
            Regime::Aperiodic => [0.0, rise(motion, &*table)],
            _ => [0.0, cycle * periods.map_or(1.0, f64::from)],
        });
        // where the tip does not slide, the curve of the axis is drawn: -2αβ
        let sense = if motion.top().support() == Support::Sliding { 1.0 } else { -1.0 };
        let tip = |t: f64| {
            let c = table.at(t).sample.tip;
            [sense * c.re, sense * c.im]
        };
        // rounding errors of a table are not drawn
        let points =
            if circles.is_empty() { vec![[0.0; 2]] } else { instants(ends, cycle).map(tip).collect() };
        Ok(Self { points, circles, ends, periods })
    }
}

/// Refuses times beyond the reach of the ephemeris, or too many of these cycles.
fn require_drawable(motion: &Motion, [from, until]: [f64; 2], cycle: f64) -> Result<(), Failure> {
    // more would fill the frame
    const MOST_CYCLES: f64 = 1000.0;
    let furthest = furthest_time(motion);
    if let Some(t) = [from, until].iter().find(|t| t.abs() > furthest) {
        return Err(Failure::Input(format!("--times: {t:e} must be within ±{furthest:.1e} s")));
    }
    let longest = MOST_CYCLES * cycle;
    if until - from <= longest {
        return Ok(());
    }
    let [from, until] = [from, until].map(|t| short(t, 17));
    Err(Failure::Input(format!(
        "--times: {from}..{until}: must span at most {} (1000 periods or turns)",
        short(longest, 4)
    )))
}

/// Times of a curve, both ends included: enough in each cycle of the motion that they show no alias of it.
fn instants([from, until]: [f64; 2], cycle: f64) -> impl Iterator<Item = f64> {
    const LEAST: u64 = 1500;
    const IN_A_CYCLE: f64 = 64.0;
    let last = LEAST.max((IN_A_CYCLE * ((until - from) / cycle).ceil()) as u64 + 1) - 1;
    (0..=last).map(move |i| from + (until - from) * i as f64 / last as f64)
}

fn circles(motion: &Motion) -> Vec<Circle> {
    let (e, scale, regime) = (motion.branch_points(), motion.top().tip_scale(), motion.regime());
    let lowest = ("lowest", e.e1, e.one_plus_e1 * (2.0 - e.one_plus_e1));
    let highest = ("highest", e.e2, (2.0 - e.one_minus_e2) * e.one_minus_e2);
    let mut bounds = match regime {
        regime if regime.is_vertical() => vec![],
        regime if regime.is_regular_precession() => vec![("constant", e.e2, highest.2)],
        _ => vec![lowest, highest],
    };
    // between e₁ and e₂ the axis is horizontal, which is the largest circle
    if e.e1 < 0.0 && e.e2 > 0.0 && bounds.len() == 2 {
        bounds.push(("horizontal", 0.0, 1.0));
    }
    let circle = |(place, u, square): (&str, f64, f64)| Circle {
        name: format!("{place}: tilt {:.2}°", u.clamp(-1.0, 1.0).acos().to_degrees()),
        radius: scale * square.sqrt(),
    };
    bounds.into_iter().map(circle).filter(|circle| circle.radius > 0.0).collect()
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

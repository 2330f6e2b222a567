//! Points of the curve of the tip, closer where its curvature is greater.

use crate::Failure;
use crate::motion::Scalar;
use crate::motion::ephemeris::{AnyScalar, smallest};
use crate::motion::propagate::natural_time;
use crate::pictures::bounds::{Bound, Place};
use crate::pictures::cycle::{Cycle, turn};
use std::f64::consts::PI;
use toytop::{Motion, PeriodAdvance, Regime, Support};

/// Curve of the tip (of the axis, if the tip is held) and the circles between which it stays.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Points (x, y), m (without unit for a fixed tip).
    pub points: Vec<[f64; 2]>,
    /// Circles at e₁ and e₂, and at u = 0 if that is between them; none where the tip stays at the centre.
    pub circles: Vec<Circle>,
    /// Time of the first point, s.
    pub start: f64,
    /// Time for which the curve is followed, s.
    pub time: f64,
    /// Number of nutation periods for which the curve is followed; `None` without a period, or for given times.
    pub periods: Option<u32>,
}

/// Circle of radius ρ(e) = s √(1 - e²), a bound on the distance from the centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Radius, in the unit of the curve.
    pub radius: f64,
    /// Bound on the height of the axis.
    pub bound: Bound,
}

/// Least and greatest number of nutation periods of a curve.
const PERIODS: [f64; 2] = [3.0, 24.0];

impl Curve {
    /// Curve over the number of nutation periods in which the tip goes round the centre once, within the limits of
    /// `PERIODS`; over one turn where u is constant; until the tip reaches the centre where the motion is aperiodic.
    ///
    /// # Errors
    /// [`Failure::Method`]: no table fits, even in f32, which is enough for a picture.
    pub fn of(motion: &Motion) -> Result<Self, Failure> {
        Self::between(motion, None)
    }

    /// Curve between two times, s, if they are given; otherwise as [`Curve::of`].
    ///
    /// # Errors
    /// As [`Curve::of`].
    pub fn between(motion: &Motion, asked: Option<[f64; 2]>) -> Result<Self, Failure> {
        let table = smallest(Scalar::F32, motion)?;
        let circles = circles(motion);
        let largest = circles.iter().map(|circle| circle.radius).fold(0.0, f64::max);
        let averages = motion.period_advance().filter(|_| motion.regime() == Regime::Nutating);
        let periods = averages.as_ref().map(periods);
        let (time, parts) = match (&averages, periods) {
            (Some(averages), Some(periods)) => (averages.period * f64::from(periods), periods),
            _ if motion.regime() == Regime::Aperiodic => rise(motion, &*table, largest),
            _ => (turn(motion).unwrap_or_else(|| natural_time(motion)), 1),
        };
        let (span, parts, periods) = match asked {
            Some(span) => (span, parts_between(motion, span), None),
            None => ([0.0, time], parts, periods),
        };
        // where the tip does not slide, the curve of the axis is drawn: -2αβ
        let sense = if motion.top().support() == Support::Sliding { 1.0 } else { -1.0 };
        let tip = |t: f64| {
            let c = table.at(t).sample.tip;
            [sense * c.re, sense * c.im]
        };
        let tracer = Tracer { tip: &tip, tolerance: TOLERANCE * largest };
        // rounding errors of a table are not drawn
        let points = if largest > 0.0 { tracer.trace(span, parts * PARTS) } else { vec![[0.0; 2]] };
        let [start, end] = span;
        Ok(Self { points, circles, start, time: end - start, periods })
    }
}

fn circles(motion: &Motion) -> Vec<Circle> {
    let (e, scale) = (motion.branch_points(), motion.top().tip_scale());
    let mut bounds = Bound::of(motion);
    // between e₁ and e₂ the axis is horizontal, which is the largest circle
    if e.e1 < 0.0 && e.e2 > 0.0 && bounds.len() == 2 {
        bounds.push(Bound { place: Place::Horizontal, u: 0.0 });
    }
    let circle = |bound: Bound| {
        let (one_plus_u, one_minus_u) = match bound.place {
            Place::Lowest => (e.one_plus_e1, 2.0 - e.one_plus_e1),
            Place::Horizontal => (1.0, 1.0),
            Place::Highest | Place::Constant => (2.0 - e.one_minus_e2, e.one_minus_e2),
        };
        Circle { radius: scale * (one_plus_u * one_minus_u).sqrt(), bound }
    };
    bounds.into_iter().map(circle).filter(|circle| circle.radius > 0.0).collect()
}

fn periods(averages: &PeriodAdvance) -> u32 {
    let [least, most] = PERIODS;
    let once_round = (2.0 * PI / averages.phi_per_period().abs()).ceil();
    // where the precession is very slow, the least number of periods is drawn, which is a small part of a turn
    if once_round > 4.0 * most { least as u32 } else { once_round.clamp(least, most) as u32 }
}

/// Number of cycles between two given times, limited to what a picture can show.
fn parts_between(motion: &Motion, [from, until]: [f64; 2]) -> u32 {
    const MOST: f64 = 1000.0;
    Cycle::of(motion).map_or(1, |cycle| ((until - from) / cycle.time).ceil().clamp(1.0, MOST) as u32)
}

/// Time until the tip stays at the centre, s, and the number of parts in which that time is drawn.
fn rise(motion: &Motion, table: &dyn AnyScalar, largest: f64) -> (f64, u32) {
    const AT_THE_CENTRE: f64 = 4e-3;
    const MOST: u32 = 4096;
    let step = 0.25 * natural_time(motion);
    let far = |n: &u32| {
        let c = table.at(step * f64::from(*n)).sample.tip;
        c.norm_squared().sqrt() > AT_THE_CENTRE * largest
    };
    let steps = (0..MOST).rev().find(far).unwrap_or(0) + 1;
    (step * f64::from(steps), steps)
}

/// Number of equal parts of a nutation period, before any is halved.
const PARTS: u32 = 64;
/// Greatest distance of a chord from the curve, in units of the largest radius.
const TOLERANCE: f64 = 2e-4;
/// Greatest number of halvings of a part.
const DEEPEST: u32 = 10;

struct Tracer<'a> {
    tip: &'a dyn Fn(f64) -> [f64; 2],
    tolerance: f64,
}

impl Tracer<'_> {
    fn trace(&self, [begin, end]: [f64; 2], parts: u32) -> Vec<[f64; 2]> {
        let mut points = vec![(self.tip)(begin)];
        let part = (end - begin) / f64::from(parts);
        for i in 0..parts {
            let from = begin + part * f64::from(i);
            let last = points.last().copied().unwrap_or_default();
            self.refine([from, from + part], [last, (self.tip)(from + part)], DEEPEST, &mut points);
        }
        points
    }

    /// Adds the points after the first end, up to the second.
    fn refine(&self, [t0, t1]: [f64; 2], [p0, p1]: [[f64; 2]; 2], depth: u32, points: &mut Vec<[f64; 2]>) {
        let t = 0.5 * (t0 + t1);
        let p = (self.tip)(t);
        let off = (p[0] - 0.5 * (p0[0] + p1[0])).hypot(p[1] - 0.5 * (p0[1] + p1[1]));
        if depth == 0 || off <= self.tolerance {
            points.push(p1);
            return;
        }
        self.refine([t0, t], [p0, p], depth - 1, points);
        self.refine([t, t1], [p, p1], depth - 1, points);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use toytop::{Release, State, Top, TopParameters};

    /// At t = 0 the curve of a sliding top starts opposite to the direction of its axis, and that of a held top starts
    /// at its axis.
    #[test]
    fn tip_and_axis_begin_where_they_are() {
        let release = Release { tilt: 0.4, azimuth: 0.7, spin: 150.0, ..Release::default() };
        let state = State::release(&release).unwrap();
        let [x, y, _] = state.orientation().axis();
        let slid = Top::sliding(&TopParameters {
            transverse_inertia: 3.0e-5,
            axial_inertia: 2.0e-5,
            com_height: 0.03,
            mass: 0.05,
            gravity: 9.81,
            ..TopParameters::default()
        })
        .unwrap();
        let held = Top::fixed(&TopParameters {
            transverse_inertia: 7.5e-5,
            axial_inertia: 2.0e-5,
            mass_moment: 1.5e-3,
            gravity: 9.81,
            ..TopParameters::default()
        })
        .unwrap();
        for (top, scale) in [(slid, -0.03), (held, 1.0)] {
            let curve = Curve::of(&Motion::launch(&top, &state).unwrap()).unwrap();
            let [at_x, at_y] = curve.points[0];
            assert!((at_x - scale * x).hypot(at_y - scale * y) < 1e-6 * scale.abs(), "{at_x} {at_y}");
        }
    }
}

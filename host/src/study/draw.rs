//! Random places of a motion, at which it is held against the truth.

use super::exact::{Exact, Point};
use super::random::Random;
use std::f64::consts::{FRAC_PI_2, PI};
use toytop::real::Float;

/// Points of a nutation: so many anywhere in its first period, and as many close to a turning point, where things go fastest
/// or slowest.
pub(super) fn nutating(exact: &Exact<'_>, count: usize, random: &mut Random) -> Vec<Point> {
    let first = exact.start().chi.to_f64();
    let mut places = Vec::new();
    for _ in 0..count {
        places.push(first + random.between(0.0, PI));
        let turning = ((first + random.between(0.0, PI)) / FRAC_PI_2).round() * FRAC_PI_2;
        let side = if random.one_in(2) { 1.0 } else { -1.0 };
        places.push(turning + side * random.scale(1e-6, 0.3));
    }
    visited(exact, places)
}

/// Points of an aperiodic motion, on the way up or down.
pub(super) fn aperiodic(exact: &Exact<'_>, count: usize, random: &mut Random) -> Vec<Point> {
    let place = |_| 2.0 * (0.5 * random.between(-12.0, 12.0)).tanh().atan();
    visited(exact, (0..count).map(place).collect())
}

/// The points of these places, in order of time.
fn visited(exact: &Exact<'_>, mut places: Vec<f64>) -> Vec<Point> {
    places.sort_by(f64::total_cmp);
    let mut point = exact.start();
    let visit = |place: f64| {
        point = exact.go(&point, place.into());
        point
    };
    places.into_iter().map(visit).collect()
}

//! Ticks of a motion with the truth at each of them.

use std::f64::consts::{FRAC_PI_2, PI};
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::RateSample;
use toytop_host::truth::exact::{Course, Exact, PreciseOrientation};
use toytop_host::truth::precise::{Precise, precise, to_f64, to_floor, to_nearest, whole};

/// Tick with the exact orientation and rates at it.
pub struct Place {
    pub tick: i64,
    pub phi: PreciseOrientation,
    pub rates: RateSample,
}

/// Number of random ticks in the first period, of ticks near a turning point, and of random distant ticks.
const EACH: usize = 4;
/// Binary logarithms of the distant ticks that are moved to the fastest part of a period.
const FAST_POWERS: [u32; 3] = [40, 50, 62];
/// Number of periods that are searched for the tick closest to the fastest part.
const SEARCHED: i64 = 64;

/// Places in the first period, at ticks up to ±2^62, and at the ticks `more`. The number of ticks in a unit of time is a power of two, so that
/// the time of a tick is exact; a motion without a period is given its natural time.
pub fn with_truth(
    exact: &Exact,
    (rate, period): (f64, f64),
    more: &[i64],
    random: &mut Random,
) -> Vec<Place> {
    let mut ticks = more.to_vec();
    for _ in 0..EACH {
        ticks.extend(near(exact, (rate, period), random));
        let size = random.scale(40_f64.exp2(), 62_f64.exp2()) as i64;
        ticks.push(if random.one_in(2) { size } else { -size });
    }
    let distant = FAST_POWERS.iter().flat_map(|power| [1 << power, -(1 << power)]);
    if let Some(period) = exact.period() {
        let (fast, period) = (exact.fastest() * precise(rate), period * precise(rate));
        ticks.extend(to_nearest(&fast));
        ticks.extend(distant.filter_map(|tick| nearest_to_fast(&fast, &period, tick)));
    } else {
        ticks.extend(distant);
    }
    let place = |tick| {
        let t = whole(tick) / precise(rate);
        Place { tick, phi: exact.at(&t), rates: exact.rates(&t, period) }
    };
    ticks.into_iter().map(place).collect()
}

/// Random ticks of the first period: one anywhere, and one close to a turning point, where the motion is fastest or slowest. For an
/// aperiodic motion, a tick on the way up or down.
fn near(exact: &Exact, (rate, period): (f64, f64), random: &mut Random) -> Vec<i64> {
    let at = |half_phase: f64| to_nearest(&(exact.time_of(half_phase) * precise(rate)));
    let anywhere = (random.share() * period * rate) as i64;
    match exact.course() {
        Course::Steady => vec![anywhere],
        Course::Aperiodic => {
            at(2.0 * (0.5 * random.between(-12.0, 12.0)).tanh().atan()).into_iter().collect()
        }
        Course::Nutating => {
            let turning = (random.between(0.0, PI) / FRAC_PI_2).round() * FRAC_PI_2;
            let side = if random.one_in(2) { 1.0 } else { -1.0 };
            [anywhere].into_iter().chain(at(turning + side * random.scale(1e-6, 0.3))).collect()
        }
    }
}

/// Tick that is closest to the fastest part of a period, among the periods after a tick.
fn nearest_to_fast(fast: &Precise, period: &Precise, tick: i64) -> Option<i64> {
    let first = to_floor(&((whole(tick) - fast) / period)).unwrap_or(0);
    let there = |periods: i64| {
        let place = fast + whole(first + periods) * period;
        let nearest = to_nearest(&place)?;
        Some((to_f64(&(whole(nearest) - place)).abs(), nearest))
    };
    let found = (0..SEARCHED).filter_map(there).min_by(|a, b| a.0.total_cmp(&b.0));
    found.map(|(_, nearest)| nearest)
}

//! Input of a launch: branch points or a state, in the allowed range or outside of it; and ticks of its motion with the truth at each.

use std::f64::consts::{FRAC_PI_2, PI};
use toytop::{Release, State, Stepper};
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::RateSample;
use toytop_host::truth::exact::{Exact, MotionKind, PreciseOrientation};
use toytop_host::truth::motions::{Numbers, Start};
use toytop_host::truth::precise::{Precise, precise, to_f64, to_nearest, whole};

/// Least tilt from the vertical that is not 0, rad.
const LEAST_TILT: f64 = 1e-6;

/// Random input near the degenerate cases. Half are branch points; a quarter are states on such motions, in `f64`; a quarter are
/// releases: tilts down to 1e-6 from either vertical, spins from 1e-3 to 1e6 rad/s, and in every second one a top that the paper does
/// not contain.
pub fn random(random: &mut Random) -> Numbers {
    let numbers = Numbers::random(random);
    if random.one_in(2) {
        return numbers;
    }
    let thrown = random.one_in(2);
    let release = release(random);
    let state = if thrown { State::release(&release).ok() } else { on_motion(&numbers) };
    // a release in range, and a point of a motion with valid constants, give a state
    state.map_or(numbers, |state| {
        let top = if thrown { other_top(random, numbers.top) } else { numbers.top };
        Numbers { top, start: Start::from(&state) }
    })
}

/// Random input with one number outside the allowed range.
pub fn beyond(random: &mut Random) -> Numbers {
    let Numbers { mut top, mut start } = self::random(random);
    let far = random.scale(1e3, 1e12);
    let not_finite = if random.one_in(2) { f64::NAN } else { f64::INFINITY };
    match (&mut start, random.between(0.0, 6.0) as u32) {
        (_, 0) => top[0] = 1e-7 / far * top[2] * top[3],
        (_, 1) => top[1] = (2.0 + 1e-3 * far) * top[0],
        (Start::BranchPoints { e, .. }, 2) => e[2] = 1e12 * far,
        (Start::BranchPoints { e, .. }, 3) => e[0] = -1.0 - 1e-15 * far,
        (Start::BranchPoints { e, .. }, 4) => e[1] = 1.0 + 1e-15 * far,
        (Start::BranchPoints { phases, .. }, _) => phases.theta = not_finite,
        (Start::State { omega, .. }, 2) => omega[2] = 1e10 * far,
        (Start::State { phi, .. }, 3) => *phi = phi.map(|z| z.map(|x| (1.0 + 1e-9 * far) * x)),
        (Start::State { .. }, 4) => top[4] = if top[4] > 0.0 { -top[4] } else { f64::NAN },
        (Start::State { omega, .. }, _) => omega[0] = not_finite,
    }
    Numbers { top, start }
}

/// Numbers A, C, s, p, g and K of a top, which in every second draw is one that the paper does not contain: with a rotor inside, held, a
/// rod, a ring, free, or a combination of these.
fn other_top(random: &mut Random, top: [f64; 6]) -> [f64; 6] {
    let [a, c, s, p, g, _] = top;
    if random.one_in(2) {
        return top;
    }
    let c = match random.between(0.0, 4.0) as u32 {
        0 => 0.0,
        1 => 2.0 * a,
        _ => c,
    };
    let rotor = random.scale(1e-6, 1e6) * a * if random.one_in(2) { 1.0 } else { -1.0 };
    let k = if random.one_in(2) { rotor } else { 0.0 };
    match random.between(0.0, 3.0) as u32 {
        0 => [a, c, s, p, g, k],
        1 => [a, c, 0.0, p, g, k],
        _ => [a, c, 0.0, 0.0, 0.0, k],
    }
}

/// State at t = 0 of a motion, rounded to `f64`, which is a state of a slightly different motion.
fn on_motion(numbers: &Numbers) -> Option<State> {
    let attitude = Stepper::<f64>::new(&numbers.motion().ok()?).attitude_state();
    State::new(attitude.orientation, attitude.omega()).ok()
}

fn release(random: &mut Random) -> Release {
    let tilt = match (random.one_in(16), random.one_in(3)) {
        (true, _) => 0.0,
        (false, true) => PI - random.scale(LEAST_TILT, FRAC_PI_2),
        (false, false) => random.scale(LEAST_TILT, FRAC_PI_2),
    };
    let [azimuth, roll] = [(); 2].map(|()| random.between(-PI, PI));
    let mut rate = |one_in_rests: u64, most: f64| match (random.one_in(one_in_rests), random.one_in(2)) {
        (true, _) => 0.0,
        (false, true) => random.scale(1e-3, most),
        (false, false) => -random.scale(1e-3, most),
    };
    let (spin, precession, nutation) = (rate(16, 1e6), rate(3, 1e3), rate(3, 1e3));
    Release { tilt, azimuth, roll, spin, precession, nutation }
}

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
    match exact.kind() {
        MotionKind::Steady => vec![anywhere],
        MotionKind::Aperiodic => {
            at(2.0 * (0.5 * random.between(-12.0, 12.0)).tanh().atan()).into_iter().collect()
        }
        MotionKind::Nutating => {
            let turning = (random.between(0.0, PI) / FRAC_PI_2).round() * FRAC_PI_2;
            let side = if random.one_in(2) { 1.0 } else { -1.0 };
            [anywhere].into_iter().chain(at(turning + side * random.scale(1e-6, 0.3))).collect()
        }
    }
}

/// Tick that is closest to the fastest part of a period, among the periods after a tick.
fn nearest_to_fast(fast: &Precise, period: &Precise, tick: i64) -> Option<i64> {
    let first = to_nearest(&((whole(tick) - fast) / period)).unwrap_or(0);
    let there = |periods: i64| {
        let place = fast + whole(first + periods) * period;
        let nearest = to_nearest(&place)?;
        Some((to_f64(&(whole(nearest) - place)).abs(), nearest))
    };
    let found = (0..SEARCHED).filter_map(there).min_by(|a, b| a.0.total_cmp(&b.0));
    found.map(|(_, nearest)| nearest)
}

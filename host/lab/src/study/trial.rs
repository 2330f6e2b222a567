//! Trial of one motion: both scalars, at random times in the first period and at distant times.

use super::draw::Ticks;
use toytop::{Motion, Regime};
use toytop_host::Failure;
use toytop_host::cli::Scalar;
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::{AnyScalar, RateSample, smallest, ticks_per_time};
use toytop_host::motion::propagate::natural_time;
use toytop_host::truth::exact::{Course, Exact, PreciseOrientation};
use toytop_host::truth::motions::Numbers;

/// Tick with the exact orientation and rates at it.
struct Target {
    tick: i64,
    phi: PreciseOrientation,
    rates: RateSample,
    far: bool,
}

/// Outcome of one scalar for a motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Outcome {
    /// Refusal, because no table is large enough.
    TableTooSmall,
    /// Table with its greatest errors.
    Fits {
        /// Number of segments.
        segments: usize,
        /// Error in the first period.
        near: Worst,
        /// Error at times up to 10^9 periods away; 0 where the motion does not return.
        far: Worst,
        /// Error of the rates at all these times, relative to the greatest angular speed.
        rates: Worst,
    },
}

/// Error with the greatest quotient of error and bound.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Worst {
    /// Error in rad; for rates, relative to the greatest angular speed.
    pub error: f64,
    /// Bound in the same unit.
    pub bound: f64,
    /// Time of the error.
    pub t: f64,
}

impl Worst {
    /// Error with the greatest quotient of error and bound among these.
    fn of(measured: impl Iterator<Item = Self>) -> Self {
        measured
            .fold(Self::default(), |a, b| if b.of_bound() > a.of_bound() || a.bound == 0.0 { b } else { a })
    }

    /// Quotient of error and bound; infinite if the error is no number.
    #[must_use]
    pub(crate) fn of_bound(&self) -> f64 {
        let of_bound = self.error / self.bound;
        match self.bound {
            0.0 => 0.0,
            _ if of_bound.is_nan() => f64::INFINITY,
            _ => of_bound,
        }
    }
}

/// Motion with its outcomes in f64 and f32.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    /// Numbers of the motion.
    pub numbers: Numbers,
    /// Regime of the motion.
    pub regime: Regime,
    /// Outcomes in f64 and in f32.
    pub outcomes: [Outcome; 2],
}

/// Trial of a random motion.
///
/// # Errors
/// [`Failure`]: the motion was refused, which is not expected.
pub(crate) fn run(random: &mut Random) -> Result<Trial, Failure> {
    let numbers = Numbers::random(random);
    let motion = numbers.motion().map_err(|error| Failure::Input(format!("{numbers}: {error}")))?;
    let exact = Exact::new(&numbers);
    let natural_time = natural_time(&motion);
    let ticks = Ticks { exact: &exact, rate: ticks_per_time(&motion), natural_time };
    let targets = targets(&ticks, random);
    let outcomes = [Scalar::F64, Scalar::F32].map(|scalar| outcome(scalar, &motion, &targets));
    Ok(Trial { numbers, regime: motion.regime(), outcomes })
}

fn outcome(scalar: Scalar, motion: &Motion, targets: &[Target]) -> Outcome {
    let Ok(table) = smallest(scalar, motion) else { return Outcome::TableTooSmall };
    let rate = ticks_per_time(motion);
    let worst = |far: bool| {
        let of_kind = targets.iter().filter(|target| target.far == far);
        Worst::of(of_kind.map(|target| measure(&*table, target, rate)))
    };
    let speed = targets.iter().map(|target| target.rates.speed()).fold(f64::MIN_POSITIVE, f64::max);
    let rates = Worst::of(targets.iter().map(|target| measure_rates(&*table, target, speed, rate)));
    Outcome::Fits { segments: table.size()[0], near: worst(false), far: worst(true), rates }
}

fn measure_rates(table: &dyn AnyScalar, target: &Target, speed: f64, ticks_per_time: f64) -> Worst {
    let error = target.rates.distance(&table.rates_at_tick(target.tick));
    let tick = target.tick as f64;
    let bound = table.rate_error_bound().after(tick);
    Worst { error: error / speed, bound: bound / speed, t: tick / ticks_per_time }
}

fn measure(table: &dyn AnyScalar, target: &Target, ticks_per_time: f64) -> Worst {
    let error = target.phi.distance(&table.at_tick(target.tick).orientation);
    let tick = target.tick as f64;
    Worst { error, bound: table.error_bound().after(tick), t: tick / ticks_per_time }
}

/// Number of places of each kind.
const PLACES: usize = 8;
/// Number of periods, or natural times, to the most distant place.
const FURTHEST: f64 = 1e9;

/// Ticks of the first period, and some of them again after up to 10^9 periods.
fn targets(ticks: &Ticks<'_>, random: &mut Random) -> Vec<Target> {
    let near = ticks.near(PLACES, random);
    let far = match ticks.exact.course() {
        Course::Nutating => near.iter().copied().step_by(2).collect(),
        Course::Steady => vec![0],
        Course::Aperiodic => Vec::new(),
    };
    let far = ticks.periods_after(&far, FURTHEST, random);
    let target = |tick: i64, far: bool| Target {
        tick,
        phi: ticks.exact.at(&ticks.time(tick)),
        rates: ticks.rates(tick),
        far,
    };
    near.into_iter()
        .map(|tick| target(tick, false))
        .chain(far.into_iter().map(|tick| target(tick, true)))
        .collect()
}

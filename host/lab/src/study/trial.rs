//! One motion put to the test: both scalars, at random times in the first period and at one far away.

use super::draw::Ticks;
use toytop::{Motion, Regime};
use toytop_host::Failure;
use toytop_host::cli::Scalar;
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::{AnyScalar, RateSample, smallest, ticks_per_time};
use toytop_host::motion::propagate::natural_time;
use toytop_host::truth::exact::{Course, Exact, PreciseOrientation};
use toytop_host::truth::motions::Numbers;

/// A tick, and the truth there.
struct Target {
    tick: i64,
    phi: PreciseOrientation,
    rates: RateSample,
    far: bool,
}

/// What one scalar made of a motion.
#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    /// Typed: no table of the list fits.
    TableTooSmall,
    /// A table of so many segments.
    Fits {
        /// Its segments.
        segments: usize,
        /// In the first period.
        near: Worst,
        /// Up to 10^9 periods away; the least there is where the motion does not return.
        far: Worst,
        /// Rates in both, as shares of the greatest angular speed.
        rates: Worst,
    },
}

/// The error that came closest to its bound, or furthest beyond.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    /// rad; for rates, a share of the greatest angular speed.
    pub error: f64,
    /// In the same unit.
    pub bound: f64,
    /// At this time; in the first period, or after many.
    pub t: f64,
}

impl Worst {
    /// The one that comes closest to its bound.
    fn of(measured: impl Iterator<Item = Self>) -> Self {
        measured.fold(Self::default(), |a, b| if b.strain() > a.strain() || a.bound == 0.0 { b } else { a })
    }

    /// Error over bound; infinite for what is no number.
    #[must_use]
    pub fn strain(&self) -> f64 {
        let strain = self.error / self.bound;
        match self.bound {
            0.0 => 0.0,
            _ if strain.is_nan() => f64::INFINITY,
            _ => strain,
        }
    }
}

/// A motion and its two outcomes, f64 and f32.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The motion.
    pub numbers: Numbers,
    /// Its regime.
    pub regime: Regime,
    /// In f64 and in f32.
    pub outcomes: [Outcome; 2],
}

/// Draws a motion and tries it.
///
/// # Errors
/// [`Failure`]: the motion was refused, which none should be.
pub fn run(random: &mut Random) -> Result<Trial, Failure> {
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

/// Places of each kind.
const PLACES: usize = 8;
/// Periods, or natural times, to the furthest.
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

//! Trial of one launch: its table in each scalar, compared with the truth and with its own bounds.

use super::random_launch;
use toytop::{ParameterError, Regime, TableSettings};
use toytop_host::input::scenario::MotionInput;
use toytop_host::motion::Scalar;
use toytop_host::motion::errors::{greater_or_infinite, rate_error};
use toytop_host::motion::evaluator::{EventKind, EventQuery, MotionEvaluator};
use toytop_host::random::Random;
use toytop_host::reference::float640::{Float640, from_f64, from_i64, to_i64};
use toytop_host::reference::quadrature::Quadrature;
use toytop_model::motion_with_period::MotionWithPeriod;

/// Launch that was tried.
pub struct Trial {
    pub input: MotionInput,
    pub regime: Regime,
    /// Errors of the table in each scalar; `None` where no table is large enough.
    pub tables: [Option<TableErrors>; 4],
}

/// Errors of a table.
#[derive(Clone, Copy, Debug, Default)]
pub struct TableErrors {
    /// Number of ticks that were compared with the truth.
    pub ticks: usize,
    /// Number of these at which more than half of the bound comes from the number of ticks.
    pub distant_ticks: usize,
    /// Greatest error of Φ's norm, and of u at its turning points, over the bound.
    pub norm_over_bound: f64,
    /// Greatest error, rad.
    pub error: f64,
    /// Greatest error over its bound.
    pub error_over_bound: f64,
    /// Greatest error of the rates over its bound.
    pub rate_error_over_bound: f64,
}

impl TableErrors {
    /// Whether an error is beyond its bound.
    pub fn beyond_bound(&self) -> bool {
        self.norm_over_bound.max(self.error_over_bound).max(self.rate_error_over_bound) > 1.0
    }
}

/// Number of times without truth.
const NORM_TIMES: usize = 4;
/// Number of random ticks with truth, each in the first period, near a turning point, and distant.
const RANDOM_TICKS: usize = 4;
/// Binary logarithms of the distant ticks that are moved to a turning point.
const DISTANT_POWERS: [u32; 3] = [40, 50, 62];
/// Number of periods that are searched for the tick closest to a turning point.
const SEARCHED_PERIODS: i64 = 64;
/// Number of ticks of the first period at which the rates are compared with a finer table.
const RATE_TICKS: i64 = 2048;
/// Truncation error of the finer table, far below the rounding of `f64`, rad.
const FINE_TRUNCATION: f64 = 1e-18;

/// Draws the launch of this number and tries it.
///
/// # Errors
/// The refusal of the launch.
pub fn run(seed: u64, number: u64, with_truth: bool) -> Result<Trial, ParameterError> {
    let mut random = Random::new(seed, number);
    let input = random_launch::draw(&mut random);
    let motion = input.motion()?;
    let (period, rate) = (motion.characteristic_time(), motion.ticks_per_time());
    let tables = Scalar::ALL.map(|scalar| MotionEvaluator::new(&motion, scalar).ok());
    let times = [(); NORM_TIMES].map(|()| random.between(0.0, period));
    let mut errors = tables.each_ref().map(|table| {
        let table = table.as_ref()?;
        Some(TableErrors { norm_over_bound: norm_over_bound(table, &times), ..TableErrors::default() })
    });
    if with_truth {
        let truth = Quadrature::new(&input);
        let ticks = ticks(&truth, rate, period, &mut random);
        for tick in ticks.into_iter().chain(most_different_rates(&tables, &motion, period * rate)) {
            let t = from_i64(tick) / from_f64(rate);
            let (orientation, rates) = (truth.at(&t), truth.rates(&t, rate.recip()));
            for (table, errors) in tables.iter().flatten().zip(errors.iter_mut().flatten()) {
                let (bound, rate_bound) = (table.error_bound, table.rate_error_bound);
                let (within, rates_within) = (bound.after(tick as f64), rate_bound.after(tick as f64));
                let sample = table.at_tick(tick);
                let error = orientation.error_of(&sample.orientation);
                let rate_error = rate_error(&sample.rates, &rates);
                errors.ticks += 1;
                errors.distant_ticks += usize::from(within > 2.0 * bound.constant);
                errors.error = greater_or_infinite(errors.error, error);
                errors.error_over_bound = greater_or_infinite(errors.error_over_bound, ratio(error, within));
                errors.rate_error_over_bound =
                    greater_or_infinite(errors.rate_error_over_bound, ratio(rate_error, rates_within));
            }
        }
    }
    Ok(Trial { input, regime: motion.regime(), tables: errors })
}

/// Error over its bound. A body at rest has rates without error, and 0 as their bound.
fn ratio(error: f64, bound: f64) -> f64 {
    if error == 0.0 { 0.0 } else { error / bound }
}

/// Greatest error of the norm at these times, and of u at both turning points, over the bound.
fn norm_over_bound(table: &MotionEvaluator, times: &[f64]) -> f64 {
    let motion = &table.motion;
    let e = motion.branch_points();
    let query = EventQuery { kind: EventKind::Turning, from: 0.0, upward: None, count: 2 };
    let turning = table.events(&query).unwrap_or_default();
    let turning = turning.into_iter().map(|event| (event.sample.t, if event.upward { e.e2 } else { e.e1 }));
    let turning = turning.filter(|_| motion.regime() == Regime::Nutating);
    let norms = times.iter().map(|&t| (t, table.orientation(t).norm_squared() - 1.0));
    let heights = turning.map(|(t, u)| (t, table.orientation(t).u() - u));
    let of_bound =
        |(t, error): (f64, f64)| ratio(error.abs(), table.error_bound.after(t * table.ticks_per_time));
    norms.chain(heights).map(of_bound).fold(0.0, greater_or_infinite)
}

/// Ticks in the first period and up to ±2^62. The number of ticks in a unit of time is a power of two, so that the time of a tick is
/// exact; a motion without a period is given its natural time.
fn ticks(truth: &Quadrature, rate: f64, period: f64, random: &mut Random) -> Vec<i64> {
    let time_of = |tangent: f64| truth.time_of(tangent) * from_f64(rate);
    let mut ticks = Vec::new();
    for _ in 0..RANDOM_TICKS {
        ticks.push((random.uniform() * period * rate) as i64);
        let tangent = random.sign() * random.log_uniform(1e-6, 1e6);
        ticks.extend(to_i64(&time_of(tangent)));
        let distant = random.sign() * random.log_uniform(40_f64.exp2(), 62_f64.exp2());
        ticks.push(distant as i64);
    }
    for (sense, tangent) in [(1, 0.0), (-1, 1e30)] {
        for tick in DISTANT_POWERS.map(|power| sense << power) {
            match truth.period() {
                Some(period) => ticks.extend(nearest(tick, &time_of(tangent), &(period * from_f64(rate)))),
                None => ticks.push(tick),
            }
        }
    }
    ticks
}

/// Tick that is closest to a place of a period, among the periods after a tick. Place and period are in ticks.
fn nearest(tick: i64, place: &Float640, period: &Float640) -> Option<i64> {
    let first = to_i64(&((from_i64(tick) - place) / period))?;
    let places = (first..first + SEARCHED_PERIODS).map(|number| place + period * number);
    let closest = places.min_by_key(|place| {
        let apart = place - place.round();
        if apart < from_i64(0) { -apart } else { apart }
    });
    closest.and_then(|place| to_i64(&place))
}

/// For each scalar, the tick of the first period at which its rates differ most from a finer table.
fn most_different_rates(
    tables: &[Option<MotionEvaluator>],
    motion: &MotionWithPeriod,
    period: f64,
) -> Vec<i64> {
    let settings = TableSettings { truncation: Some(FINE_TRUNCATION), ..TableSettings::new(motion.tick()) };
    let finer = MotionEvaluator::with_settings(motion, Scalar::F64, &settings);
    let Ok(finer) = finer else { return Vec::new() };
    let tick = |place: i64| (period * place as f64 / RATE_TICKS as f64) as i64;
    let fine: Vec<_> = (0..RATE_TICKS).map(tick).map(|tick| (tick, finer.at_tick(tick).rates)).collect();
    let most = |table: &MotionEvaluator| {
        let apart = fine.iter().map(|(tick, rates)| (*tick, rate_error(&table.at_tick(*tick).rates, rates)));
        apart.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(tick, _)| tick)
    };
    tables.iter().flatten().filter_map(most).collect()
}

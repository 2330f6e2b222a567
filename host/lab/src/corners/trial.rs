//! Trial of one launch: its table in each scalar, compared with the truth and with its own bounds.

use super::inputs::{self, Place};
use toytop::{Motion, ParameterError, Regime};
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::{AnyEphemeris, approximate, smallest, ticks_per_time};
use toytop_host::motion::propagate::period;
use toytop_host::motion::{Scalar, greater};
use toytop_host::truth::exact::Exact;
use toytop_host::truth::motions::Numbers;

/// Counts and greatest errors of the tables of one scalar.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    /// Number of motions.
    pub motions: u64,
    /// Number of motions for which no table is large enough.
    pub no_table: u64,
    /// Number of motions that were compared with the truth.
    pub truths: u64,
    /// Number of these whose greatest error is at least a hundredth of its bound.
    pub close: u64,
    /// Number of these whose greatest error of the rates is at least a hundredth of its bound.
    pub rates_close: u64,
    /// Number of ticks at which they were compared.
    pub places: u64,
    /// Number of these at which more than half of the bound comes from the number of ticks.
    pub places_by_ticks: u64,
    /// Greatest error of Φ's norm, and of u at its turning points, as a share of the bound.
    pub norm_and_height: f64,
    /// Greatest error, rad.
    pub error: f64,
    /// Greatest error as a share of its bound.
    pub of_bound: f64,
    /// Greatest error of the rates as a share of its bound.
    pub rates_of_bound: f64,
    /// Number of motions with an error beyond its bound.
    pub beyond_bound: u64,
}

/// Least share of the bound for an error that counts as close to it.
const CLOSE: f64 = 0.01;
/// Number of random times without truth.
const TIMES: usize = 4;
/// Truncation error far below the rounding of `f64`, rad.
const FINE: f64 = 1e-18;

impl Errors {
    /// Adds the errors of other motions.
    pub fn add(&mut self, other: &Self) {
        self.motions += other.motions;
        self.no_table += other.no_table;
        self.truths += other.truths;
        self.close += other.close;
        self.rates_close += other.rates_close;
        self.places += other.places;
        self.places_by_ticks += other.places_by_ticks;
        self.norm_and_height = self.norm_and_height.max(other.norm_and_height);
        self.error = self.error.max(other.error);
        self.of_bound = self.of_bound.max(other.of_bound);
        self.rates_of_bound = self.rates_of_bound.max(other.rates_of_bound);
        self.beyond_bound += other.beyond_bound;
    }
}

/// Regime of a launch and the errors of its table in each scalar, compared with the truth if `with_truth`.
///
/// # Errors
/// The refusal of the launch.
pub fn run(
    input: &Numbers,
    random: &mut Random,
    with_truth: bool,
) -> Result<(Regime, [Errors; 4]), ParameterError> {
    let motion = input.motion()?;
    let period = period(&motion);
    let tables = Scalar::ALL.map(|scalar| smallest(scalar, &motion).ok());
    let times = [(); TIMES].map(|()| random.between(0.0, period));
    let rate = ticks_per_time(&motion);
    let places = if with_truth {
        let doubtful = doubtful(&tables, &motion, period, rate);
        inputs::with_truth(&Exact::new(input), (rate, period), &doubtful, random)
    } else {
        Vec::new()
    };
    let errors = tables.map(|table| match table {
        None => Errors { motions: 1, no_table: 1, ..Errors::default() },
        Some(table) => {
            let norm_and_height = norm_and_height(&*table, &motion, &times, (rate, period));
            Errors { norm_and_height, ..against(&*table, &places) }.judged(!places.is_empty())
        }
    });
    Ok((motion.regime(), errors))
}

/// Greatest error of the norm at these times, and of u at both turning points, as a share of the bound.
fn norm_and_height(
    table: &dyn AnyEphemeris,
    motion: &Motion,
    times: &[f64],
    (rate, period): (f64, f64),
) -> f64 {
    let start = table.at(0.0).nutation_phase.to_f64();
    let e = motion.branch_points();
    let turning = [(1.0, e.e1), (0.5, e.e2)].map(|(phase, u)| ((phase - start) * period, u));
    let turning = turning.into_iter().filter(|_| motion.regime() == Regime::Nutating);
    let norms = times.iter().map(|&t| (t, table.at(t).sample.orientation().norm_squared() - 1.0));
    let heights = turning.map(|(t, u)| (t, table.at(t).sample.orientation().u() - u));
    let share = |(t, error): (f64, f64)| error.abs() / table.error_bound().after(t * rate);
    norms.chain(heights).map(share).fold(0.0, greater)
}

/// Errors of a table at these places.
fn against(table: &dyn AnyEphemeris, places: &[Place]) -> Errors {
    let (bound, rate_bound) = (table.error_bound(), table.rate_error_bound());
    let mut errors = Errors::default();
    for Place { tick, phi, rates } in places {
        let within = bound.after(*tick as f64);
        let error = phi.distance(&table.at_tick(*tick, 0.0).sample.orientation());
        let rate_error = rates.distance(&table.rates_at_tick(*tick)) / rate_bound.after(*tick as f64);
        errors.places += 1;
        errors.places_by_ticks += u64::from(within > 2.0 * bound.constant);
        errors.error = greater(errors.error, error);
        errors.of_bound = greater(errors.of_bound, error / within);
        errors.rates_of_bound = greater(errors.rates_of_bound, rate_error);
    }
    errors
}

impl Errors {
    /// Errors of one motion, counted.
    fn judged(self, with_truth: bool) -> Self {
        let greatest = self.norm_and_height.max(self.of_bound).max(self.rates_of_bound);
        Self {
            motions: 1,
            truths: u64::from(with_truth),
            close: u64::from(self.of_bound >= CLOSE),
            rates_close: u64::from(self.rates_of_bound >= CLOSE),
            beyond_bound: u64::from(greatest > 1.0),
            ..self
        }
    }
}

/// For each scalar, the tick of the first period at which its rates differ most from those of a finer table.
fn doubtful(
    tables: &[Option<Box<dyn AnyEphemeris>>; 4],
    motion: &Motion,
    period: f64,
    rate: f64,
) -> Vec<i64> {
    const COMPARED: i64 = 2048;
    let Ok(finer) = approximate(motion, FINE) else { return Vec::new() };
    let tick = |place: i64| (period * rate * place as f64 / COMPARED as f64) as i64;
    let fine: Vec<_> = (0..COMPARED).map(tick).map(|tick| (tick, finer.rates_at_tick(tick))).collect();
    let most = |table: &dyn AnyEphemeris| {
        let apart = fine.iter().map(|(tick, rates)| (*tick, table.rates_at_tick(*tick).distance(rates)));
        apart.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(tick, _)| tick)
    };
    tables.iter().flatten().filter_map(|table| most(table.as_ref())).collect()
}

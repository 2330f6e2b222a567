//! Trial of one input.

use super::input::Input;
use super::reading::{Reading, SCALARS, finer, readings};
use crate::study::draw::Ticks;
use toytop::{Motion, ParameterError, Regime, Top};
use toytop_host::input::random::Random;
use toytop_host::motion::ephemeris::{AnyScalar, RateSample, ticks_for};
use toytop_host::motion::invariants::first_integrals;
use toytop_host::motion::propagate::natural_time;
use toytop_host::truth::exact::PreciseOrientation;

/// Tick with the exact orientation and rates at it.
struct Target {
    tick: i64,
    phi: PreciseOrientation,
    rates: RateSample,
    /// Change of Φ by the last place of the input, rad; only computed in the first period.
    sensitivity: Option<f64>,
}

/// Results of one scalar for an input.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Kept {
    /// Greatest error of Φ's norm, and of u at its turning points, as a share of the bound.
    pub checks_of_bound: f64,
    /// Greatest change of l and n in units of max(A, C) |ω| + |K|, and of h in units of this times |ω|, plus p g.
    pub drift: f64,
    /// Errors against the truth, where it was computed.
    pub error: Option<Error>,
}

/// Greatest errors over all places.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Error {
    /// Greatest error, rad.
    pub error: f64,
    /// Greatest error in units of the bound.
    pub of_bound: f64,
    /// Tick at which the error is greatest in units of the bound.
    pub tick: i64,
    /// Greatest error in the first period, in units of a rounding of the scalar plus the change by the last place of the input.
    pub of_condition: f64,
    /// Greatest error of the rates, as a share of the greatest angular speed.
    pub rates: f64,
    /// Greatest error of the rates, in units of their bound.
    pub rates_of_bound: f64,
    /// Tick at which the error of the rates is greatest in units of their bound.
    pub rates_tick: i64,
    /// Number of places, and number of those at which more than half of the bound comes from the number of ticks.
    pub places: [u64; 2],
}

/// Outcome of an input.
#[derive(Clone, Debug)]
pub(crate) enum Outcome {
    /// Refusal of a launch.
    Refused(ParameterError),
    /// Motion with the results of each scalar; `None` where no table is large enough.
    Moves {
        /// Regime of the motion.
        regime: Regime,
        /// Results in the order of [`SCALARS`].
        kept: Box<[Option<Kept>; 4]>,
        /// Greatest change of Φ by the last place of the input, rad, where it was computed.
        sensitivity: Option<f64>,
    },
}

/// Outcome of an input, compared with the truth if `with_truth`.
#[must_use]
pub(crate) fn run(input: &Input, random: &mut Random, with_truth: bool) -> Outcome {
    let motion = match input.motion() {
        Ok(motion) => motion,
        Err(error) => return Outcome::Refused(error),
    };
    let averages = motion.period_advance().filter(|_| motion.regime() == Regime::Nutating);
    let period = averages.map_or_else(|| natural_time(&motion), |averages| averages.period);
    // f32 and fixed point have mean rates of 64 bits
    let for_f32 = input.motion_for_f32().unwrap_or(motion);
    let readings = readings([&motion, &for_f32], period);
    let targets = with_truth.then(|| {
        let rate = ticks_for(&motion, period);
        let doubtful = finer(&motion, period).map(|finer| doubtful(&readings, &*finer, period * rate));
        targets(input, &motion, rate, &doubtful.unwrap_or_default(), random)
    });
    let checks = Checks::new(&motion, period, averages.is_some(), random);
    let kept = |(reading, (_, rounding)): (&Option<Reading>, (&str, f64))| {
        reading.as_ref().map(|reading| Kept {
            checks_of_bound: checks.checks_of_bound(reading),
            drift: checks.drift(reading),
            error: targets.as_ref().map(|targets| error(reading, targets, rounding)),
        })
    };
    let [a, b, c, d] = &readings;
    let [first, second, third, fourth] = SCALARS;
    Outcome::Moves {
        regime: motion.regime(),
        kept: Box::new([(a, first), (b, second), (c, third), (d, fourth)].map(kept)),
        sensitivity: targets
            .map(|targets| targets.iter().filter_map(|target| target.sensitivity).fold(0.0, f64::max)),
    }
}

/// Ticks at which the rates of a table are compared with those of a finer one.
const COMPARED: i64 = 2048;

/// For each scalar, the tick of the first period, `ticks` long, at which its rates differ most from those of a finer
/// table.
fn doubtful(readings: &[Option<Reading>; 4], finer: &dyn AnyScalar, ticks: f64) -> Vec<i64> {
    let place = |place: i64| (ticks * place as f64 / COMPARED as f64) as i64;
    let fine: Vec<_> = (0..COMPARED).map(place).map(|tick| (tick, finer.rates_at_tick(tick))).collect();
    let most = |reading: &Reading| {
        let apart = fine.iter().map(|(tick, rates)| (*tick, reading.rates_at_tick(*tick).distance(rates)));
        apart.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(tick, _)| tick)
    };
    readings.iter().flatten().filter_map(most).collect()
}

fn error(reading: &Reading, targets: &[Target], rounding: f64) -> Error {
    let speed = targets.iter().map(|target| target.rates.speed()).fold(f64::MIN_POSITIVE, f64::max);
    targets.iter().fold(Error::default(), |worst, target| {
        let rates = target.rates.distance(&reading.rates_at_tick(target.tick));
        let rates_of_bound = rates / reading.rate_bound_at(target.tick);
        let error = target.phi.distance(&reading.at_tick(target.tick));
        // an error that is no number exceeds every bound
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let condition = target.sensitivity.map_or(0.0, |sensitivity| error / (rounding + sensitivity));
        let [places, by_ticks] = worst.places;
        let of_bound = error / reading.bound_at(target.tick);
        Error {
            error: worst.error.max(error),
            of_bound: worst.of_bound.max(of_bound),
            tick: if of_bound > worst.of_bound { target.tick } else { worst.tick },
            of_condition: worst.of_condition.max(condition),
            rates: worst.rates.max(rates / speed),
            rates_of_bound: worst.rates_of_bound.max(rates_of_bound),
            rates_tick: if rates_of_bound > worst.rates_of_bound { target.tick } else { worst.rates_tick },
            places: [places + 1, by_ticks + u64::from(reading.counts_ticks(target.tick))],
        }
    })
}

/// Checks without the truth: unit norm, u at the turning points, energy and momenta.
struct Checks {
    top: Top,
    /// Random times in the first period.
    times: Vec<f64>,
    /// Nutation period with e₁ and e₂; `None` where there is no period.
    turning: Option<(f64, [f64; 2])>,
}

impl Checks {
    fn new(motion: &Motion, period: f64, turns: bool, random: &mut Random) -> Self {
        let times = (0..PLACES).map(|_| random.between(0.0, period)).collect();
        let e = motion.branch_points();
        Self { top: *motion.top(), times, turning: turns.then_some((period, [e.e1, e.e2])) }
    }

    fn checks_of_bound(&self, reading: &Reading) -> f64 {
        let norms = self.times.iter().map(|&t| (t, reading.at(t).phi.norm_squared() - 1.0));
        let ends = self.turning.into_iter().flat_map(|(period, [e1, e2])| {
            [(1.0, e1), (0.5, e2)].map(|(phase, u)| ((phase - reading.phase()) * period, u))
        });
        let heights = ends.map(|(t, u)| (t, reading.at(t).phi.u() - u));
        norms.chain(heights).fold(0.0, |worst, (t, off)| {
            let checks_of_bound = off.abs() / reading.bound(t);
            if checks_of_bound.is_nan() { f64::INFINITY } else { checks_of_bound.max(worst) }
        })
    }

    fn drift(&self, reading: &Reading) -> f64 {
        let mut first: Option<[f64; 3]> = None;
        let (mut worst, mut greatest) = (0.0_f64, 0.0_f64);
        for &t in &self.times {
            let seen = reading.at(t);
            let Some(omega) = seen.omega else { return 0.0 };
            let now = first_integrals(&self.top, seen.phi.alpha, seen.phi.beta, omega);
            let then = *first.get_or_insert(now);
            // a rounded angular velocity may be 0 at one of the times
            greatest = greatest.max(omega.iter().map(|x| x * x).sum::<f64>().sqrt());
            let momentum = self.top.transverse_inertia().max(self.top.axial_inertia()) * greatest
                + self.top.rotor_momentum().abs();
            let energy = momentum * greatest + self.top.mass_moment() * self.top.gravity();
            let shares = [momentum, momentum, energy];
            for ((now, then), share) in now.iter().zip(then).zip(shares) {
                let drift = (now - then).abs() / share.max(f64::MIN_POSITIVE);
                worst = worst.max(if drift.is_nan() { f64::INFINITY } else { drift });
            }
        }
        worst
    }
}

/// Number of random places in the first period, of places near a turning point, and of random distant places.
const PLACES: usize = 4;
/// Number of changed inputs, of which the greatest change counts.
const NEIGHBOURS: usize = 2;

fn targets(input: &Input, motion: &Motion, rate: f64, doubtful: &[i64], random: &mut Random) -> Vec<Target> {
    let exact = input.exact();
    let ticks = Ticks { exact: &exact, rate, natural_time: natural_time(motion) };
    let mut near = ticks.near(PLACES, random);
    near.extend(ticks.fast());
    let neighbours = [(); NEIGHBOURS].map(|()| input.neighbour(random).exact());
    let near = near.into_iter().map(|tick| {
        let t = ticks.time(tick);
        let phi = exact.at(&t);
        let moved = neighbours.iter().map(|neighbour| neighbour.at(&t).apart(&phi));
        let sensitivity = Some(moved.filter(|moved| moved.is_finite()).fold(0.0, f64::max));
        Target { tick, phi, rates: ticks.rates(tick), sensitivity }
    });
    let near: Vec<_> = near.collect();
    let others = ticks.far(PLACES, random).into_iter().chain(doubtful.iter().copied());
    let others = others.map(|tick| {
        let (phi, rates) = (exact.at(&ticks.time(tick)), ticks.rates(tick));
        Target { tick, phi, rates, sensitivity: None }
    });
    near.into_iter().chain(others).collect()
}

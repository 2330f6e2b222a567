//! One input put to the test.

use super::input::Input;
use super::reading::{Reading, SCALARS, readings};
use crate::invariants::first_integrals;
use crate::propagate::natural_time;
use crate::study::draw;
use crate::study::exact::{Course, Exact, Point};
use crate::study::gauss::Rule;
use crate::study::random::Random;
use crate::study::trial::{apart, distance};
use std::f64::consts::{FRAC_PI_2, PI};
use toytop::real::{DoubleDouble, Float};
use toytop::{LaunchError, Motion, Phi, Regime, Top};

/// A time in the first period, the truth there, and what the last place of the input does to it, rad.
struct Target {
    t: f64,
    phi: Phi<DoubleDouble>,
    sensitivity: f64,
}

/// What one scalar made of an input.
#[derive(Clone, Copy, Debug, Default)]
pub struct Kept {
    /// What of Φ's norm and of u at its turning points is beyond the bound, as a share of it.
    pub strain: f64,
    /// The greatest change of l and n as a share of what they are made of, and of h.
    pub drift: f64,
    /// Against the truth, where it was asked.
    pub error: Option<Error>,
}

/// The greatest of each over the places.
#[derive(Clone, Copy, Debug, Default)]
pub struct Error {
    /// rad.
    pub error: f64,
    /// In units of the bound.
    pub of_bound: f64,
    /// In units of a rounding of the scalar and what one of the input does.
    pub of_condition: f64,
}

/// What became of an input.
#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    /// No motion.
    Refused(LaunchError),
    /// A motion, and what each scalar made of it; `None`: no table fits.
    Moves {
        /// Its regime.
        regime: Regime,
        /// By scalar, in the order of [`SCALARS`].
        kept: [Option<Kept>; 4],
        /// The greatest change of Φ that the last place of the input makes, rad, where it was asked.
        sensitivity: Option<f64>,
    },
}

/// Tries an input, against the truth if `rule` is there.
#[must_use]
pub fn run(input: &Input, random: &mut Random, rule: Option<&Rule>) -> Outcome {
    let motion = match input.motion() {
        Ok(motion) => motion,
        Err(error) => return Outcome::Refused(error),
    };
    let averages = motion.averages().filter(|_| motion.regime() == Regime::Nutating);
    let period = averages.map_or_else(|| natural_time(motion.top()), |averages| averages.period);
    let readings = readings(&motion, period);
    let targets = rule.map(|rule| targets(input, &motion, rule, random));
    let checks = Checks::new(&motion, period, averages.is_some(), random);
    let kept = |(reading, (_, rounding)): (&Option<Reading>, (&str, f64))| {
        reading.as_ref().map(|reading| Kept {
            strain: checks.strain(reading),
            drift: checks.drift(reading),
            error: targets.as_ref().map(|targets| error(reading, targets, rounding)),
        })
    };
    let [a, b, c, d] = &readings;
    let [first, second, third, fourth] = SCALARS;
    Outcome::Moves {
        regime: motion.regime(),
        kept: [(a, first), (b, second), (c, third), (d, fourth)].map(kept),
        sensitivity: targets.map(|targets| targets.iter().fold(0.0, |most, now| now.sensitivity.max(most))),
    }
}

fn error(reading: &Reading, targets: &[Target], rounding: f64) -> Error {
    targets.iter().fold(Error::default(), |worst, target| {
        let error = distance(&reading.at(target.t).phi, &target.phi);
        // what is no number is beyond every bound
        let error = if error.is_nan() { f64::INFINITY } else { error };
        Error {
            error: worst.error.max(error),
            of_bound: worst.of_bound.max(error / reading.bound(target.t)),
            of_condition: worst.of_condition.max(error / (rounding + target.sensitivity)),
        }
    })
}

/// What needs no truth: unit norm, u at the turning points, energy and momenta.
struct Checks {
    top: Top,
    /// Anywhere in the first period.
    times: Vec<f64>,
    /// The nutation period with e₁ and e₂, where there is one.
    turning: Option<(f64, [f64; 2])>,
}

impl Checks {
    fn new(motion: &Motion, period: f64, turns: bool, random: &mut Random) -> Self {
        let times = (0..PLACES).map(|_| random.between(0.0, period)).collect();
        let e = motion.branch_points();
        Self { top: *motion.top(), times, turning: turns.then_some((period, [e.e1, e.e2])) }
    }

    fn strain(&self, reading: &Reading) -> f64 {
        let norms = self.times.iter().map(|&t| (t, reading.at(t).phi.norm_squared() - 1.0));
        let ends = self.turning.into_iter().flat_map(|(period, [e1, e2])| {
            [(1.0, e1), (0.5, e2)].map(|(phase, u)| ((phase - reading.phase()) * period, u))
        });
        let heights = ends.map(|(t, u)| (t, reading.at(t).phi.u() - u));
        norms.chain(heights).fold(0.0, |worst, (t, off)| {
            let strain = off.abs() / reading.bound(t);
            if strain.is_nan() { f64::INFINITY } else { strain.max(worst) }
        })
    }

    fn drift(&self, reading: &Reading) -> f64 {
        let mut first: Option<[f64; 3]> = None;
        let mut worst = 0.0_f64;
        for &t in &self.times {
            let seen = reading.at(t);
            let Some(omega) = seen.omega else { return 0.0 };
            let now = first_integrals(&self.top, seen.phi.alpha, seen.phi.beta, omega);
            let then = *first.get_or_insert(now);
            let size = omega.iter().map(|x| x * x).sum::<f64>().sqrt();
            let momentum = self.top.a().max(self.top.c()) * size;
            let energy = momentum * size + self.top.p() * self.top.g();
            let shares = [momentum, momentum, energy];
            for ((now, then), share) in now.iter().zip(then).zip(shares) {
                let drift = (now - then).abs() / share.max(f64::MIN_POSITIVE);
                worst = worst.max(if drift.is_nan() { f64::INFINITY } else { drift });
            }
        }
        worst
    }
}

/// Places of each kind.
const PLACES: usize = 4;
/// Neighbours that the sensitivity is the greatest of.
const NEIGHBOURS: usize = 2;

fn targets(input: &Input, motion: &Motion, rule: &Rule, random: &mut Random) -> Vec<Target> {
    let exact = input.exact(rule);
    let points = points(&exact, motion, random);
    let mut targets: Vec<_> = points
        .iter()
        .map(|point| {
            let t = point.t.to_f64();
            Target { t, phi: at(&exact, point, t), sensitivity: 0.0 }
        })
        .collect();
    for _ in 0..NEIGHBOURS {
        let neighbour = input.neighbour(random).exact(rule);
        let mut point = neighbour.start();
        for target in &mut targets {
            point = follow(&neighbour, &point, target.t);
            let moved = apart(&at(&neighbour, &point, target.t), &target.phi);
            if moved.is_finite() {
                target.sensitivity = target.sensitivity.max(moved);
            }
        }
    }
    targets
}

/// In order of time.
fn points(exact: &Exact<'_>, motion: &Motion, random: &mut Random) -> Vec<Point> {
    match exact.course() {
        Course::Steady => {
            let mut times = [(); PLACES].map(|()| random.between(0.0, natural_time(motion.top())));
            times.sort_by(f64::total_cmp);
            times.map(|t| exact.start().resting_until(t)).into()
        }
        Course::Aperiodic => draw::aperiodic(exact, PLACES, random),
        Course::Nutating => draw::nutating(exact, PLACES, random),
    }
}

fn at(exact: &Exact<'_>, point: &Point, t: f64) -> Phi<DoubleDouble> {
    if exact.course() == Course::Steady {
        let [one_plus_u, one_minus_u] = exact.at_e2();
        exact.steady_phi(t, one_plus_u, one_minus_u)
    } else {
        exact.phi(point, t)
    }
}

fn follow(exact: &Exact<'_>, from: &Point, t: f64) -> Point {
    let bracket = match exact.course() {
        Course::Steady => return *from,
        Course::Aperiodic => [-FRAC_PI_2, FRAC_PI_2],
        Course::Nutating => [from.chi.to_f64() - 2.0 * PI, from.chi.to_f64() + 2.0 * PI],
    };
    exact.seek(from, t, bracket)
}

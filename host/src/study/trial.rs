//! One motion put to the test: both scalars, at random times in the first period and at one far away.

use super::draw;
use super::exact::{Course, Exact, Point};
use super::gauss::Rule;
use super::motions::Numbers;
use super::random::Random;
use crate::Failure;
use crate::cli::Scalar;
use crate::ephemeris::{AnySize, smallest, ticks_per_time};
use crate::propagate::natural_time;
use toytop::real::{DoubleDouble, Float};
use toytop::{Complex, Motion, Phi, Regime};

/// A time, and the truth there.
struct Target {
    t: f64,
    phi: Phi<DoubleDouble>,
    far: bool,
}

/// What one scalar made of a motion.
#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    /// Typed: no table of the list fits.
    NoFit,
    /// A table of so many segments.
    Fits {
        /// Its segments.
        segments: usize,
        /// In the first period.
        near: Worst,
        /// Up to 10^9 periods away; the least there is where the motion does not return.
        far: Worst,
    },
}

/// The error that came closest to its bound, or furthest beyond.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    /// rad.
    pub error: f64,
    /// rad.
    pub bound: f64,
    /// At this time; in the first period, or after many.
    pub t: f64,
}

impl Worst {
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
pub fn run(random: &mut Random, rule: &Rule) -> Result<Trial, Failure> {
    let numbers = Numbers::random(random);
    let motion = numbers.motion().map_err(|error| Failure::Input(format!("{numbers}: {error}")))?;
    let exact = Exact::new(&numbers, rule);
    let targets = targets(&motion, &exact, random);
    let outcomes = [Scalar::F64, Scalar::F32].map(|scalar| outcome(scalar, &motion, &targets));
    Ok(Trial { numbers, regime: motion.regime(), outcomes })
}

fn outcome(scalar: Scalar, motion: &Motion, targets: &[Target]) -> Outcome {
    let Ok(table) = smallest(scalar, motion) else { return Outcome::NoFit };
    let rate = ticks_per_time(motion);
    let worst = |far: bool| {
        let of_kind = targets.iter().filter(|target| target.far == far);
        let measured = of_kind.map(|target| measure(&*table, target, rate));
        measured.fold(Worst::default(), |a, b| if b.strain() > a.strain() || a.bound == 0.0 { b } else { a })
    };
    Outcome::Fits { segments: table.size()[0], near: worst(false), far: worst(true) }
}

fn measure(table: &dyn AnySize, target: &Target, ticks_per_time: f64) -> Worst {
    let error = distance(&table.at(target.t).sample.orientation(), &target.phi);
    Worst { error, bound: table.error_bound().after(target.t * ticks_per_time), t: target.t }
}

/// 2 √(|Δα|² + |Δβ|²), rad, without the rounding of the truth.
pub(crate) fn distance(found: &Phi<f64>, truth: &Phi<DoubleDouble>) -> f64 {
    apart(&lifted(found), truth)
}

fn lifted(phi: &Phi<f64>) -> Phi<DoubleDouble> {
    let lift = |z: Complex<f64>| Complex::new(z.re.into(), z.im.into());
    Phi { alpha: lift(phi.alpha), beta: lift(phi.beta) }
}

/// The same of two truths.
pub(crate) fn apart(a: &Phi<DoubleDouble>, b: &Phi<DoubleDouble>) -> f64 {
    2.0 * ((a.alpha - b.alpha).norm_squared() + (a.beta - b.beta).norm_squared()).to_f64().sqrt()
}

fn targets(motion: &Motion, exact: &Exact<'_>, random: &mut Random) -> Vec<Target> {
    match exact.course() {
        Course::Nutating => nutating(exact, random),
        Course::Aperiodic => {
            let points = draw::aperiodic(exact, PLACES, random);
            points.iter().map(|point| near(exact, point)).collect()
        }
        Course::Steady => {
            let [one_plus_u, one_minus_u] = exact.at_e2();
            let time = natural_time(motion.top());
            let times =
                [time, time, time, time * random.scale(1.0, 1e9)].map(|most| random.between(0.0, most));
            let target = |(i, t): (usize, f64)| {
                let phi = exact.steady_phi(t, one_plus_u, one_minus_u);
                Target { t, phi, far: i == 3 }
            };
            times.into_iter().enumerate().map(target).collect()
        }
    }
}

/// Places of each kind.
const PLACES: usize = 8;

/// Points of the first period, and some of them again after up to 10^9 periods.
fn nutating(exact: &Exact<'_>, random: &mut Random) -> Vec<Target> {
    let points = draw::nutating(exact, PLACES, random);
    let near = points.iter().map(|point| near(exact, point));
    let period = exact.period();
    let far = points.iter().step_by(2).map(|base| {
        let later = exact.later(base, &period, random.scale(1.0, 1e9).round());
        let t = later.t.to_f64();
        let point = exact.at_time(&later, base.chi, t);
        Target { t, phi: exact.phi(&point, t), far: true }
    });
    near.chain(far).collect()
}

fn near(exact: &Exact<'_>, point: &Point) -> Target {
    let t = point.t.to_f64();
    Target { t, phi: exact.phi(point, t), far: false }
}

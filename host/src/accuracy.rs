//! Errors of the ephemeris in each scalar at ticks 1 to 2^40, against the truth to thirty digits.
//!
//! The motions are the built-in ones that nutate and whose tip slides, launched at u = e₁ from numbers that are taken as exact. The number
//! of ticks in a unit of time is a power of two, with at least a thousand ticks in a period and one in a radian, so that tick 2^40 comes
//! after some 10^9 periods.

use crate::Failure;
use crate::input::builtin;
use crate::input::random::Random;
use crate::motion::ephemeris::{AnyEphemeris, smallest, ticks_per_time};
use crate::motion::{Scalar, greater};
use crate::motion::{first_integrals, natural_scales};
use crate::output::progress::Progress;
use crate::thread_pool;
use crate::truth::exact::{Exact, PreciseOrientation};
use crate::truth::motions::{Numbers, Start};
use crate::truth::precise::{precise, whole};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use toytop::{InitialPhases, Motion, Regime, Support};

/// Binary logarithm of the last tick.
pub const OCTAVES: u32 = 40;

/// Number of ticks in each octave that are evaluated for each motion.
const SAMPLES: u64 = 16;

/// Errors over many ticks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Greatest orientation error 2 √(|Δα|² + |Δβ|²), rad.
    pub angle: f64,
    /// Sum of the squares of the orientation errors, rad², and their number.
    squares: (f64, u64),
    /// Greatest error of the tip, |Δc|/s.
    pub tip: f64,
    /// Greatest error of the norm, ||α|² + |β|² - 1|.
    pub norm: f64,
    /// Greatest error of h as computed from α, β and their rates, in units of its natural scale.
    pub energy: f64,
}

impl Errors {
    /// Root of the mean square of the orientation errors, rad.
    pub fn rms(&self) -> f64 {
        let (sum, count) = self.squares;
        (sum / count.max(1) as f64).sqrt()
    }

    fn and(self, other: Self) -> Self {
        let ((sum, count), (more, others)) = (self.squares, other.squares);
        Self {
            angle: greater(self.angle, other.angle),
            squares: (sum + more, count + others),
            tip: greater(self.tip, other.tip),
            norm: greater(self.norm, other.norm),
            energy: greater(self.energy, other.energy),
        }
    }
}

/// Errors of one scalar.
pub struct Accuracy {
    /// Scalar of the ephemeris.
    pub scalar: Scalar,
    /// Errors over the ticks from 2^k to 2^(k+1) - 1 for each k below `OCTAVES`, and at tick 2^40.
    pub octaves: Vec<Errors>,
}

impl Accuracy {
    /// Errors over all ticks.
    pub fn all(&self) -> Errors {
        self.octaves.iter().fold(Errors::default(), |all, &octave| all.and(octave))
    }
}

/// Errors of each of the scalars over all motions.
///
/// # Errors
/// None: the motions are valid, and their tables are large enough.
pub fn measured(scalars: &[Scalar]) -> Result<Vec<Accuracy>, Failure> {
    let motions = motions()?;
    let progress = Progress::new(motions.len() as u64, "motions");
    let of_motion = |numbers: &Numbers| on(numbers, scalars).inspect(|_| progress.add(1));
    // in the order of the motions, so that sums do not depend on the order in which threads finish
    let found: Vec<Vec<Vec<Errors>>> = thread_pool::of_all_cores()?
        .install(|| motions.par_iter().map(of_motion).collect::<Result<_, Failure>>())?;
    let nothing = || vec![Errors::default(); OCTAVES as usize + 1];
    let together = |(index, &scalar): (usize, &Scalar)| {
        let add = |mut sums: Vec<Errors>, motion: &Vec<Vec<Errors>>| {
            sums.iter_mut().zip(&motion[index]).for_each(|(sum, errors)| *sum = sum.and(*errors));
            sums
        };
        Accuracy { scalar, octaves: found.iter().fold(nothing(), add) }
    };
    Ok(scalars.iter().enumerate().map(together).collect())
}

/// Numbers of the built-in motions that [`Exact`] can compute.
fn motions() -> Result<Vec<Numbers>, Failure> {
    let numbers = |motion: Motion| {
        let (top, e) = (motion.top(), motion.branch_points());
        let known = motion.regime() == Regime::Nutating && top.support() == Support::Sliding;
        let (a, c) = (top.transverse_inertia(), top.axial_inertia());
        let phases = InitialPhases::default();
        known.then(|| Numbers {
            top: [a, c, top.com_height(), top.mass_moment(), top.gravity(), 0.0],
            start: Start::BranchPoints { e: [e.e1, e.e2, e.e3], signs: motion.signs(), phases },
        })
    };
    Ok(builtin::scenarios().into_iter().filter_map(|scenario| numbers(scenario.motion)).collect())
}

/// Errors of each scalar on a motion, by octave.
fn on(numbers: &Numbers, scalars: &[Scalar]) -> Result<Vec<Vec<Errors>>, Failure> {
    let motion = numbers.motion().map_err(|error| Failure::Input(format!("{numbers}: {error}")))?;
    let tables = scalars.iter().map(|&scalar| smallest(scalar, &motion)).collect::<Result<Vec<_>, _>>()?;
    let truth = Exact::new(numbers);
    let rate = ticks_per_time(&motion);
    let mut random = Random::new(1, 0);
    let mut found = vec![Vec::new(); scalars.len()];
    for octave in 0..=OCTAVES {
        let first = 1_u64 << octave;
        let mut tick = |_| {
            let more = if octave < OCTAVES { random.share() * first as f64 } else { 0.0 };
            let n = first + more as u64;
            // this quotient is exact, because the rate is a power of two
            let t = n as f64 / rate;
            (n as i64, t, truth.at(&(whole(n as i64) / precise(rate))))
        };
        let truths: Vec<_> = (0..SAMPLES.min(first)).map(&mut tick).collect();
        for (table, octaves) in tables.iter().zip(&mut found) {
            let errors = truths.iter().map(|(n, t, phi)| {
                let errors = orientation(&**table, (*n, *t), phi);
                Errors { energy: energy(&motion, &**table, *t), ..errors }
            });
            octaves.push(errors.fold(Errors::default(), Errors::and));
        }
    }
    Ok(found)
}

fn orientation(table: &dyn AnyEphemeris, (n, t): (i64, f64), truth: &PreciseOrientation) -> Errors {
    let found = table.at_tick(n, t);
    let orientation = found.sample.orientation();
    let angle = truth.distance(&orientation);
    let truth = truth.to_f64();
    let tip = found.tip_over_s - (truth.alpha * truth.beta).scaled(2.0);
    Errors {
        angle,
        squares: (angle * angle, 1),
        tip: tip.norm_squared().sqrt(),
        norm: (orientation.norm_squared() - 1.0).abs(),
        energy: 0.0,
    }
}

fn energy(motion: &Motion, table: &dyn AnyEphemeris, t: f64) -> f64 {
    let instant = table.at(t);
    let phi = instant.sample.orientation();
    let [.., h] = first_integrals(motion.top(), &phi, instant.rate.omega_fixed(&phi));
    let [.., scale] = natural_scales(motion);
    (h - motion.first_integrals().h).abs() / scale
}
